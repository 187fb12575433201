#include "RigidFrame.h"

#include "Planar.h"

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
        constexpr int FRAMES_TRIED = 20;

        /** The rounding error of poses, relative to their size */
        constexpr double FRAME_ROUNDING = 1e-9;

        /** Numbers from 0 to 1 that are spread evenly, another for each axis */
        double spread(int number, unsigned int axis)
        {
            constexpr double steps[] = {0.8191725134, 0.6710436067, 0.5497004779};
            return std::fmod(number * steps[axis], 1.0);
        }

        /** Write a state, and return its frame */
        Pose placeFrame(const ob::StateSpace &space, int number, ob::State *state)
        {
            const auto within = [number](const ob::RealVectorBounds &bounds, unsigned int axis)
            { return bounds.low[axis] + spread(number, axis) * (bounds.high[axis] - bounds.low[axis]); };
            if (space.getType() == ob::STATE_SPACE_SE2)
            {
                const ob::RealVectorBounds &bounds = space.as<ob::SE2StateSpace>()->getBounds();
                const Planar planar{within(bounds, 0), within(bounds, 1), 3.0 * (2.0 * spread(number, 2) - 1.0)};
                planar.writeTo(state);
                return planarPose(planar.x, planar.y, planar.yaw);
            }
            Eigen::Vector3d position = Eigen::Vector3d::Zero();
            for (unsigned int axis = 0; axis < space.getDimension(); ++axis)
            {
                position[axis] = within(space.as<ob::RealVectorStateSpace>()->getBounds(), axis);
                state->as<ob::RealVectorStateSpace::StateType>()->values[axis] = position[axis];
            }
            return poseAt(position);
        }
    }

    std::vector<double> distancesFromFrame(const Robot &robot)
    {
        ob::ScopedState<> state(robot.getStateSpace());
        std::vector<Pose> poses(robot.getBodies().size()), fixed;
        std::vector<double> distances(poses.size());
        for (int i = 0; i < FRAMES_TRIED; ++i)
        {
            const Pose frame = placeFrame(*robot.getStateSpace(), i, state.get());
            const double rounding = FRAME_ROUNDING * (1.0 + frame.translation().norm());
            robot.placeBodies(state.get(), poses.data());
            for (Pose &pose : poses)
                pose = frame.inverse() * pose;
            if (fixed.empty())
                fixed = poses;
            for (std::size_t body = 0; body < poses.size(); ++body)
            {
                if (!((poses[body].matrix() - fixed[body].matrix()).norm() <= rounding))
                    throw ompl::Exception(robot.getName(), "its body " + std::to_string(body) +
                                                               " is not fixed to the frame of its state");
                const double distance = poses[body].translation().norm();
                distances[body] = std::max(distances[body], distance > rounding ? distance + rounding : 0.0);
            }
        }
        return distances;
    }
}
