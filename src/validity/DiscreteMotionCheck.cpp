#include "DiscreteMotionCheck.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** Over how many motions it is judged how likely one is free, and the least that this is taken for */
        constexpr double MOTION_MEMORY = 64.0, SMALLEST_CHANCE = 0.01;
    }

    DiscreteMotionCheck::DiscreteMotionCheck(const CertificateChecker &checker, MotionScratch &scratch,
                                             const ompl::base::State *s1, const ompl::base::State *s2)
      : MotionCheck(checker, scratch, s1, s2)
    {
    }

    void DiscreteMotionCheck::countSegments()
    {
        segments_ = static_cast<int>(checker_.getTeam().validSegmentCount(s1_, s2_));
    }

    bool DiscreteMotionCheck::settleEnd()
    {
        // The second state's own references are the best hints; a state that has none yet is near the first one.
        takeReferences(s2_, s1_);
        for (unsigned int subject = 0; subject < subjectCount(); ++subject)
        {
            // Of a motion that collides few samples are looked at before that is found.
            const PoseVerdict verdict = settle(subject, 1.0, 0.0, 0.0);
            // Nothing of this motion was counted before its end.
            counts_.endPoses = counts_.robotPoses;
            counts_.endAsked = counts_.asked;
            if (!verdict.free)
                return false;
            scratch_.endInterval[subject] = verdict.validInterval;
        }
        giveReferences(s2_);
        return true;
    }

    void DiscreteMotionCheck::proveFromStart()
    {
        for (unsigned int robot = 0; robot < checker_.getTeam().getRobotCount(); ++robot)
        {
            pose(robot, 0.0);
            if (const CertificateIndex own = s1_->getReference(robot); own != NO_CERTIFICATE)
                scratch_.references[robot] = own;
        }
        const Pose *poses = scratch_.poses.data();
        const MotionBound *travel = scratch_.travel.data();
        for (unsigned int group = 0; group < groups_; ++group)
            if (scratch_.endInterval[group] < 1.0)
                scratch_.startInterval[group] =
                    checker_.intervalOfReferences(group, poses, travel, scratch_.references.data());
        const RobotPairs &pairs = checker_.getPairs();
        for (unsigned int pair = 0; pair < pairs.getPairCount(); ++pair)
        {
            if (scratch_.endInterval[groups_ + pair] >= 1.0)
                continue;
            const std::size_t a = scratch_.firstBody[pairs.getFirst(pair)],
                              b = scratch_.firstBody[pairs.getSecond(pair)];
            scratch_.startInterval[groups_ + pair] =
                pairs.intervalOfEnclosingBalls(pair, poses + a, poses + b, travel + a, travel + b);
        }
    }

    PoseVerdict DiscreteMotionCheck::settleSample(unsigned int subject, int sample)
    {
        const double samplesAhead = std::max(scratch_.freeMotions, SMALLEST_CHANCE) * std::max(segments_, 1);
        return settle(subject, static_cast<double>(sample) / segments_, 0.0, samplesAhead);
    }

    int DiscreteMotionCheck::samplesWithin(double reach) const
    {
        const double samples = std::min(reach * (1.0 - OVERLAP), 1.0) * segments_;
        return samples > 0.0 ? static_cast<int>(std::ceil(samples)) - 1 : 0;
    }

    std::pair<int, int> DiscreteMotionCheck::openSamples(unsigned int subject) const
    {
        return {1 + samplesWithin(scratch_.startInterval[subject]),
                segments_ - 1 - samplesWithin(scratch_.endInterval[subject])};
    }

    bool DiscreteMotionCheck::isFree()
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

    bool DiscreteMotionCheck::areInnerSamplesFree()
    {
        auto &queue = scratch_.open;
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
            const PoseVerdict verdict = settleSample(subject, middle);
            if (!verdict.free)
                return false;
            const int within = samplesWithin(verdict.validInterval);
            skip(subject, std::min(within, middle - first) + std::min(within, last - middle));
            if (middle - 1 - within >= first)
                queue.push_back({subject, first, middle - 1 - within});
            if (middle + 1 + within <= last)
                queue.push_back({subject, middle + 1 + within, last});
        }
        return true;
    }

    bool DiscreteMotionCheck::isFree(double &free)
    {
        // The first sample known to be invalid; the end of the motion is sample number segments_.
        countSegments();
        const int end = std::max(segments_, 1);
        int invalid = settleEnd() ? end + 1 : end;
        if (segments_ >= 2)
        {
            proveFromStart();
            for (unsigned int subject = 0; subject < subjectCount(); ++subject)
            {
                const auto [first, last] = openSamples(subject);
                skip(subject, std::min(first, end) - 1);
                for (int sample = first; sample <= last && sample < invalid;)
                {
                    const PoseVerdict verdict = settleSample(subject, sample);
                    if (!verdict.free)
                    {
                        invalid = sample;
                        break;
                    }
                    const int within = samplesWithin(verdict.validInterval);
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
}
