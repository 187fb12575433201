#include "ompl_certificates/validity/TeamValidityChecker.h"

#include "BodyClearance.h"
#include "certificates/ExactCheck.h"

#include <algorithm>
#include <limits>
#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        const TeamStateSpace &teamOf(const ob::SpaceInformationPtr &si)
        {
            auto *team = si ? dynamic_cast<TeamStateSpace *>(si->getStateSpace().get()) : nullptr;
            if (!team)
                throw ompl::Exception("A team validity checker needs space information with a TeamStateSpace");
            if (team->getRobotCount() == 0)
                throw ompl::Exception("Add the robots to the team before its validity checker is made");
            team->lock();
            return *team;
        }

        void requireObstacles(const ObstaclesPtr &obstacles, const TeamStateSpace &team)
        {
            if (!obstacles)
                throw ompl::Exception("A team validity checker needs obstacles; for none, give an empty FclObstacles");
            if (obstacles->getDimension() != team.getWorkspaceDimension())
                throw ompl::Exception("The obstacles have " + std::to_string(obstacles->getDimension()) +
                                      " dimensions, the team's workspace " +
                                      std::to_string(team.getWorkspaceDimension()));
            if (team.getWorkspaceDimension() == 2 && !obstacles->getZInterval().contain(team.getZInterval()))
                throw ompl::Exception(
                    "The robots reach higher or lower than the heights that the obstacles were made for; "
                    "give them the team's, TeamStateSpace::getZInterval()");
        }
    }

    TeamValidityChecker::TeamValidityChecker(const ob::SpaceInformationPtr &si, ObstaclesPtr obstacles,
                                             ExactCheck exactCheck)
      : StateValidityChecker(si)
      , obstacles_(std::move(obstacles))
      , team_(teamOf(si))
      , pairs_(team_, limit_)
      , exactCheck_(exactCheck)
    {
        requireObstacles(obstacles_, team_);
        specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::BOUNDED_APPROXIMATE;
        firstBody_.push_back(0);
        for (const auto &robot : team_.getRobots())
            firstBody_.push_back(firstBody_.back() + robot->getBodies().size());
        contactPolicies_ = std::vector<SwitchingPolicy>(getBodyCount());
        if (exactCheck_ != ExactCheck::FCL)
            makeMeshTrees();
    }

    void TeamValidityChecker::makeMeshTrees() const
    {
        for (const auto &robot : team_.getRobots())
            for (const Body &body : robot->getBodies())
                for (const auto &part : body.getParts())
                    if (const TriangleMesh *mesh = part.shape.getMesh())
                        mesh->getTree();
    }

    void TeamValidityChecker::changeObstacles(const ObstacleChange &change)
    {
        for (const ObstaclesPtr &obstacles : {change.after, change.added, change.removed})
            if (obstacles || obstacles == change.after)
                requireObstacles(obstacles, team_);
        const WorldLock::Change guard(worldLock_);
        repair(change);
        obstacles_ = change.after;
    }

    Pose *TeamValidityChecker::poseBuffer() const
    {
        thread_local std::vector<Pose> poses;
        if (poses.size() < getBodyCount())
            poses.resize(getBodyCount());
        return poses.data();
    }

    bool TeamValidityChecker::collidesWithObstacles(std::size_t index, const Body &body, const Pose &pose,
                                                    SettledBy &by, CheckCounts &counts) const
    {
        if (!isFinite(pose))
            return true;
        if (exactCheck_ != ExactCheck::FCL)
            return collidesWithoutMemory(*obstacles_, body, pose, contactPolicies_[index], by, counts);
        by = SettledBy::EXACT_CHECK;
        ++counts.exactCalls;
        return obstacles_->collides(body, pose);
    }

    bool TeamValidityChecker::findContact(const ob::State *state, CheckCounts &counts, unsigned int &first,
                                          unsigned int &second) const
    {
        const auto *teamState = state->as<TeamStateSpace::StateType>();
        Pose *poses = poseBuffer();
        for (unsigned int i = 0; i < team_.getRobotCount(); ++i)
        {
            const Robot &robot = team_.getRobot(i);
            const std::size_t firstBody = getFirstBody(i);
            robot.placeBodies(teamState->components[i], poses + firstBody);
            bool collide = false;
            SettledBy by = SettledBy::CLEARANCES;
            for (std::size_t k = 0; !collide && k < robot.getBodies().size(); ++k)
            {
                SettledBy bodyBy = SettledBy::CLEARANCES;
                collide =
                    collidesWithObstacles(firstBody + k, robot.getBodies()[k], poses[firstBody + k], bodyBy, counts);
                by = std::max(by, bodyBy);
            }
            countRobotPose(counts, by, !collide);
            if (collide)
            {
                first = second = i;
                return true;
            }
        }
        for (unsigned int pair = 0; pair < pairs_.getPairCount(); ++pair)
        {
            first = pairs_.getFirst(pair);
            second = pairs_.getSecond(pair);
            ++counts.pairPoses;
            if (pairs_.collide(pair, poses + getFirstBody(first), poses + getFirstBody(second),
                               exactCheck_ != ExactCheck::FCL, counts))
                return true;
        }
        return false;
    }

    bool TeamValidityChecker::isFreeExactly(const ob::State *state, CheckCounts &counts) const
    {
        unsigned int first, second;
        return !findContact(state, counts, first, second);
    }

    TeamValidityChecker::~TeamValidityChecker() = default;

    bool TeamValidityChecker::isValid(const ob::State *state) const
    {
        const WorldLock::Check check(worldLock_);
        const Statistics::Timer timer(statistics_);
        CheckCounts counts;
        const bool valid = isFreeExactly(state, counts);
        statistics_.add(counts);
        return valid;
    }

    std::string TeamValidityChecker::describeCollision(const ob::State *state) const
    {
        const WorldLock::Check check(worldLock_);
        CheckCounts counts;
        unsigned int first, second;
        if (!findContact(state, counts, first, second))
            return "";
        if (first == second)
            return "robot '" + team_.getRobot(first).getName() + "' touches an obstacle";
        return "robots '" + team_.getRobot(first).getName() + "' and '" + team_.getRobot(second).getName() +
               "' touch each other";
    }

    double TeamValidityChecker::clearance(const ob::State *state) const
    {
        const WorldLock::Check check(worldLock_);
        const auto *teamState = state->as<TeamStateSpace::StateType>();
        Pose *poses = poseBuffer();
        double nearest = std::numeric_limits<double>::infinity();
        for (unsigned int i = 0; i < team_.getRobotCount(); ++i)
        {
            const Robot &robot = team_.getRobot(i);
            Pose *own = poses + getFirstBody(i);
            robot.placeBodies(teamState->components[i], own);
            for (std::size_t k = 0; k < robot.getBodies().size(); ++k)
                nearest = std::min(nearest, bodyClearance(*obstacles_, robot.getBodies()[k], own[k]));
        }
        for (unsigned int pair = 0; pair < pairs_.getPairCount(); ++pair)
            nearest = std::min(nearest, pairs_.distance(pair, poses + getFirstBody(pairs_.getFirst(pair)),
                                                        poses + getFirstBody(pairs_.getSecond(pair))));
        return nearest;
    }
}
