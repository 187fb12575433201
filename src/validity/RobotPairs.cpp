#include "RobotPairs.h"

#include "BodyClearance.h"
#include "BodyFrame.h"
#include "certificates/CertifiedEnvironment.h"
#include "geometry/ConvexCover.h"
#include "geometry/Infinity.h"
#include "robots/PairPadding.h"

#include <algorithm>
#include <ompl/base/ScopedState.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        /** Bounding spheres that prove so much of a motion on either side are not looked into; a gap that proves so
            much is not made more precise. */
        constexpr double SHORT_STRETCH = 0.06, LONG_STRETCH = 0.12;

        /** Covers the rounding of squared distances */
        constexpr double SQUARES_ROUNDING = 1e-12;

        /** How long two balls stay apart whose gap exceeds a margin. The cushion lets the gap at any other time of that
            interval prove this, too. */
        double intervalOf(double gap, double margin, double speed)
        {
            return speed > 0.0 ? std::max(gap - margin * (1.0 + CertifiedEnvironment::PROOF_CUSHION), 0.0) / speed
                               : INF;
        }

        bool areCentersWithin(const Body &body)
        {
            const auto &nodes = body.getSphereTree().getNodes();
            return std::all_of(nodes.begin(), nodes.end(),
                               [&](const SphereTree::Node &node)
                               { return node.ball.center.norm() <= body.getBoundingRadius(); });
        }
    }

    RobotPairs::RobotPairs(const Team &team, Method method, std::shared_ptr<CertificateLimit> limit)
      : method_(method), limit_(std::move(limit)), robotCount_(team.getRobotCount())
    {
        for (unsigned int i = 0; i < team.getRobotCount(); ++i)
            for (unsigned int j = i + 1; j < team.getRobotCount(); ++j)
            {
                pairs_.push_back({i, j, {}});
                for (std::size_t a = 0; a < team.getRobot(i).getBodies().size(); ++a)
                    for (std::size_t b = 0; b < team.getRobot(j).getBodies().size(); ++b)
                        if (team.getRobot(i).mayCollide(a, team.getRobot(j), b) &&
                            team.getRobot(j).mayCollide(b, team.getRobot(i), a))
                            pairs_.back().bodies.push_back(makeTwoBodies(team, i, a, j, b));
            }
        for (unsigned int i = 0; i < team.getRobotCount(); ++i)
        {
            const std::vector<BodyPair> &own = team.getRobot(i).getBodyPairs();
            if (own.empty())
                continue;
            pairs_.push_back({i, i, {}});
            for (std::size_t k = 0; k < own.size(); ++k)
            {
                TwoBodies bodies = makeTwoBodies(team, i, own[k].first, i, own[k].second);
                bodies.robot = i;
                bodies.ownPair = k;
                if (const auto cells = makesCertificates(method) ? team.getRobot(i).getJointCells(k) : nullptr;
                    cells && bodies.frame && bodies.lookedUp().getPadding() == 0.0)
                    bodies.cells.emplace(i, team.getRobot(i), k, cells, bodies.margin,
                                         bodies.frame->getContactMargin(bodies.lookedUp()));
                pairs_.back().bodies.push_back(bodies);
            }
        }
        settleLargeCells(team);
        for (const Pair &pair : pairs_)
        {
            firstBodyPairs_.push_back(firstBodyPairs_.back() + pair.bodies.size());
            hasSimplePairs_ = hasSimplePairs_ || pair.bodies.size() == 1;
        }
    }

    RobotPairs::~RobotPairs() = default;

    void RobotPairs::settleLargeCells(const Team &team) const
    {
        std::size_t left = MOST_LARGE_CELLS;
        for (const unsigned int level : {0U, 1U})
            for (const Pair &pair : pairs_)
            {
                if (pair.first != pair.second)
                    continue;
                const Robot &robot = team.getRobot(pair.first);
                ompl::base::ScopedState<> state(robot.getStateSpace());
                state = std::vector<double>(state.reals().size());
                state.enforceBounds();
                std::vector<Pose> poses(robot.getBodies().size());
                for (const TwoBodies &bodies : pair.bodies)
                    if (bodies.cells)
                        left -= bodies.cells->settleLarge(level, left, state.get(), poses.data());
            }
    }

    TwoBodies RobotPairs::makeTwoBodies(const Team &team, unsigned int first, std::size_t a, unsigned int second,
                                        std::size_t b)
    {
        const Robot &firstRobot = team.getRobot(first), &secondRobot = team.getRobot(second);
        const Body &bodyA = firstRobot.getBodies()[a], &bodyB = secondRobot.getBodies()[b];
        const double padding = paddingBetween(firstRobot, a, secondRobot, b);
        TwoBodies bodies;
        bodies.firstIndex = team.getFirstBody(first) + a;
        bodies.secondIndex = team.getFirstBody(second) + b;
        // The body with fewer spheres is looked up in the frame of the other, and has all of the padding.
        bodies.swapped = bodyB.getSphereTree().getNodes().size() < bodyA.getSphereTree().getNodes().size();
        const Body &one = paddedBody(bodyA, bodies.swapped ? 0.0 : padding),
                   &other = paddedBody(bodyB, bodies.swapped ? padding : 0.0);
        bodies.first = &one;
        bodies.second = &other;
        bodies.frame =
            one.isBall() && other.isBall() ? nullptr : frameOf(bodies.swapped ? one : other, team.getZInterval());
        bodies.margin = 2.0 * exactCheckTolerance(one.getBoundingRadius() + other.getBoundingRadius()) +
                        (bodies.frame ? bodies.frame->getTolerance() : 0.0);
        bodies.farthest =
            (one.getSphereTree().getRoot().radius + other.getSphereTree().getRoot().radius + bodies.margin) *
            (1.0 + SQUARES_ROUNDING);
        bodies.centersWithin = areCentersWithin(one) && areCentersWithin(other);
        return bodies;
    }

    const Body &RobotPairs::paddedBody(const Body &body, double padding)
    {
        if (body.getPadding() == padding)
            return body;
        const Body wanted = body.padded(padding);
        for (const auto &known : paddedBodies_)
            if (*known == wanted)
                return *known;
        paddedBodies_.push_back(std::make_unique<const Body>(wanted));
        return *paddedBodies_.back();
    }

    BodyFrame *RobotPairs::frameOf(const Body &body, const ZInterval &zInterval)
    {
        for (const auto &frame : frames_)
            if (frame->getBody() == body)
                return frame.get();
        frames_.push_back(std::make_unique<BodyFrame>(body, zInterval, limit_));
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

    SubjectVerdict RobotPairs::settle(unsigned int pair, CheckContext &context, const MotionSample &sample) const
    {
        ++context.counts.pairPoses;
        SubjectVerdict whole = SubjectVerdict::always();
        const std::vector<TwoBodies> &all = pairs_[pair].bodies;
        const bool usesOtherTimes = sample.usesOtherTimes() && all.size() > 1;
        ProvenTimes *times = context.bodyPairTimes.data() + firstBodyPairs_[pair];
        const std::size_t likely = method_ == Method::FCL ? 0 : context.lastCollidingPair[pair];
        // Where most pairs of bodies are far apart, that settles them soonest. In a motion, most are known.
        const bool placesSpheres = !sample.moves && all.size() > context.team.getBodyCount();
        if (placesSpheres)
            for (const unsigned int robot : {pairs_[pair].first, pairs_[pair].second})
                placeSpheres(robot, context);
        for (std::size_t k = 0; whole.free && k < all.size(); ++k)
        {
            const std::size_t i = CheckContext::inOrder(k, likely);
            if (placesSpheres && areSpheresApart(all[i], context))
                continue;
            if (usesOtherTimes)
                if (const auto *known = times[i].find(context.motion, sample.time))
                {
                    whole.narrow(*known, sample.time);
                    continue;
                }
            const SubjectVerdict one = settleTwo(all[i], firstBodyPairs_[pair] + i, context, sample);
            whole.narrow(one);
            if (!one.free)
                context.lastCollidingPair[pair] = i;
            else if (usesOtherTimes)
                context.noteFree(times[i], sample.time, one.before, one.after);
        }
        return whole;
    }

    void RobotPairs::placeSpheres(unsigned int robot, CheckContext &context)
    {
        std::size_t index = context.team.getFirstBody(robot);
        for (const Body &body : context.team.getRobot(robot).getBodies())
        {
            context.sphereCenters[index] = context.poses[index] * body.getSphereTree().getRoot().center;
            ++index;
        }
    }

    SubjectVerdict RobotPairs::settleTwo(const TwoBodies &bodies, std::size_t number, CheckContext &context,
                                         const MotionSample &sample) const
    {
        SubjectVerdict verdict;
        const double gap = bodies.gap(context);
        const double speed = sample.moves ? bodies.speed(context) : 0.0;
        if (gap > bodies.margin + (sample.requiredInterval > 0.0 ? sample.requiredInterval * speed : 0.0))
        {
            verdict.free = true;
            verdict.before = verdict.after = intervalOf(gap, bodies.margin, speed);
            if (!bodies.frame || !searchesGaps(sample) || verdict.after >= SHORT_STRETCH)
                return verdict;
        }
        else if (!bodies.frame)
        {
            // Balls are as far apart as their gap, and stay so if they do not move. False for NaN
            verdict.free = gap > 0.0 && (sample.requiredInterval == 0.0 || speed == 0.0);
            if (verdict.free && sample.moves && speed == 0.0)
                verdict.before = verdict.after = INF;
            return verdict;
        }
        if (bodies.cells && sample.requiredInterval == 0.0 &&
            settleByCells(*bodies.cells, number, context, sample, verdict))
            return verdict;
        verdict.widen(verdict.free
                          ? settleByGap(bodies, bodies.relativePose(context), bodies.relativeMotionBound(context),
                                        LONG_STRETCH, context.bodyPairDirections[number])
                          : settleBodies(bodies, number, context, sample));
        return verdict;
    }

    bool RobotPairs::settleByCells(const JointCellCheck &cells, std::size_t number, CheckContext &context,
                                   const MotionSample &sample, SubjectVerdict &verdict) const
    {
        // Where the bounding spheres are apart, new cells are not worth their proof.
        switch (verdict.free ? cells.find(context) : cells.settle(context, number))
        {
            case JointCells::Answer::TOUCHING:
                return true;
            case JointCells::Answer::APART:
                break;
            default:
                return false;
        }
        verdict.free = true;
        if (!searchesGaps(sample))
            return true;
        const auto [before, after] = cells.apartFor(context);
        verdict.before = std::max(verdict.before, before);
        verdict.after = std::max(verdict.after, after);
        return std::max(before, after) >= SHORT_STRETCH;
    }

    PoseVerdict RobotPairs::settleBodies(const TwoBodies &bodies, std::size_t number, CheckContext &context,
                                         const MotionSample &sample) const
    {
        const Body &body = bodies.lookedUp();
        const Pose relative = bodies.relativePose(context);
        const MotionBound bound = sample.moves ? bodies.relativeMotionBound(context) : MotionBound();
        PoseVerdict verdict;
        CheckCounts asked;
        if (sample.requiredInterval > 0.0)
        {
            SwitchingPolicy untrained;  // has no say where only a proof counts
            verdict = bodies.frame->getCertified().settle({body, relative, &bound, sample.requiredInterval},
                                                          NO_CERTIFICATE, untrained, asked);
        }
        else if (isFinite(relative))
        {
            // The gap is also the quickest test of bodies near each other.
            if (method_ != Method::FCL)
                verdict = settleByGap(bodies, relative, bound, searchesGaps(sample) ? LONG_STRETCH : 0.0,
                                      context.bodyPairDirections[number]);
            if (!verdict.free)
                verdict.free = !collides(bodies, relative, asked);
        }
        context.counts.clearanceQueries += asked.clearanceQueries;
        context.counts.contactTests += asked.contactTests;
        context.counts.pairExact += asked.exactCalls;
        return verdict;
    }

    bool RobotPairs::collides(const TwoBodies &bodies, const Pose &relative, CheckCounts &counts) const
    {
        if (method_ != Method::FCL)
        {
            ++counts.contactTests;
            if (const Touching answer = bodies.frame->touches(bodies.lookedUp(), relative); answer != Touching::UNKNOWN)
                return answer == Touching::YES;
        }
        ++counts.exactCalls;
        return bodies.frame->collides(bodies.lookedUp(), relative);
    }

    PoseVerdict RobotPairs::settleByGap(const TwoBodies &bodies, const Pose &relative, const MotionBound &bound,
                                        double stretch, Eigen::Vector3d &direction) const
    {
        const Body &body = bodies.lookedUp();
        const double speed = bound.at(body.getBoundingRadius());
        const double gap = convexGap(bodies.frame->getBody(), body, relative, bodies.margin,
                                     bodies.margin + stretch * speed, direction);
        PoseVerdict verdict;
        verdict.free = gap > bodies.margin;
        if (verdict.free)
            verdict.validInterval = intervalOf(gap, bodies.margin, speed);
        return verdict;
    }

    double RobotPairs::provenInterval(unsigned int pair, CheckContext &context) const
    {
        double interval = INF;
        const std::vector<TwoBodies> &all = pairs_[pair].bodies;
        ProvenTimes *times = context.bodyPairTimes.data() + firstBodyPairs_[pair];
        for (std::size_t i = 0; i < all.size(); ++i)
        {
            if (const auto *known = times[i].find(context.motion, 0.0))
            {
                interval = std::min(interval, known->last);
                continue;
            }
            const double gap = all[i].gap(context);
            const double own = gap > all[i].margin ? intervalOf(gap, all[i].margin, all[i].speed(context)) : 0.0;
            interval = std::min(interval, own);
            if (all.size() > 1)
                context.noteFree(times[i], 0.0, own);
        }
        return interval;
    }

    std::optional<BodyPair> RobotPairs::findCollision(unsigned int pair, const CheckContext &context) const
    {
        const auto touch = [&](const TwoBodies &bodies)
        {
            const double gap = bodies.gap(context);
            if (!bodies.frame || gap > bodies.margin)
                return !(gap > 0.0);
            return bodies.frame->collides(bodies.lookedUp(), bodies.relativePose(context));
        };
        const Pair &robots = pairs_[pair];
        for (const TwoBodies &bodies : robots.bodies)
            if (touch(bodies))
                return BodyPair{bodies.firstIndex - context.team.getFirstBody(robots.first),
                                bodies.secondIndex - context.team.getFirstBody(robots.second)};
        return std::nullopt;
    }

    double RobotPairs::distance(unsigned int pair, const CheckContext &context) const
    {
        double nearest = INF;
        for (const TwoBodies &bodies : pairs_[pair].bodies)
            nearest = std::min(nearest, bodies.frame ? bodyClearance(bodies.frame->getObstacles(), bodies.lookedUp(),
                                                                     bodies.relativePose(context))
                                                     : bodies.gap(context));
        return nearest;
    }

    bool RobotPairs::areFarther(unsigned int pair, double distance, const CheckContext &context) const
    {
        const auto isFarther = [&](const TwoBodies &bodies)
        {
            if (!bodies.frame)
                return bodies.gap(context) > distance;
            return bodies.gap(context) - bodies.margin > distance ||
                   bodyClearance(bodies.frame->getObstacles(), bodies.lookedUp(), bodies.relativePose(context)) >
                       distance;
        };
        return std::all_of(pairs_[pair].bodies.begin(), pairs_[pair].bodies.end(), isFarther);
    }

    void RobotPairs::clear()
    {
        for (const auto &frame : frames_)
            frame->clear();
    }
}
