#include "MemorylessMethod.h"

#include "certificates/ContactThenFcl.h"

#include <algorithm>

namespace ompl_certificates
{
    MemorylessMethod::MemorylessMethod(ObstaclesPtr obstacles, bool contactTest)
      : obstacles_(std::move(obstacles)), contactTest_(contactTest)
    {
    }

    template <typename IsAsked>
    bool MemorylessMethod::areFree(unsigned int robot, CheckContext &context, SettledBy by,
                                   const IsAsked &isAsked) const
    {
        const auto &bodies = context.team.getRobot(robot).getBodies();
        const std::size_t first = context.team.getFirstBody(robot);
        bool free = true;
        const std::size_t likely = contactTest_ ? context.lastColliding[robot] : 0;
        for (std::size_t i = 0; free && i < bodies.size(); ++i)
        {
            const std::size_t k = CheckContext::inOrder(i, likely);
            if (!isAsked(first + k))
                continue;
            SettledBy one = SettledBy::CERTIFICATE;
            const Pose &pose = context.poses[first + k];
            ObstaclePart hit;
            free = isFinite(pose) && (context.team.mayTouchObstacles(first + k) ||
                                      !collides(*obstacles_, bodies[k], pose, contactTest_, one, hit, context.counts));
            by = std::max(by, one);
            if (!free)
                context.lastColliding[robot] = k;
        }
        countRobotPose(context.counts, by, free);
        return free;
    }

    SubjectVerdict MemorylessMethod::settleRobot(unsigned int robot, CheckContext &context,
                                                 const MotionSample & /*sample*/) const
    {
        return {areFree(robot, context, SettledBy::CERTIFICATE, [](std::size_t) { return true; })};
    }

    bool MemorylessMethod::isFreeAt(std::size_t sample, unsigned int robot, CheckContext &context) const
    {
        return areFree(robot, context, SettledBy::CONTACT,
                       [&](std::size_t body) { return contains(context.batch.nearObstacles[body], sample); });
    }
}
