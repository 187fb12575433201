#include "ExactMethod.h"

#include "certificates/ExactCheck.h"

#include <algorithm>

namespace ompl_certificates
{
    ExactMethod::ExactMethod(const Team &team, ObstaclesPtr obstacles, bool contactTest)
      : obstacles_(std::move(obstacles)), contactTest_(contactTest), policies_(team.getBodyCount())
    {
    }

    PoseVerdict ExactMethod::settleRobot(unsigned int robot, CheckContext &context,
                                         const MotionSample & /*sample*/) const
    {
        const auto &bodies = context.team.getRobot(robot).getBodies();
        const std::size_t first = context.team.getFirstBody(robot);
        PoseVerdict verdict;
        verdict.free = true;
        for (std::size_t k = 0; verdict.free && k < bodies.size(); ++k)
        {
            SettledBy by = SettledBy::CERTIFICATE;
            verdict.free = !collidesWithoutMemory(*obstacles_, bodies[k], context.poses[first + k],
                                                  contactTest_ ? &policies_[first + k] : nullptr, by, context.counts);
            verdict.by = std::max(verdict.by, by);
        }
        countRobotPose(context.counts, verdict.by, verdict.free);
        return verdict;
    }

    void ExactMethod::clear()
    {
        for (SwitchingPolicy &policy : policies_)
            policy.reset();
    }
}
