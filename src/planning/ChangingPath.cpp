#include "ChangingPath.h"

#include "ompl_certificates/team/PathTimes.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

    namespace
    {
        /** A change must lower the cost by that part of the whole path's: many tiny gains would fill the path with
            corners. */
        constexpr double LEAST_GAIN = 1e-5;

        /** How many motions of robots are measured between two looks at the condition: a fraction of a millisecond */
        constexpr std::size_t MOTIONS_BETWEEN_LOOKS = 256;
    }

    bool isBetterBy(double gain, const ob::OptimizationObjective &objective, ob::Cost cost, ob::Cost old)
    {
        return objective.isCostBetterThan(cost, old) && std::abs(cost.value() - old.value()) > gain;
    }

    ChangingPath::ChangingPath(const ob::SpaceInformation &si, const ob::OptimizationObjective &objective,
                               const Team &team, ompl::RNG &random, const og::PathGeometric &path,
                               const ob::PlannerTerminationCondition &condition)
      : si_(si)
      , objective_(objective)
      , team_(team)
      , random_(random)
      , condition_(condition)
      , paths_(team_, path)
      , before_(si_.allocState())
      , after_(si_.allocState())
      , samplers_(team_.getRobotCount())
    {
    }

    ChangingPath::~ChangingPath()
    {
        si_.freeState(before_);
        si_.freeState(after_);
    }

    bool ChangingPath::paceAll()
    {
        bool isBetter = false;
        for (const Pace pace : {EVEN, FAST})
        {
            if (isOver())
                return isBetter;
            std::vector<Change> changes;
            for (unsigned int robot = 0; robot < team_.getRobotCount(); ++robot)
                changes.push_back({robot, paced(pace, robot, 0.0, paths_.getDuration())});
            isBetter = accept(std::move(changes), 0.0, paths_.getDuration()) || isBetter;
        }
        if (isBetter)
            return true;
        for (unsigned int robot = 0; robot < team_.getRobotCount() && !isOver(); ++robot)
            isBetter = takeShortcut(robot, 0.0, paths_.getDuration()) ||
                       accept({{robot, paced(EVEN, robot, 0.0, paths_.getDuration())}}, 0.0, paths_.getDuration()) ||
                       isBetter;
        return isBetter;
    }

    bool ChangingPath::tryOne()
    {
        const unsigned int robot = pickRobot();
        const double choice = random_.uniform01();
        if (choice < 0.4)
            return moveCorner(robot);
        const auto [first, last] = interval(robot);
        if (choice < 0.6)
            return accept({{robot, paced(choice < 0.5 ? EVEN : FAST, robot, first, last)}}, first, last);
        if (choice < 0.9)
            return takeShortcut(robot, first, last);
        return takeTeamShortcut(first, last);
    }

    og::PathGeometric ChangingPath::getPath(const ob::SpaceInformationPtr &si, bool &hasLeftOut) const
    {
        og::PathGeometric path(si);
        hasLeftOut = paths_.hasLeftOut();
        const std::vector<double> times = paths_.timesWithin(0.0, paths_.getDuration());
        for (std::size_t i = 0; i < times.size(); ++i)
        {
            paths_.copyTo(times[i], before_);
            // Two robots' knots may differ in time by no more than its rounding. The end is kept as it is.
            const bool moves =
                path.getStateCount() == 0 || motionTime(*si->getStateSpace(), path.getStates().back(), before_) > 0.0;
            if (moves || (i + 1 == times.size() && path.getStateCount() == 1))
                path.append(before_);
            else
            {
                hasLeftOut = true;
                if (i + 1 == times.size())
                    si->copyState(path.getStates().back(), before_);
            }
        }
        return path;
    }

    std::size_t ChangingPath::pick(std::size_t count)
    {
        return static_cast<std::size_t>(random_.uniformInt(0, static_cast<int>(count) - 1));
    }

    unsigned int ChangingPath::pickRobot()
    {
        return static_cast<unsigned int>(pick(team_.getRobotCount()));
    }

    std::pair<double, double> ChangingPath::interval(unsigned int robot)
    {
        // Times that are corners already make no new ones.
        const auto time = [&]
        {
            const double choice = random_.uniform01();
            if (choice < 0.1)
                return random_.uniformReal(0.0, paths_.getDuration());
            const auto other = choice < 0.5 ? robot : pickRobot();
            return paths_.getKnots(other)[pick(paths_.getKnots(other).size())].time;
        };
        const double a = time(), b = time();
        return {std::min(a, b), std::max(a, b)};
    }

    ChangingPath::Knots ChangingPath::replaced(unsigned int robot, double first, double last, const Knots &middle) const
    {
        const Knots &knots = paths_.getKnots(robot);
        Knots result;
        std::copy_if(knots.begin(), knots.end(), std::back_inserter(result),
                     [first](const Knot &knot) { return knot.time < first; });
        result.push_back(paths_.at(robot, first));
        result.insert(result.end(), middle.begin(), middle.end());
        result.push_back(paths_.at(robot, last));
        std::copy_if(knots.begin(), knots.end(), std::back_inserter(result),
                     [last](const Knot &knot) { return knot.time > last; });
        return result;
    }

    ChangingPath::Knots ChangingPath::paced(Pace pace, unsigned int robot, double first, double last) const
    {
        const ob::StateSpace &space = team_.getRobotSpace(robot);
        const double speed = speedOf(*si_.getStateSpace(), robot);
        const auto timeOf = [&](const Knot &from, const Knot &to)
        { return space.distance(from.state.get(), to.state.get()) / speed; };
        Knots middle;
        double time = 0.0;  // at full speed
        Knot previous = paths_.at(robot, first);
        for (const Knot &knot : paths_.getKnots(robot))
            if (knot.time > first && knot.time < last)
                if (const double step = timeOf(previous, knot); step > 0.0)
                {
                    time += step;
                    middle.push_back({time, knot.state});
                    previous = knot;
                }
        const Knot end = paths_.at(robot, last);
        time += timeOf(previous, end);
        const auto isAtEnd = [&](const Knot &knot) { return !(knot.time < time); };
        middle.erase(std::find_if(middle.begin(), middle.end(), isAtEnd), middle.end());
        const double duration = pace == EVEN ? last - first : std::min(time, last - first);
        for (Knot &knot : middle)
            knot.time = first + duration * (knot.time / time);
        if (duration < last - first)
            middle.push_back({first + duration, end.state});
        return replaced(robot, first, last, middle);
    }

    bool ChangingPath::takeShortcut(unsigned int robot, double first, double last)
    {
        return first < last && accept({{robot, replaced(robot, first, last, {})}}, first, last);
    }

    bool ChangingPath::takeTeamShortcut(double first, double last)
    {
        if (!(first < last))
            return false;
        std::vector<Change> changes;
        for (unsigned int robot = 0; robot < team_.getRobotCount(); ++robot)
            changes.push_back({robot, replaced(robot, first, last, {})});
        return accept(std::move(changes), first, last);
    }

    bool ChangingPath::moveCorner(unsigned int robot)
    {
        const Knots &knots = paths_.getKnots(robot);
        if (knots.size() < 3)
            return false;
        const std::size_t index = 1 + pick(knots.size() - 2);
        const Knot &previous = knots[index - 1], &next = knots[index + 1];
        const ob::StateSpace &space = team_.getRobotSpace(robot);
        const double scale = std::pow(10.0, random_.uniformReal(-4.0, 0.0));
        const double distance = scale * (space.distance(previous.state.get(), knots[index].state.get()) +
                                         space.distance(knots[index].state.get(), next.state.get()));
        Knots moved = knots;
        moved[index].state = paths_.clone(robot, knots[index].state.get());
        if (!samplers_[robot])
            samplers_[robot] = space.allocStateSampler();
        // Ways that are curves, such as cars', may leave the bounds, where OMPL's samplers do not work.
        const auto center = paths_.clone(robot, knots[index].state.get());
        space.enforceBounds(center.get());
        samplers_[robot]->sampleUniformNear(moved[index].state.get(), center.get(), distance);
        return accept({{robot, std::move(moved)}}, previous.time, next.time);
    }

    double ChangingPath::lengthOf(unsigned int robot, const Knots &knots) const
    {
        const ob::StateSpace &space = team_.getRobotSpace(robot);
        double length = 0.0;
        for (std::size_t i = 1; i < knots.size(); ++i)
            length += space.distance(knots[i - 1].state.get(), knots[i].state.get());
        return length;
    }

    bool ChangingPath::areShorter(const std::vector<Change> &changes) const
    {
        double length = 0.0, old = 0.0;
        for (const Change &change : changes)
        {
            length += lengthOf(change.robot, paths_.getKnots(change.robot));
            old += lengthOf(change.robot, change.knots);
        }
        return length < (1.0 - LEAST_GAIN) * old;
    }

    bool ChangingPath::accept(std::vector<Change> changes, double first, double last)
    {
        double begin = paths_.knotBefore(first), end = paths_.knotAfter(last);
        // From its own knot before to its new one a robot may go by another curve than on the way to its next one.
        for (const Change &change : changes)
        {
            begin = std::min(begin, paths_.knotBefore(change.robot, first));
            end = std::max(end, paths_.knotAfter(change.robot, last));
        }
        const bool isWhole = begin == 0.0 && end == paths_.getDuration();
        const auto old = isWhole && whole_ ? whole_ : cost(begin, end);
        if (!old)
            return false;
        const auto exchange = [&]
        {
            for (Change &change : changes)
                change.knots = paths_.exchange(change.robot, std::move(change.knots));
        };
        exchange();
        const auto changed = cost(begin, end);
        if (isWhole)
            leastGain_ = LEAST_GAIN * std::abs(old->value());
        const bool isBetter = changed && (isBetterBy(leastGain_, objective_, *changed, *old) ||
                                          (!objective_.isCostBetterThan(*old, *changed) && areShorter(changes)));
        if (isBetter && isValid(begin, end))
        {
            whole_ = isWhole ? changed : std::nullopt;
            return true;
        }
        exchange();
        if (isWhole)
            whole_ = old;
        return false;
    }

    template <typename Visitor>
    bool ChangingPath::visitMotions(double begin, double end, const Visitor &visit)
    {
        const std::vector<double> times = paths_.timesWithin(begin, end);
        paths_.copyTo(times.front(), before_);
        for (std::size_t i = 1; i < times.size(); ++i)
        {
            paths_.copyTo(times[i], after_);
            if (!visit(before_, after_))
                return false;
            std::swap(before_, after_);
        }
        return true;
    }

    bool ChangingPath::isOver()
    {
        return isOver_ = isOver_ || condition_;
    }

    std::optional<ob::Cost> ChangingPath::cost(double begin, double end)
    {
        ob::Cost sum = objective_.identityCost();
        const bool isKnown = visitMotions(begin, end,
                                          [&](const ob::State *from, const ob::State *to)
                                          {
                                              unseen_ += team_.getRobotCount();
                                              if (unseen_ >= MOTIONS_BETWEEN_LOOKS)
                                              {
                                                  unseen_ = 0;
                                                  if (isOver())
                                                      return false;
                                              }
                                              sum = objective_.combineCosts(sum, objective_.motionCost(from, to));
                                              return true;
                                          });
        return isKnown ? std::optional(sum) : std::nullopt;
    }

    bool ChangingPath::isValid(double begin, double end)
    {
        return visitMotions(begin, end,
                            [this](const ob::State *from, const ob::State *to)
                            { return !isOver() && si_.checkMotion(from, to); });
    }
}
