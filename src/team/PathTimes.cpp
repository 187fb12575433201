#include "ompl_certificates/team/PathTimes.h"

#include "geometry/ShortestText.h"
#include "ompl_certificates/team/TeamStateSpace.h"

#include <algorithm>
#include <ompl/base/SpaceInformation.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    double speedOf(const ob::StateSpace &space, unsigned int robot)
    {
        const auto *team = dynamic_cast<const TeamStateSpace *>(&space);
        return team ? team->getSpeed(robot) : 1.0;
    }

    double motionTime(const ob::StateSpace &space, const ob::State *from, const ob::State *to)
    {
        const auto *team = dynamic_cast<const TeamStateSpace *>(&space);
        if (!team)
            return space.distance(from, to);
        const auto &starts = *from->as<ob::CompoundState>(), &ends = *to->as<ob::CompoundState>();
        double longest = 0.0;
        for (unsigned int robot = 0; robot < team->getRobotCount(); ++robot)
            longest = std::max(longest,
                               team->getSubspace(robot)->distance(starts[robot], ends[robot]) / team->getSpeed(robot));
        return longest;
    }

    std::vector<double> stateTimes(const ompl::geometric::PathGeometric &path)
    {
        std::vector<double> times;
        double time = 0.0;
        for (unsigned int i = 0; i < path.getStateCount(); ++i)
        {
            if (i > 0)
                time +=
                    motionTime(*path.getSpaceInformation()->getStateSpace(), path.getState(i - 1), path.getState(i));
            times.push_back(time);
        }
        return times;
    }

    std::vector<double> stateTimes(const ompl::control::PathControl &path)
    {
        std::vector<double> times(path.getStateCount(), 0.0);
        double sum = 0.0;
        for (unsigned int i = 1; i < path.getStateCount(); ++i)
        {
            sum += path.getControlDuration(i - 1);
            times[i] = withoutRounding(sum);
        }
        return times;
    }
}
