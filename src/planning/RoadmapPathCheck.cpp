#include "RoadmapPathCheck.h"

#include "ProductTree.h"

#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <algorithm>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

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
        bool isFound = false;
        for (unsigned int i = 0; i < team.getRobotCount(); ++i)
            for (const ob::State *state : step.getStates())
            {
                const ob::State *own = team.getRobotState(state, i);
                if (!checker_.isRobotFree(i, own))
                {
                    roadmaps_.refute(i, from[i], to[i]);
                    isFound = true;
                }
                for (unsigned int j = i + 1; j < team.getRobotCount(); ++j)
                    if (!checker_.isPairFree(i, own, j, team.getRobotState(state, j)))
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
        ob::State *state = si_->allocState();
        for (const Configuration &configuration : path)
        {
            roadmaps_.copyTo(configuration, state);
            geometric.append(state);
        }
        si_->freeState(state);
        return geometric;
    }
}
