#include "RobotPairs.h"

#include "BodyClearance.h"
#include "certificates/CertifiedEnvironment.h"
#include "certificates/ExactCheck.h"

#include "ompl_certificates/obstacles/FclObstacles.h"

#include <algorithm>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        constexpr double INF = std::numeric_limits<double>::infinity();

        /** How long two balls stay apart whose gap exceeds a margin. The cushion lets the gap at any other time of that
            interval prove this, too. */
        double intervalOf(double gap, double margin, double speed)
        {
            return speed > 0.0 ? std::max(gap - margin * (1.0 + CertifiedEnvironment::PROOF_CUSHION), 0.0) / speed
                               : INF;
        }
    }

    struct RobotPairs::BodyFrame
    {
        Body body;
        ObstaclesPtr obstacles;
        /** \brief Null if the method makes no certificates */
        std::unique_ptr<CertifiedEnvironment> certified;
        SwitchingPolicy policy;
    };

    // The same arithmetic as in FCL's test of two spheres
    double RobotPairs::BodyPair::gap(const CheckContext &context) const
    {
        const Ball &a = first->getSphereTree().getRoot(), &b = second->getSphereTree().getRoot();
        return (context.poses[firstIndex] * a.center - context.poses[secondIndex] * b.center).norm() -
               (a.radius + b.radius);
    }

    RobotPairs::RobotPairs(const Team &team, Method method, std::shared_ptr<CertificateLimit> limit)
      : method_(method), limit_(std::move(limit)), robotCount_(team.getRobotCount())
    {
        for (unsigned int i = 0; i < team.getRobotCount(); ++i)
            for (unsigned int j = i + 1; j < team.getRobotCount(); ++j)
            {
                pairs_.push_back({i, j, {}});
                const auto &first = team.getRobot(i).getBodies(), &second = team.getRobot(j).getBodies();
                for (std::size_t a = 0; a < first.size(); ++a)
                    for (std::size_t b = 0; b < second.size(); ++b)
                    {
                        // The body with fewer spheres is looked up in the frame of the other.
                        const bool swapped =
                            second[b].getSphereTree().getNodes().size() < first[a].getSphereTree().getNodes().size();
                        const bool balls = first[a].isBall() && second[b].isBall();
                        pairs_.back().bodies.push_back(
                            {team.getFirstBody(i) + a, team.getFirstBody(j) + b, &first[a], &second[b],
                             balls ? nullptr : frameOf(swapped ? first[a] : second[b], team.getZInterval()), swapped,
                             2.0 * exactCheckTolerance(first[a].getBoundingRadius() + second[b].getBoundingRadius())});
                    }
            }
    }

    RobotPairs::~RobotPairs() = default;

    RobotPairs::BodyFrame *RobotPairs::frameOf(const Body &body, const ZInterval &zInterval)
    {
        for (const auto &frame : frames_)
            if (frame->body == body)
                return frame.get();
        auto frame = std::unique_ptr<BodyFrame>(new BodyFrame{body, nullptr, nullptr, {}});
        frame->obstacles =
            std::make_shared<FclObstacles>(std::vector<PlacedBody>{{body}}, body.getDimension(), zInterval);
        if (makesCertificates(method_))
            frame->certified = std::make_unique<CertifiedEnvironment>(frame->obstacles, limit_);
        frames_.push_back(std::move(frame));
        return frames_.back().get();
    }

    unsigned int RobotPairs::find(unsigned int first, unsigned int second) const
    {
        const unsigned int low = std::min(first, second), high = std::max(first, second);
        // The pairs stand in the order of their first, then of their second robot.
        if (low < high && high < robotCount_)
            return low * robotCount_ - low * (low + 1) / 2 + high - low - 1;
        throw ompl::Exception("There is no pair of robots " + std::to_string(first) + " and " + std::to_string(second));
    }

    PoseVerdict RobotPairs::settle(unsigned int pair, CheckContext &context, const MotionSample &sample) const
    {
        ++context.counts.pairPoses;
        PoseVerdict verdict;
        verdict.validInterval = INF;
        for (const BodyPair &bodies : pairs_[pair].bodies)
        {
            const double gap = bodies.gap(context);
            double speed = 0.0;
            if (sample.moves)
                speed =
                    context.motionBounds[bodies.firstIndex].at(bodies.first->getSphereTree().getRoot().center.norm()) +
                    context.motionBounds[bodies.secondIndex].at(bodies.second->getSphereTree().getRoot().center.norm());
            if (gap > bodies.margin + (sample.requiredInterval > 0.0 ? sample.requiredInterval * speed : 0.0))
            {
                verdict.validInterval = std::min(verdict.validInterval, intervalOf(gap, bodies.margin, speed));
                continue;
            }
            if (!bodies.frame)
            {
                verdict.validInterval = 0.0;
                if (!(gap > 0.0) || sample.requiredInterval > 0.0)  // Also true for NaN
                    return verdict;
                continue;
            }
            const PoseVerdict one = settleBodies(bodies, context, sample);
            verdict.validInterval = std::min(verdict.validInterval, one.validInterval);
            if (!one.free)
                return verdict;
        }
        verdict.free = true;
        return verdict;
    }

    PoseVerdict RobotPairs::settleBodies(const BodyPair &bodies, CheckContext &context,
                                         const MotionSample &sample) const
    {
        const BodyFrame &frame = *bodies.frame;
        const Body &body = bodies.lookedUp();
        const Pose relative = bodies.relativePose(context);
        CheckCounts asked;
        PoseVerdict verdict;
        SwitchingPolicy untrained;  // A new policy tries everything.
        SwitchingPolicy &policy = adaptive_ ? bodies.frame->policy : untrained;
        if (frame.certified)
        {
            // In the environment's frame, the motion bounds of both bodies add up.
            MotionBound bound;
            if (sample.moves)
            {
                const MotionBound &a = context.motionBounds[bodies.firstIndex],
                                  &b = context.motionBounds[bodies.secondIndex];
                const MotionBound &own = bodies.swapped ? b : a, &other = bodies.swapped ? a : b;
                bound = {own.linear + other.at(frame.body.getBoundingRadius()), own.angular};
            }
            verdict = frame.certified->settle({body, relative, &bound, sample.requiredInterval}, NO_CERTIFICATE, policy,
                                              asked);
        }
        else
            verdict.free = !collidesWithoutMemory(*frame.obstacles, body, relative,
                                                  method_ == Method::FCL ? nullptr : &policy, verdict.by, asked);
        context.counts.clearanceQueries += asked.clearanceQueries;
        context.counts.contactTests += asked.contactTests;
        context.counts.pairExact += asked.exactCalls;
        return verdict;
    }

    double RobotPairs::provenInterval(unsigned int pair, const CheckContext &context) const
    {
        double interval = INF;
        for (const BodyPair &bodies : pairs_[pair].bodies)
        {
            const double gap = bodies.gap(context);
            if (gap <= bodies.margin)
                return 0.0;
            const double speed =
                context.motionBounds[bodies.firstIndex].at(bodies.first->getSphereTree().getRoot().center.norm()) +
                context.motionBounds[bodies.secondIndex].at(bodies.second->getSphereTree().getRoot().center.norm());
            interval = std::min(interval, intervalOf(gap, bodies.margin, speed));
        }
        return interval;
    }

    bool RobotPairs::collide(unsigned int pair, const CheckContext &context) const
    {
        const auto touch = [&](const BodyPair &bodies)
        {
            const double gap = bodies.gap(context);
            if (!bodies.frame || gap > bodies.margin)
                return !(gap > 0.0);
            return bodies.frame->obstacles->collides(bodies.lookedUp(), bodies.relativePose(context));
        };
        const auto &all = pairs_[pair].bodies;
        return std::any_of(all.begin(), all.end(), touch);
    }

    double RobotPairs::distance(unsigned int pair, const CheckContext &context) const
    {
        double nearest = INF;
        for (const BodyPair &bodies : pairs_[pair].bodies)
            nearest = std::min(nearest, bodies.frame ? bodyClearance(*bodies.frame->obstacles, bodies.lookedUp(),
                                                                     bodies.relativePose(context))
                                                     : bodies.gap(context));
        return nearest;
    }

    void RobotPairs::clear()
    {
        for (const auto &frame : frames_)
        {
            if (frame->certified)
                frame->certified->clear();
            frame->policy.reset();
        }
    }
}
