#include "ompl_certificates/validity/RobotPairs.h"

#include "BodyClearance.h"
#include "certificates/CertifiedEnvironment.h"
#include "certificates/ExactCheck.h"

#include "ompl_certificates/obstacles/FclObstacles.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        constexpr double INF = std::numeric_limits<double>::infinity();

        /** Two balls touch if this is not positive: the arithmetic of FCL's own test of two spheres. */
        double gapOf(const Ball &a, const Pose &poseA, const Ball &b, const Pose &poseB)
        {
            return (poseA * a.center - poseB * b.center).norm() - (a.radius + b.radius);
        }

        /** For how long two balls stay apart that are more than a margin apart. The cushion lets the gap at another time
            prove that there, too. */
        double reachOf(double gap, double margin, double speed)
        {
            return speed > 0.0 ? std::max(gap - margin * (1.0 + CertifiedEnvironment::PROOF_CUSHION), 0.0) / speed
                               : INF;
        }
    }

    struct RobotPairs::BodyFrame
    {
        Body body;
        CertifiedEnvironment environment;
        /** \brief What pays with certificates, and without */
        SwitchingPolicy policy, contactPolicy;
    };

    RobotPairs::RobotPairs(const TeamStateSpace &team, std::shared_ptr<CertificateLimit> limit)
      : team_(team), limit_(std::move(limit))
    {
        for (unsigned int i = 0; i < team.getRobotCount(); ++i)
            for (unsigned int j = i + 1; j < team.getRobotCount(); ++j)
            {
                pairs_.push_back({i, j, {}});
                const auto &first = team.getRobot(i).getBodies(), &second = team.getRobot(j).getBodies();
                for (std::size_t a = 0; a < first.size(); ++a)
                    for (std::size_t b = 0; b < second.size(); ++b)
                    {
                        // The body with the coarser cover is looked up in the frame of the other.
                        const bool swapped =
                            second[b].getSphereTree().getNodes().size() < first[a].getSphereTree().getNodes().size();
                        const bool balls = first[a].isBall() && second[b].isBall();
                        pairs_.back().bodies.push_back(
                            {a, b, swapped, balls ? nullptr : frameOf(swapped ? first[a] : second[b]),
                             2.0 * exactCheckTolerance(first[a].getBoundingRadius() + second[b].getBoundingRadius())});
                    }
            }
    }

    std::shared_ptr<RobotPairs::BodyFrame> RobotPairs::frameOf(const Body &body)
    {
        for (const auto &frame : frames_)
            if (frame->body == body)
                return frame;
        auto obstacles =
            std::make_shared<FclObstacles>(body.getDimension(), std::vector<PlacedBody>{{body}}, team_.getZInterval());
        frames_.push_back(
            std::shared_ptr<BodyFrame>(new BodyFrame{body, CertifiedEnvironment(obstacles, limit_), {}, {}}));
        return frames_.back();
    }

    const Body &RobotPairs::firstBody(const Pair &pair, const BodyPair &bodies) const
    {
        return team_.getRobot(pair.first).getBodies()[bodies.firstBody];
    }

    const Body &RobotPairs::secondBody(const Pair &pair, const BodyPair &bodies) const
    {
        return team_.getRobot(pair.second).getBodies()[bodies.secondBody];
    }

    bool RobotPairs::collide(unsigned int index, const Pose *first, const Pose *second, bool contactTest,
                             CheckCounts &counts) const
    {
        const Pair &pair = pairs_[index];
        for (const BodyPair &bodies : pair.bodies)
        {
            const Body &a = firstBody(pair, bodies), &b = secondBody(pair, bodies);
            const Pose &poseA = first[bodies.firstBody], &poseB = second[bodies.secondBody];
            const double gap = gapOf(a.getSphereTree().getRoot(), poseA, b.getSphereTree().getRoot(), poseB);
            if (!bodies.frame)
            {
                if (gap <= 0.0)
                    return true;
            }
            else if (gap <= bodies.margin)
            {
                const Obstacles &obstacles = bodies.frame->environment.getObstacles();
                const Body &body = bodies.swapped ? b : a;
                const Pose relative = bodies.swapped ? poseA.inverse() * poseB : poseB.inverse() * poseA;
                CheckCounts asked;
                SettledBy by;
                const bool touch = contactTest ? collidesWithoutMemory(obstacles, body, relative,
                                                                       bodies.frame->contactPolicy, by, asked)
                                               : obstacles.collides(body, relative);
                counts.contactTests += asked.contactTests;
                counts.pairExact += contactTest ? asked.exactCalls : 1;
                if (touch)
                    return true;
            }
        }
        return false;
    }

    PoseVerdict RobotPairs::settle(unsigned int index, const Pose *first, const Pose *second,
                                   const MotionBound *firstBounds, const MotionBound *secondBounds,
                                   double requiredInterval, CheckCounts &counts) const
    {
        const Pair &pair = pairs_[index];
        PoseVerdict verdict;
        verdict.validInterval = INF;
        for (const BodyPair &bodies : pair.bodies)
        {
            const Body &a = firstBody(pair, bodies), &b = secondBody(pair, bodies);
            const Pose &poseA = first[bodies.firstBody], &poseB = second[bodies.secondBody];
            const Ball &ballA = a.getSphereTree().getRoot(), &ballB = b.getSphereTree().getRoot();
            const MotionBound boundA = firstBounds ? firstBounds[bodies.firstBody] : MotionBound{};
            const MotionBound boundB = secondBounds ? secondBounds[bodies.secondBody] : MotionBound{};
            const double gap = gapOf(ballA, poseA, ballB, poseB);
            const double speed = boundA.at(ballA.center.norm()) + boundB.at(ballB.center.norm());
            if (gap > bodies.margin + (requiredInterval > 0.0 ? requiredInterval * speed : 0.0))
            {
                verdict.validInterval = std::min(verdict.validInterval, reachOf(gap, bodies.margin, speed));
                continue;
            }
            if (!bodies.frame)
            {
                verdict.validInterval = 0.0;
                if (gap <= 0.0 || requiredInterval > 0.0)
                    return verdict;
                continue;
            }
            // Seen from the environment's frame, the other body moves as fast as both do together.
            const Pose relative = bodies.swapped ? poseA.inverse() * poseB : poseB.inverse() * poseA;
            const MotionBound &own = bodies.swapped ? boundB : boundA, &frame = bodies.swapped ? boundA : boundB;
            const double frameRadius = (bodies.swapped ? a : b).getBoundingRadius();
            const MotionBound travel{own.linear + frame.at(frameRadius), own.angular};
            CheckCounts asked;
            SwitchingPolicy indifferent;  // It has seen nothing yet, so it tries all.
            SwitchingPolicy &policy = adaptive_ ? bodies.frame->policy : indifferent;
            const PoseVerdict one = bodies.frame->environment.settle(
                {bodies.swapped ? b : a, relative, &travel, requiredInterval}, NO_CERTIFICATE, policy, asked);
            counts.clearanceQueries += asked.clearanceQueries;
            counts.contactTests += asked.contactTests;
            counts.pairExact += asked.exactCalls;
            verdict.validInterval = std::min(verdict.validInterval, one.validInterval);
            if (!one.free)
                return verdict;
        }
        verdict.free = true;
        return verdict;
    }

    double RobotPairs::intervalOfEnclosingBalls(unsigned int index, const Pose *first, const Pose *second,
                                                const MotionBound *firstBounds, const MotionBound *secondBounds) const
    {
        const Pair &pair = pairs_[index];
        double reach = INF;
        for (const BodyPair &bodies : pair.bodies)
        {
            const Ball &a = firstBody(pair, bodies).getSphereTree().getRoot(),
                       &b = secondBody(pair, bodies).getSphereTree().getRoot();
            const double gap = gapOf(a, first[bodies.firstBody], b, second[bodies.secondBody]);
            if (gap <= bodies.margin)
                return 0.0;
            const double speed =
                firstBounds[bodies.firstBody].at(a.center.norm()) + secondBounds[bodies.secondBody].at(b.center.norm());
            reach = std::min(reach, reachOf(gap, bodies.margin, speed));
        }
        return reach;
    }

    double RobotPairs::distance(unsigned int index, const Pose *first, const Pose *second) const
    {
        const Pair &pair = pairs_[index];
        double nearest = INF;
        for (const BodyPair &bodies : pair.bodies)
        {
            const Body &a = firstBody(pair, bodies), &b = secondBody(pair, bodies);
            const Pose &poseA = first[bodies.firstBody], &poseB = second[bodies.secondBody];
            if (!bodies.frame)
                nearest =
                    std::min(nearest, gapOf(a.getSphereTree().getRoot(), poseA, b.getSphereTree().getRoot(), poseB));
            else if (bodies.swapped)
                nearest = std::min(nearest,
                                   bodyClearance(bodies.frame->environment.getObstacles(), b, poseA.inverse() * poseB));
            else
                nearest = std::min(nearest,
                                   bodyClearance(bodies.frame->environment.getObstacles(), a, poseB.inverse() * poseA));
        }
        return nearest;
    }

    void RobotPairs::clear()
    {
        for (const auto &frame : frames_)
        {
            frame->environment.clear();
            frame->policy.reset();
            frame->contactPolicy.reset();
        }
    }
}
