#include "RoadmapPathCheck.h"

#include "ProductTree.h"

#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <ompl/base/ScopedState.h>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

    namespace
    {
        /** A box that contains a robot in all these states of its team */
        Eigen::AlignedBox3d boxAround(const Team &team, unsigned int robot, const std::vector<ob::State *> &states)
        {
            const std::vector<Body> &bodies = team.getRobot(robot).getBodies();
            std::vector<Pose> poses(bodies.size());
            Eigen::AlignedBox3d box;
            for (const ob::State *state : states)
            {
                team.getRobot(robot).placeBodies(team.getRobotState(state, robot), poses.data());
                for (std::size_t i = 0; i < bodies.size(); ++i)
                {
                    if (team.getRobot(robot).isZone(i))
                        continue;
                    // Some more, for what rounding and the tolerance of a check add
                    const Eigen::Vector3d center = poses[i].translation();
                    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(bodies[i].getBoundingRadius() * 1.001 +
                                                                            1e-6 * center.lpNorm<Eigen::Infinity>());
                    box.extend(center - reach);
                    box.extend(center + reach);
                }
            }
            return box;
        }
    }

    RoadmapPathCheck::RoadmapPathCheck(ob::SpaceInformationPtr si, const TeamValidityChecker &checker,
                                       TeamRoadmaps &roadmaps, ProductTree &tree)
      : si_(std::move(si)), checker_(checker), roadmaps_(roadmaps), tree_(tree)
    {
    }

    bool RoadmapPathCheck::confirm(Path &path)
    {
        og::PathGeometric geometric = toGeometric(path);
        std::size_t held = path.size();
        for (std::size_t step = 0; step + 1 < path.size(); ++step)
            if (!si_->checkMotion(geometric.getState(static_cast<unsigned int>(step)),
                                  geometric.getState(static_cast<unsigned int>(step + 1))))
            {
                held = std::min(held, step + 1);
                refute(path[step], path[step + 1]);
                tree_.cut(path[step], path[step + 1]);
            }
        if (held == path.size())
            return true;
        path.resize(held);
        return false;
    }

    void RoadmapPathCheck::refute(const Configuration &from, const Configuration &to)
    {
        // The team's samples are not those of a robot's own motion.
        const Team &team = checker_.getTeam();
        og::PathGeometric step = toGeometric({from, to});
        step.interpolate(si_->getStateSpace()->validSegmentCount(step.getState(0), step.getState(1)) + 1);
        const std::vector<ob::State *> &states = step.getStates();
        const auto isFree = [&](unsigned int i)
        {
            return std::all_of(states.begin(), states.end(),
                               [&](const ob::State *state)
                               { return checker_.isRobotFree(i, team.getRobotState(state, i)); });
        };
        const auto areApart = [&](unsigned int i, unsigned int j)
        {
            const auto areApartAt = [&](const ob::State *state)
            { return checker_.isPairFree(i, team.getRobotState(state, i), j, team.getRobotState(state, j)); };
            return std::all_of(states.begin(), states.end(), areApartAt);
        };
        // Of two hundred robots most pairs are far from each other.
        std::vector<Eigen::AlignedBox3d> boxes;
        for (unsigned int i = 0; i < team.getRobotCount(); ++i)
            boxes.push_back(boxAround(team, i, states));
        bool isFound = false;
        for (unsigned int i = 0; i < team.getRobotCount(); ++i)
        {
            if (!isFree(i))
            {
                roadmaps_.refute(i, from[i], to[i]);
                isFound = true;
            }
            for (unsigned int j = i + 1; j < team.getRobotCount(); ++j)
                if (boxes[i].intersects(boxes[j]) && !areApart(i, j))
                {
                    roadmaps_.refute(i, from[i], to[i], j, from[j], to[j]);
                    isFound = true;
                }
        }
        // A motion that is not proved, though all its samples are free: without one of its edges, the search goes
        // another way.
        for (unsigned int i = 0; i < team.getRobotCount() && !isFound; ++i)
            if (from[i] != to[i])
            {
                roadmaps_.refute(i, from[i], to[i]);
                isFound = true;
            }
    }

    og::PathGeometric RoadmapPathCheck::toGeometric(const Path &path) const
    {
        og::PathGeometric geometric(si_);
        ob::ScopedState<> state(si_);
        for (const Configuration &configuration : path)
        {
            roadmaps_.copyTo(configuration, state.get());
            geometric.append(state.get());
        }
        return geometric;
    }
}
