#include "MotionCheck.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        bool isKnown(const MotionBound &bound)
        {
            return std::isfinite(bound.linear) && std::isfinite(bound.angular);
        }

        bool areKnown(const PairMotionBound &bounds)
        {
            return isKnown(bounds.first) && isKnown(bounds.second);
        }
    }

    MotionCheck::MotionCheck(const TeamCheck &check, CheckContext &context, const ompl::base::State *s1,
                             const ompl::base::State *s2)
      : check_(check)
      , context_(context)
      , s1_(s1)
      , s2_(s2)
      , subjects_(check.getSubjects().data())
      , subjectCount_(static_cast<unsigned int>(check.getSubjects().size()))
    {
        for (unsigned int robot = 0; robot < check.getTeam().getRobotCount(); ++robot)
        {
            context.from[robot] = check.getTeam().getRobotState(s1, robot);
            context.to[robot] = check.getTeam().getRobotState(s2, robot);
        }
        begin();
    }

    MotionCheck::MotionCheck(const TeamCheck &check, CheckContext &context, const SubjectRange &subjects, States from,
                             States to)
      : check_(check), context_(context), subjects_(subjects.begin), subjectCount_(subjects.count)
    {
        const Subject &subject = *subjects_;
        context.from[subject.first] = *from.begin();
        context.from[subject.last] = *(from.end() - 1);
        context.to[subject.first] = *to.begin();
        context.to[subject.last] = *(to.end() - 1);
        begin();
    }

    void MotionCheck::begin()
    {
        before_ = context_.counts;
        ++context_.counts.motions;
        ++context_.motion;
        context_.beginCurves();
        std::fill(context_.sampledAt.begin(), context_.sampledAt.end(), -1.0);
        context_.knowsMotionBounds.assign(context_.knowsMotionBounds.size(), false);
        context_.knowsPairMotionBounds.assign(context_.knowsPairMotionBounds.size(), false);
        context_.startInterval.assign(subjectCount_, 0.0);
        context_.endInterval.assign(subjectCount_, 0.0);
    }

    MotionCheck::~MotionCheck()
    {
        context_.counts.motionSamples = context_.counts.robotPoses + context_.counts.motionSamplesSkipped;
    }

    void MotionCheck::skip(unsigned int subject, int samples)
    {
        const Subject &skipped = subjects_[subject];
        // Samples of pairs are not counted.
        if (skipped.kind != Subject::PAIR)
            context_.counts.motionSamplesSkipped +=
                static_cast<std::uint64_t>(samples) * (skipped.last - skipped.first + 1);
    }

    void MotionCheck::countEnds()
    {
        CheckCounts &counts = context_.counts;
        counts.endPoses = before_.endPoses + counts.robotPoses - before_.robotPoses;
        counts.endAsked = before_.endAsked + counts.asked - before_.asked;
    }

    void MotionCheck::pose(const Subject &posed, double t)
    {
        posed.forEachRobot([this](unsigned int robot) { computeMotionBounds(robot); });
        if (posed.kind == Subject::PAIR && posed.first == posed.last)
            computePairMotionBounds(posed.first);
        place(posed, t);
    }

    void MotionCheck::place(const Subject &subject, double t)
    {
        subject.forEachRobot([this, t](unsigned int robot) { poseRobot(robot, t); });
    }

    void MotionCheck::poseRobot(unsigned int robot, double t)
    {
        if (context_.sampledAt[robot] == t)
            return;
        const ompl::base::State *from = context_.from[robot], *to = context_.to[robot];
        context_.sampledAt[robot] = t;
        const ompl::base::State *state = t == 0.0 ? from : to;
        if (t > 0.0 && t < 1.0)
        {
            state = context_.samples[robot];
            context_.curves[robot].interpolate(from, to, t, context_.samples[robot]);
        }
        check_.place(robot, state, context_);
    }

    void MotionCheck::computeMotionBounds(unsigned int robot)
    {
        if (context_.knowsMotionBounds[robot])
            return;
        const Robot &moved = check_.getTeam().getRobot(robot);
        MotionBound *const bounds = context_.motionBounds.data() + check_.getTeam().getFirstBody(robot);
        moved.computeMotionBounds(context_.from[robot], context_.to[robot], bounds);
        context_.knowsMotionBounds[robot] = true;
        constexpr double muchTooLarge = 1e99;
        for (std::size_t i = 0; turnsOfJump_ > 0.0 && i < moved.getBodies().size(); ++i)
            if (bounds[i].angular > muchTooLarge)
                if (const auto jump = moved.getJump(i, context_.from[robot], context_.to[robot]))
                    bounds[i] = {jump->steady.linear + turnsOfJump_ * jump->jump.linear,
                                 jump->steady.angular + turnsOfJump_ * jump->jump.angular};
    }

    void MotionCheck::computePairMotionBounds(unsigned int robot)
    {
        if (context_.knowsPairMotionBounds[robot])
            return;
        const Team &team = check_.getTeam();
        team.getRobot(robot).computePairMotionBounds(context_.from[robot], context_.to[robot],
                                                     context_.motionBounds.data() + team.getFirstBody(robot),
                                                     context_.pairMotionBounds[robot].data());
        context_.knowsPairMotionBounds[robot] = true;
    }

    bool MotionCheck::isBounded()
    {
        // Bounds are of motions of the robots' own spaces.
        bool bounded = check_.getTeam().interpolatesRobots();
        const auto look = [&](unsigned int robot)
        {
            computeMotionBounds(robot);
            const MotionBound *const bounds = context_.motionBounds.data() + check_.getTeam().getFirstBody(robot);
            bounded =
                bounded && std::all_of(bounds, bounds + check_.getTeam().getRobot(robot).getBodies().size(), isKnown);
        };
        for (unsigned int subject = 0; bounded && subject < subjectCount_; ++subject)
        {
            const Subject &one = subjects_[subject];
            one.forEachRobot(look);
            if (one.kind != Subject::PAIR || one.first != one.last)
                continue;
            computePairMotionBounds(one.first);
            const auto &bounds = context_.pairMotionBounds[one.first];
            bounded = bounded && std::all_of(bounds.begin(), bounds.end(), areKnown);
        }
        return bounded;
    }

    SubjectVerdict MotionCheck::settle(const Subject &subject, double t, double requiredInterval, double samplesAhead)
    {
        const MotionSample sample{true, requiredInterval, samplesAhead, t};
        // Poses cost time, so what is known comes first.
        if (sample.usesOtherTimes())
            if (const auto known = check_.findVerdict(subject, context_, t))
                return *known;
        pose(subject, t);
        return check_.settle(subject, context_, sample);
    }

    SubjectVerdict MotionCheck::test(unsigned int subject, double t)
    {
        place(subjects_[subject], t);
        return {check_.settle(subjects_[subject], context_, {}).free};
    }

    unsigned int MotionCheck::countSegments() const
    {
        const Team &team = check_.getTeam();
        const auto ofRobot = [&](unsigned int robot)
        { return team.countSegments(robot, context_.from[robot], context_.to[robot]); };
        const unsigned int segments = s1_ ? team.getStateSpace()->validSegmentCount(s1_, s2_)
                                          : std::max(ofRobot(subjects_->first), ofRobot(subjects_->last));
        if (segments == 0)
            team.requireResolution();
        return segments;
    }
}
