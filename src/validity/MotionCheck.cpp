#include "MotionCheck.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** A continuous check gives up where proofs reach less far than this fraction of a discrete step. */
        constexpr double SMALLEST_STEP = 1.0 / 64.0;

        /** Neighbouring stretches overlap by this fraction, which pays for the rounding of times. */
        constexpr double OVERLAP = 1e-9;

        /** Over how many motions it is judged how likely one is free, and the least that this is taken for */
        constexpr double MOTION_MEMORY = 64.0, SMALLEST_CHANCE = 0.01;
    }

    MotionCheck::MotionCheck(const CertificateChecker &checker, MotionScratch &scratch, const ompl::base::State *s1,
                             const ompl::base::State *s2)
      : checker_(checker)
      , scratch_(scratch)
      , s1_(s1->as<TeamStateSpace::StateType>())
      , s2_(s2->as<TeamStateSpace::StateType>())
      , groups_(checker.getGroupCount())
    {
        ++counts_.motions;
        std::fill(scratch_.sampledAt.begin(), scratch_.sampledAt.end(), -1.0);
        scratch_.startReach.assign(subjectCount(), 0.0);
        scratch_.endReach.assign(subjectCount(), 0.0);
    }

    void MotionCheck::countSegments()
    {
        segments_ = static_cast<int>(checker_.getTeam().validSegmentCount(s1_, s2_));
    }

    void MotionCheck::measureTravel()
    {
        for (unsigned int robot = 0; robot < scratch_.sampledAt.size(); ++robot)
            pose(robot, 1.0);
    }

    const CheckCounts &MotionCheck::getCounts()
    {
        counts_.motionSamples = counts_.robotPoses + counts_.motionSamplesSkipped;
        return counts_;
    }

    unsigned int MotionCheck::robotsOf(unsigned int subject) const
    {
        if (subject >= groups_)
            return 0;
        const auto [first, last] = checker_.getGroup(subject);
        return last - first;
    }

    void MotionCheck::pose(unsigned int robot, double t)
    {
        if (scratch_.sampledAt[robot] == t)
            return;
        scratch_.sampledAt[robot] = t;
        const Robot &moved = checker_.getTeam().getRobot(robot);
        const ompl::base::State *component = scratch_.sample->components[robot];
        if (t == 0.0)
            component = s1_->components[robot];
        else if (t == 1.0)
        {
            // The end comes first: only now is it of interest how fast the robot moves.
            component = s2_->components[robot];
            moved.computeTravelBounds(s1_->components[robot], component,
                                      scratch_.travel.data() + scratch_.firstBody[robot]);
        }
        else
            moved.getStateSpace()->interpolate(s1_->components[robot], s2_->components[robot], t,
                                               scratch_.sample->components[robot]);
        moved.placeBodies(component, scratch_.poses.data() + scratch_.firstBody[robot]);
    }

    PoseVerdict MotionCheck::settle(unsigned int subject, double t)
    {
        const Pose *poses = scratch_.poses.data();
        const TravelBound *travel = scratch_.travel.data();
        if (subject < groups_)
        {
            const auto [first, last] = checker_.getGroup(subject);
            for (unsigned int robot = first; robot < last; ++robot)
                pose(robot, t);
            return checker_.settleGroup(subject, poses, {travel, minimumReach_, samplesAhead(t)},
                                        scratch_.references.data(), counts_);
        }
        const unsigned int pair = subject - groups_;
        const unsigned int first = checker_.getPairs().getFirst(pair), second = checker_.getPairs().getSecond(pair);
        pose(first, t);
        pose(second, t);
        ++counts_.pairPoses;
        const std::size_t a = scratch_.firstBody[first], b = scratch_.firstBody[second];
        return checker_.getPairs().settle(pair, poses + a, poses + b, travel + a, travel + b, counts_);
    }

    bool MotionCheck::settleEnd()
    {
        // The second state's own references are the best hints; a state that has none yet is near the first one.
        for (unsigned int robot = 0; robot < scratch_.references.size(); ++robot)
        {
            const CertificateIndex own = s2_->getReference(robot);
            scratch_.references[robot] = own == NO_CERTIFICATE ? s1_->getReference(robot) : own;
        }
        for (unsigned int subject = 0; subject < subjectCount(); ++subject)
        {
            const PoseVerdict verdict = settle(subject, 1.0);
            // Nothing of this motion was counted before its end.
            counts_.endPoses = counts_.robotPoses;
            counts_.endExact = counts_.exact;
            if (!verdict.free)
                return false;
            scratch_.endReach[subject] = verdict.reach;
        }
        for (unsigned int robot = 0; robot < scratch_.references.size(); ++robot)
            s2_->setReference(robot, scratch_.references[robot]);
        return true;
    }

    void MotionCheck::proveFromStart()
    {
        const TeamStateSpace &team = checker_.getTeam();
        for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
        {
            pose(robot, 0.0);
            if (const CertificateIndex own = s1_->getReference(robot); own != NO_CERTIFICATE)
                scratch_.references[robot] = own;
        }
        const Pose *poses = scratch_.poses.data();
        const TravelBound *travel = scratch_.travel.data();
        for (unsigned int group = 0; group < groups_; ++group)
            if (scratch_.endReach[group] < 1.0)
                scratch_.startReach[group] =
                    checker_.reachOfReferences(group, poses, travel, scratch_.references.data());
        for (unsigned int pair = 0; pair < checker_.getPairs().getPairCount(); ++pair)
        {
            if (scratch_.endReach[groups_ + pair] >= 1.0)
                continue;
            const std::size_t a = scratch_.firstBody[checker_.getPairs().getFirst(pair)];
            const std::size_t b = scratch_.firstBody[checker_.getPairs().getSecond(pair)];
            scratch_.startReach[groups_ + pair] =
                checker_.getPairs().reachOfEnclosingBalls(pair, poses + a, poses + b, travel + a, travel + b);
        }
    }

    double MotionCheck::samplesAhead(double t) const
    {
        // Of a motion that collides few samples are looked at before that is found.
        return t == 1.0 ? 0.0 : std::max(scratch_.freeMotions, SMALLEST_CHANCE) * std::max(segments_, 1);
    }

    int MotionCheck::samplesWithin(double reach) const
    {
        const double samples = std::min(reach * (1.0 - OVERLAP), 1.0) * segments_;
        return samples > 0.0 ? static_cast<int>(std::ceil(samples)) - 1 : 0;
    }

    std::pair<int, int> MotionCheck::openSamples(unsigned int subject) const
    {
        return {1 + samplesWithin(scratch_.startReach[subject]),
                segments_ - 1 - samplesWithin(scratch_.endReach[subject])};
    }

    void MotionCheck::skip(unsigned int subject, int samples)
    {
        counts_.motionSamplesSkipped += static_cast<std::uint64_t>(samples) * robotsOf(subject);
    }

    bool MotionCheck::areSamplesFree()
    {
        if (!settleEnd())
            return false;
        countSegments();
        if (segments_ < 2)
            return true;
        proveFromStart();
        const bool free = areInnerSamplesFree();
        scratch_.freeMotions += ((free ? 1.0 : 0.0) - scratch_.freeMotions) / MOTION_MEMORY;
        return free;
    }

    bool MotionCheck::areInnerSamplesFree()
    {
        auto &queue = scratch_.samples;
        queue.clear();
        for (unsigned int subject = 0; subject < subjectCount(); ++subject)
        {
            const auto [first, last] = openSamples(subject);
            skip(subject, std::min(segments_ - 1, segments_ - 1 - (last - first + 1)));
            if (first <= last)
                queue.push_back({subject, first, last});
        }
        // Breadth first, as in ompl::base::DiscreteMotionValidator: what is far from everything known is looked at first.
        for (std::size_t next = 0; next < queue.size(); ++next)
        {
            const auto [subject, first, last] = queue[next];
            const int middle = (first + last) / 2;
            const PoseVerdict verdict = settle(subject, timeOf(middle));
            if (!verdict.free)
                return false;
            const int within = samplesWithin(verdict.reach);
            skip(subject, std::min(within, middle - first) + std::min(within, last - middle));
            if (middle - 1 - within >= first)
                queue.push_back({subject, first, middle - 1 - within});
            if (middle + 1 + within <= last)
                queue.push_back({subject, middle + 1 + within, last});
        }
        return true;
    }

    bool MotionCheck::areSamplesFree(double &free)
    {
        // The first sample known to be invalid; the end of the motion is sample number segments_.
        countSegments();
        const int end = std::max(segments_, 1);
        int invalid = settleEnd() ? end + 1 : end;
        measureTravel();
        if (segments_ >= 2)
        {
            proveFromStart();
            for (unsigned int subject = 0; subject < subjectCount(); ++subject)
            {
                const auto [first, last] = openSamples(subject);
                skip(subject, std::min(first, end) - 1);
                for (int sample = first; sample <= last && sample < invalid;)
                {
                    const PoseVerdict verdict = settle(subject, timeOf(sample));
                    if (!verdict.free)
                    {
                        invalid = sample;
                        break;
                    }
                    const int within = samplesWithin(verdict.reach);
                    skip(subject, std::min(within, last - sample));
                    sample += 1 + within;
                }
            }
        }
        if (invalid > end)
            return true;
        free = static_cast<double>(invalid - 1) / static_cast<double>(end);
        return false;
    }

    bool MotionCheck::isWholeFree()
    {
        countSegments();
        minimumReach_ = SMALLEST_STEP / std::max(segments_, 1);
        if (!settleEnd())
            return false;
        auto &queue = scratch_.times;
        queue.clear();
        for (unsigned int subject = 0; subject < subjectCount(); ++subject)
            queue.push_back({subject, 0.0, 1.0 - scratch_.endReach[subject] * (1.0 - OVERLAP)});
        for (std::size_t next = 0; next < queue.size(); ++next)
        {
            const auto [subject, first, last] = queue[next];
            if (last <= 0.0 || last < first)
                continue;
            // The first look at a subject is at the start: its state is valid, but that is no proof for what follows it.
            const bool atStart = next < subjectCount();
            const double middle = atStart ? 0.0 : 0.5 * (first + last);
            const PoseVerdict verdict = settle(subject, middle);
            if (!verdict.free || verdict.reach < minimumReach_)
                return false;
            const double reach = verdict.reach * (1.0 - OVERLAP);
            if (!atStart && middle - reach >= first)
                queue.push_back({subject, first, middle - reach});
            if (middle + reach <= last)
                queue.push_back({subject, middle + reach, last});
        }
        return true;
    }

    bool MotionCheck::isWholeFree(double &free)
    {
        countSegments();
        minimumReach_ = SMALLEST_STEP / std::max(segments_, 1);
        bool valid = settleEnd();
        measureTravel();
        double proved = 1.0;
        for (unsigned int subject = 0; subject < subjectCount(); ++subject)
        {
            const double last = 1.0 - scratch_.endReach[subject] * (1.0 - OVERLAP);
            for (double t = 0.0; t <= last && t < proved;)
            {
                const PoseVerdict verdict = settle(subject, t);
                if (!verdict.free || verdict.reach < minimumReach_)
                {
                    proved = t;
                    valid = false;
                    break;
                }
                t += verdict.reach * (1.0 - OVERLAP);
            }
        }
        free = proved;
        return valid;
    }
}
