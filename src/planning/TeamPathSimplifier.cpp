#include "ompl_certificates/planning/TeamPathSimplifier.h"

#include "TimedPaths.h"

#include "ompl_certificates/team/PathTimes.h"
#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

    namespace
    {
        /** A change must lower the cost by that part of the whole path's: many tiny gains would fill the path with
            corners. */
        constexpr double LEAST_GAIN = 1e-5;

        /** A path is good enough when that many attempts for each corner lower its cost by less than that part. */
        constexpr std::uint64_t ATTEMPTS_PER_CORNER = 20;
        constexpr double LEAST_PROGRESS = 1e-3;

        /** Whether a cost is better than an old one, and differs from it by more than \e gain */
        bool isBetterBy(double gain, const ob::OptimizationObjective &objective, ob::Cost cost, ob::Cost old)
        {
            return objective.isCostBetterThan(cost, old) && std::abs(cost.value() - old.value()) > gain;
        }

        /** A motion of a smaller part of a path's time is one of rounding. */
        constexpr double LEAST_TIME = 1e-10;

        /** How many motions of robots are measured between two looks at the condition: a fraction of a millisecond */
        constexpr std::size_t MOTIONS_BETWEEN_LOOKS = 256;

        /** \e path, which is valid, without states that are those before them but for rounding; its ends are kept.
            Where the slightly other motion is not valid, they stay. */
        og::PathGeometric withoutRepeats(const og::PathGeometric &path)
        {
            const ob::SpaceInformationPtr &si = path.getSpaceInformation();
            const double least = LEAST_TIME * stateTimes(path).back();
            std::vector<const ob::State *> kept{path.getState(0)};
            const std::size_t last = path.getStateCount() - 1;
            std::size_t skipped = 0;
            for (std::size_t i = 1; i <= last; ++i)
            {
                const ob::State *state = path.getState(static_cast<unsigned int>(i));
                const bool moves = motionTime(*si->getStateSpace(), kept.back(), state) > least;
                if (!moves && i < last)
                {
                    ++skipped;
                    continue;
                }
                // The end takes the place of a state that it repeats.
                const bool isInPlace = !moves && kept.size() > 1;
                const ob::State *previous = isInPlace ? kept[kept.size() - 2] : kept.back();
                const bool isAsBefore = moves && skipped == 0;
                if (!isAsBefore && !si->checkMotion(previous, state))
                    for (std::size_t k = i - skipped; k < i; ++k)
                        kept.push_back(path.getState(static_cast<unsigned int>(k)));
                else if (isInPlace)
                    kept.pop_back();
                kept.push_back(state);
                skipped = 0;
            }
            og::PathGeometric result(si);
            for (const ob::State *state : kept)
                result.append(state);
            return result;
        }

        /** The team of a checker, which may read other spaces, too; else that of the space */
        Team teamOf(const ob::SpaceInformation &si)
        {
            if (const auto *checker = dynamic_cast<const TeamValidityChecker *>(si.getStateValidityChecker().get()))
                return checker->getTeam();
            if (const auto *validator = dynamic_cast<const CertificateMotionValidator *>(si.getMotionValidator().get()))
                return validator->getChecker().getTeam();
            return Team(si.getStateSpace());
        }
    }

    /** A path, and the changes that are tried on it */
    class TeamPathSimplifier::ChangingPath
    {
    public:
        ChangingPath(TeamPathSimplifier &simplifier, const og::PathGeometric &path,
                     const ob::PlannerTerminationCondition &condition)
          : si_(*simplifier.si_)
          , objective_(*simplifier.objective_)
          , team_(simplifier.team_)
          , random_(simplifier.random_)
          , condition_(condition)
          , paths_(team_, path)
          , before_(si_.allocState())
          , after_(si_.allocState())
        {
        }

        ~ChangingPath()
        {
            si_.freeState(before_);
            si_.freeState(after_);
        }

        ChangingPath(const ChangingPath &) = delete;
        ChangingPath &operator=(const ChangingPath &) = delete;

        /** Let all robots move at even paces from start to end, or as fast as they can; if not all, then one by one */
        bool paceAll()
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
                isBetter =
                    takeShortcut(robot, 0.0, paths_.getDuration()) ||
                    accept({{robot, paced(EVEN, robot, 0.0, paths_.getDuration())}}, 0.0, paths_.getDuration()) ||
                    isBetter;
            return isBetter;
        }

        /** A change at random */
        bool tryOne()
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

        /** \param hasLeftOut becomes true if a motion of the path may be one that was not checked */
        og::PathGeometric getPath(const ob::SpaceInformationPtr &si, bool &hasLeftOut) const
        {
            og::PathGeometric path(si);
            hasLeftOut = paths_.hasLeftOut();
            const std::vector<double> times = paths_.timesWithin(0.0, paths_.getDuration());
            for (std::size_t i = 0; i < times.size(); ++i)
            {
                paths_.copyTo(times[i], before_);
                // Two robots' knots may differ in time by no more than its rounding. The end is kept as it is.
                const bool moves = path.getStateCount() == 0 ||
                                   motionTime(*si->getStateSpace(), path.getStates().back(), before_) > 0.0;
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

    private:
        using Knot = TimedPaths::Knot;
        using Knots = std::vector<Knot>;

        /** How a robot goes its way between two times: as slowly as it may, or at full speed and then it waits */
        enum Pace
        {
            EVEN,
            FAST
        };

        /** New knots of a robot */
        struct Change
        {
            unsigned int robot;
            Knots knots;
        };

        std::size_t pick(std::size_t count)
        {
            return static_cast<std::size_t>(random_.uniformInt(0, static_cast<int>(count) - 1));
        }

        unsigned int pickRobot()
        {
            return static_cast<unsigned int>(pick(team_.getRobotCount()));
        }

        /** Part of the path: from corner to corner of a robot's way, or between any two times */
        std::pair<double, double> interval(unsigned int robot)
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

        /** The knots of a robot with others between two times */
        Knots replaced(unsigned int robot, double first, double last, const Knots &middle) const
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

        /** The knots of a robot that goes the same way between two times at another pace */
        Knots paced(Pace pace, unsigned int robot, double first, double last) const
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

        bool takeShortcut(unsigned int robot, double first, double last)
        {
            return first < last && accept({{robot, replaced(robot, first, last, {})}}, first, last);
        }

        bool takeTeamShortcut(double first, double last)
        {
            if (!(first < last))
                return false;
            std::vector<Change> changes;
            for (unsigned int robot = 0; robot < team_.getRobotCount(); ++robot)
                changes.push_back({robot, replaced(robot, first, last, {})});
            return accept(std::move(changes), first, last);
        }

        /** Move a corner of a robot's way to a state near it, at the same time */
        bool moveCorner(unsigned int robot)
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

        /** How long the way of a robot is through some knots, by its space's distance */
        double lengthOf(unsigned int robot, const Knots &knots) const
        {
            const ob::StateSpace &space = team_.getRobotSpace(robot);
            double length = 0.0;
            for (std::size_t i = 1; i < knots.size(); ++i)
                length += space.distance(knots[i - 1].state.get(), knots[i].state.get());
            return length;
        }

        /** Whether the robots of \e changes, which have the knots that they had before, have shorter ways now */
        bool areShorter(const std::vector<Change> &changes) const
        {
            double length = 0.0, old = 0.0;
            for (const Change &change : changes)
            {
                length += lengthOf(change.robot, paths_.getKnots(change.robot));
                old += lengthOf(change.robot, change.knots);
            }
            return length < (1.0 - LEAST_GAIN) * old;
        }

        /** Change paths if that lowers the cost, or makes ways shorter at the same cost, and the motions between two
            times are valid */
        bool accept(std::vector<Change> changes, double first, double last)
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

        /** Call \e visit with the ends of each motion between two knots, until it returns false */
        template <typename Visitor>
        bool visitMotions(double begin, double end, const Visitor &visit)
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

        /** Whether the time for changes is over. Once it is, it stays so. */
        bool isOver()
        {
            return isOver_ = isOver_ || condition_;
        }

        /** Nothing if the time is over before the cost is known: paths of large teams have thousands of motions. */
        std::optional<ob::Cost> cost(double begin, double end)
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

        bool isValid(double begin, double end)
        {
            return visitMotions(begin, end,
                                [this](const ob::State *from, const ob::State *to)
                                { return !isOver() && si_.checkMotion(from, to); });
        }

        const ob::SpaceInformation &si_;
        const ob::OptimizationObjective &objective_;
        const Team &team_;
        ompl::RNG &random_;
        const ob::PlannerTerminationCondition &condition_;
        bool isOver_{false};

        /** Motions of robots that were measured since the last look at the condition */
        std::size_t unseen_{0};

        /** By how much a change must lower the cost at least. Known from the first change of the whole path on, which
            is the first of all. */
        double leastGain_{0.0};

        /** The cost of the whole path, if it is known: many changes are tried on it in a row. */
        std::optional<ob::Cost> whole_;
        TimedPaths paths_;
        mutable ob::State *before_, *after_;
        std::vector<ob::StateSamplerPtr> samplers_{team_.getRobotCount()};
    };

    TeamPathSimplifier::TeamPathSimplifier(ob::SpaceInformationPtr si, ob::OptimizationObjectivePtr objective)
      : si_(std::move(si)), objective_(std::move(objective)), team_(teamOf(*si_))
    {
    }

    bool TeamPathSimplifier::simplify(og::PathGeometric &path, std::uint64_t attempts,
                                      const ob::PlannerTerminationCondition &condition)
    {
        if (path.getStateCount() < 2)
            return false;
        ChangingPath changing(*this, path, condition);
        bool isSimpler = changing.paceAll();
        for (; attempts > 0 && !condition; --attempts)
            isSimpler = changing.tryOne() || isSimpler;
        if (!isSimpler)
            return false;
        bool hasLeftOut = false;
        og::PathGeometric simpler = withoutRepeats(changing.getPath(si_, hasLeftOut));
        if (hasLeftOut && !simpler.check())
            return false;
        path = simpler;
        return true;
    }

    bool TeamPathSimplifier::simplify(og::PathGeometric &path, const ob::PlannerTerminationCondition &condition)
    {
        const ob::Cost first = path.cost(objective_);
        ob::Cost cost = first;
        while (!condition)
        {
            simplify(path, ATTEMPTS_PER_CORNER * path.getStateCount() * team_.getRobotCount(), condition);
            const ob::Cost before = std::exchange(cost, path.cost(objective_));
            if (!isBetterBy(LEAST_PROGRESS * std::abs(before.value()), *objective_, cost, before))
                break;
        }
        return objective_->isCostBetterThan(cost, first);
    }
}
