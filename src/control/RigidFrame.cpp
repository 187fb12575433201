#include "RigidFrame.h"

#include "Planar.h"
#include "robots/SpaceBounds.h"

#include <algorithm>
#include <cmath>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>
#include <string>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        constexpr int FRAMES_TRIED = 40;

        /** The rounding error of poses, relative to their size */
        constexpr double FRAME_ROUNDING = 1e-13;

        /** A body nearer to the frame, relative to its radius, turns about its own origin. */
        constexpr double SAME_ORIGIN = 1e-12;

        /** Numbers from 0 to 1 that are spread evenly, another for each axis */
        double spread(int number, unsigned int axis)
        {
            constexpr double steps[] = {0.8191725134, 0.6710436067, 0.5497004779};
            return std::fmod(number * steps[axis], 1.0);
        }

        /** Write a state, and return its frame. The first is the one within bounds that is nearest to the origin, where
            rounding hides least. The others are ever farther from it, at last anywhere. */
        Pose placeFrame(const ob::StateSpace &space, int number, ob::State *state)
        {
            const double part = number == 0 ? 0.0 : std::ldexp(1.0, number + 1 - FRAMES_TRIED);
            const auto within = [=](const ob::RealVectorBounds &bounds, unsigned int axis)
            {
                const double low = bounds.low[axis], high = bounds.high[axis], share = spread(number, axis),
                             nearest = std::max(low, std::min(0.0, high));
                return (1.0 - part) * nearest + part * ((1.0 - share) * low + share * high);
            };
            const ob::RealVectorBounds &bounds = *findPositionBounds(space);
            if (space.getType() == ob::STATE_SPACE_SE2)
            {
                const Planar planar{within(bounds, 0), within(bounds, 1), 3.0 * (2.0 * spread(number, 2) - 1.0)};
                planar.writeTo(state);
                return planarPose(planar.x, planar.y, planar.yaw);
            }
            Eigen::Vector3d position = Eigen::Vector3d::Zero();
            for (unsigned int axis = 0; axis < space.getDimension(); ++axis)
            {
                position[axis] = within(bounds, axis);
                state->as<ob::RealVectorStateSpace::StateType>()->values[axis] = position[axis];
            }
            return poseAt(position);
        }
    }

    std::vector<double> distancesFromFrame(const Robot &robot)
    {
        const ob::RealVectorBounds &bounds = *findPositionBounds(*robot.getStateSpace());
        requirePositionBounds(robot.getName(), bounds, bounds.low.size());
        ob::ScopedState<> state(robot.getStateSpace());
        std::vector<Pose> poses(robot.getBodies().size()), fixed;
        std::vector<double> distances;
        for (int i = 0; i < FRAMES_TRIED; ++i)
        {
            const Pose frame = placeFrame(*robot.getStateSpace(), i, state.get());
            robot.placeBodies(state.get(), poses.data());
            for (std::size_t body = 0; body < poses.size(); ++body)
            {
                if (robot.isZone(body))
                {
                    if (i == 0)
                        distances.push_back(0.0);
                    continue;
                }
                Pose &pose = poses[body];
                // The difference comes first: it is exact for a body near its frame, wherever that is.
                pose.translation() = frame.linear().transpose() * (pose.translation() - frame.translation());
                pose.linear() = frame.linear().transpose() * pose.linear();
                const double distance = pose.translation().norm(),
                             rounding = FRAME_ROUNDING * (1.0 + distance + frame.translation().norm());
                if (i == 0)
                    distances.push_back(distance <= SAME_ORIGIN * robot.getBodies()[body].getBoundingRadius()
                                            ? 0.0
                                            : distance + rounding);
                else if (!((pose.matrix() - fixed[body].matrix()).norm() <= rounding))
                    throw ompl::Exception(robot.getName(), "its body " + std::to_string(body) +
                                                               " is not fixed to the frame of its state");
            }
            if (i == 0)
                fixed = poses;
        }
        return distances;
    }
}
