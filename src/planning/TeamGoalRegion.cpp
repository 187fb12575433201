#include "ompl_certificates/planning/TeamGoalRegion.h"

#include "ompl_certificates/team/TeamStateSpace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** How many states of a robot's goal are tried for one of the team's */
        constexpr unsigned int TRIES = 20;

        /** How often the robots are placed anew, those that found no room first */
        constexpr unsigned int MOST_ROUNDS = 20;

        /** One of so many samples is the state that is known. */
        constexpr unsigned int KNOWN_STATE_PERIOD = 10;
    }

    TeamGoalRegion::TeamGoalRegion(const ob::SpaceInformationPtr &si, const ob::ScopedState<> &state,
                                   std::vector<RobotGoalPtr> goals)
      : GoalSampleableRegion(si)
      , checker_(std::dynamic_pointer_cast<const TeamValidityChecker>(si->getStateValidityChecker()))
      , state_(state)
      , goals_(std::move(goals))
    {
        const std::string owner = "TeamGoalRegion";
        if (!checker_)
            throw ompl::Exception(owner, "needs a TeamValidityChecker, and is not for plans by controls");
        const auto *team = dynamic_cast<const TeamStateSpace *>(si->getStateSpace().get());
        if (!team)
            throw ompl::Exception(owner, "needs a TeamStateSpace");
        const unsigned int robots = team->getRobotCount();
        if (goals_.size() != robots)
            throw ompl::Exception(owner, "must have a goal for each of " + std::to_string(robots) + " robots, not " +
                                             std::to_string(goals_.size()));
        for (unsigned int i = 0; i < robots; ++i)
            if (goals_[i] && !goals_[i]->isFor(team->getRobot(i)))
                throw ompl::Exception(owner, goals_[i]->describe() + " is no goal of robot '" +
                                                 team->getRobot(i).getName() + "', but of one that differs from it");
        if (!isSatisfied(state_.get()))
            throw ompl::Exception(owner, "the state must be in the goal");
    }

    double TeamGoalRegion::distanceGoal(const ob::State *state) const
    {
        const auto *components = state->as<ob::CompoundState>()->components;
        const auto &team = *si_->getStateSpace()->as<TeamStateSpace>();
        double distance = 0.0;
        for (unsigned int i = 0; i < goals_.size(); ++i)
        {
            const double own = goals_[i] ? goals_[i]->distance(components[i])
                                         : team.getRobot(i).getStateSpace()->distance(
                                               components[i], state_->as<ob::CompoundState>()->components[i]);
            // What is no number is no goal.
            distance = std::isnan(own) ? std::numeric_limits<double>::infinity() : std::max(distance, own);
        }
        return distance;
    }

    void TeamGoalRegion::sampleGoal(ob::State *state) const
    {
        const std::lock_guard<std::mutex> lock(sampling_);
        if (samples_++ % KNOWN_STATE_PERIOD == 0)
            si_->copyState(state, state_.get());
        else
            sampleGoal(random_, state);
    }

    void TeamGoalRegion::sampleGoal(ompl::RNG &random, ob::State *state) const
    {
        std::vector<unsigned int> fixed, order;
        for (unsigned int robot = 0; robot < goals_.size(); ++robot)
            (goals_[robot] ? order : fixed).push_back(robot);
        bool isFound = false;
        for (unsigned int i = 0; !isFound && i < MOST_ROUNDS; ++i)
        {
            si_->copyState(state, state_.get());
            std::vector<unsigned int> placed = fixed;
            const auto isPlaced = [&](unsigned int robot)
            {
                const bool hasRoom = sampleRobot(robot, placed, random, state);
                placed.push_back(robot);
                return hasRoom;
            };
            const auto stuck = std::find_if_not(order.begin(), order.end(), isPlaced);
            isFound = stuck == order.end();
            // Nobody who could make room was before it.
            if (stuck == order.begin())
                break;
            if (!isFound)
                std::rotate(order.begin(), stuck, stuck + 1);
        }
        if (!isFound)
            si_->copyState(state, state_.get());
        si_->getStateSpace()->as<TeamStateSpace>()->clearReferences(state);
    }

    bool TeamGoalRegion::sampleRobot(unsigned int robot, const std::vector<unsigned int> &placed, ompl::RNG &random,
                                     ob::State *state) const
    {
        auto *components = state->as<ob::CompoundState>()->components;
        const auto isApart = [&](unsigned int other)
        { return checker_->isPairFree(robot, components[robot], other, components[other]); };
        for (unsigned int i = 0; i < TRIES; ++i)
        {
            if (!goals_[robot]->sample(random, components[robot]))
                return false;
            if (checker_->isRobotFree(robot, components[robot]) && std::all_of(placed.begin(), placed.end(), isApart))
                return true;
        }
        return false;
    }
}
