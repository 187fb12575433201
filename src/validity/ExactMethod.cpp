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
        for (std::size_t k = 0; free && k < bodies.size(); ++k)
        {
            SettledBy by = SettledBy::CERTIFICATE;
            free = !collidesWithoutMemory(*obstacles_, bodies[k], context.poses[first + k],
                                                  contactTest_ ? &policies_[first + k] : nullptr, by, context.counts);
            settledBy = std::max(settledBy, by);
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
