#include "ExactMethod.h"

#include "certificates/ExactCheck.h"

#include <algorithm>

namespace ompl_certificates
{
    ExactMethod::ExactMethod(const Team &team, ObstaclesPtr obstacles, bool contactTest)
      : obstacles_(std::move(obstacles)), contactTest_(contactTest), policies_(team.getBodyCount())
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
            free = !collidesWithoutMemory(*obstacles_, bodies[k], context.poses[first + k],
                                                  contactTest_ ? &policies_[first + k] : nullptr, by, context.counts);
            settledBy = std::max(settledBy, by);
            if (!free)
                context.lastColliding[robot] = k;
        }
        countRobotPose(context.counts, settledBy, free);
        return {free};
    }

    void ExactMethod::clear()
    {
        for (SwitchingPolicy &policy : policies_)
            policy.reset();
    }
}
