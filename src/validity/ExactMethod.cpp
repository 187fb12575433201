#include "ExactMethod.h"

#include "certificates/ExactCheck.h"

#include <algorithm>

namespace ompl_certificates
{
    ExactMethod::ExactMethod(ObstaclesPtr obstacles, bool contactTest)
      : obstacles_(std::move(obstacles)), contactTest_(contactTest)
    {
    }

    SubjectVerdict ExactMethod::settleRobot(unsigned int robot, CheckContext &context,
                                            const MotionSample & /*sample*/) const
    {
        const auto &bodies = context.team.getRobot(robot).getBodies();
        const std::size_t first = context.team.getFirstBody(robot);
        bool free = true;
        SettledBy settledBy = SettledBy::CERTIFICATE;
        const std::size_t likely = contactTest_ ? context.lastColliding[robot] : 0;
        for (std::size_t i = 0; free && i < bodies.size(); ++i)
        {
            const std::size_t k = CheckContext::inOrder(i, likely);
            SettledBy by = SettledBy::CERTIFICATE;
            const Pose &pose = context.poses[first + k];
            ObstaclePart hit;
            free = isFinite(pose) && !collides(*obstacles_, bodies[k], pose, contactTest_, by, hit, context.counts);
            settledBy = std::max(settledBy, by);
            if (!free)
                context.lastColliding[robot] = k;
        }
        countRobotPose(context.counts, settledBy, free);
        return {free};
    }
}
