#include "DiscreteMotionCheck.h"

#include "BatchCheck.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** How many motions the estimate of a free motion's probability remembers, and its lower bound */
        constexpr double MOTION_MEMORY = 64.0, SMALLEST_CHANCE = 0.01;

        /** Proofs of stretches for many bodies cost more than the test of a sample. Where fewer motions than this
            fraction are free, such robots are first tested at the quarters of a motion of at least so many segments. */
        constexpr double LIKELY = 0.8;
        constexpr int FEWEST_SEGMENTS = 8;
    }

    DiscreteMotionCheck::DiscreteMotionCheck(const TeamCheck &check, CheckContext &context, const ompl::base::State *s1,
                                             const ompl::base::State *s2)
      : MotionCheck(check, context, s1, s2)
    {
    }

    DiscreteMotionCheck::DiscreteMotionCheck(const TeamCheck &check, CheckContext &context,
                                             const SubjectRange &subjects, States from, States to)
      : MotionCheck(check, context, subjects, from, to)
    {
    }

    bool DiscreteMotionCheck::settleEnd()
    {
        // The second state's own references are the best hints. If it has none yet, it is near the first state.
        takeReferences(s2_, s1_);
        for (unsigned int subject = 0; subject < subjectCount_; ++subject)
        {
            // samplesAhead is 0: a motion that collides is mostly refused after few samples.
            const SubjectVerdict verdict =
                check_.hasSeveralBodies(subjects_[subject]) ? test(subject, 1.0) : settle(subject, 1.0, 0.0, 0.0);
            countEnds();
            if (!verdict.free)
                return false;
            context_.endInterval[subject] = verdict.before;
        }
        giveReferences(s2_);
        return true;
    }

    void DiscreteMotionCheck::proveFromStart()
    {
        for (unsigned int subject = 0; subject < subjectCount_; ++subject)
            pose(subjects_[subject], 0.0);
        // A body for which the first state has no reference keeps the hint found at the end.
        if (const auto *first = s1_ ? check_.getTeam().getReferences(s1_) : nullptr)
            for (std::size_t body = 0; body < context_.hints.size(); ++body)
                if (const CertificateIndex own = first->getReference(body); own != NO_CERTIFICATE)
                    context_.hints[body] = own;
        for (unsigned int subject = 0; subject < subjectCount_; ++subject)
            if (context_.endInterval[subject] < 1.0)
                context_.startInterval[subject] = check_.provenInterval(subjects_[subject], context_);
    }

    SubjectVerdict DiscreteMotionCheck::settleSample(unsigned int subject, int sample)
    {
        const double samplesAhead = std::max(context_.freeMotions, SMALLEST_CHANCE) * std::max(segments_, 1);
        return settle(subject, static_cast<double>(sample) / segments_, 0.0, samplesAhead);
    }

    int DiscreteMotionCheck::samplesWithin(double interval) const
    {
        const double samples = std::min(interval * (1.0 - OVERLAP), 1.0) * segments_;
        return samples > 0.0 ? static_cast<int>(std::ceil(samples)) - 1 : 0;
    }

    std::pair<int, int> DiscreteMotionCheck::openSamples(unsigned int subject) const
    {
        return {1 + samplesWithin(context_.startInterval[subject]),
                segments_ - 1 - samplesWithin(context_.endInterval[subject])};
    }

    bool DiscreteMotionCheck::isFree()
    {
        if (!settleEnd())
            return false;
        segments_ = static_cast<int>(countSegments());
        if (segments_ < 2)
            return true;
        const bool free = areFirstSamplesFree() && areInnerSamplesFree();
        context_.freeMotions += ((free ? 1.0 : 0.0) - context_.freeMotions) / MOTION_MEMORY;
        return free;
    }

    bool DiscreteMotionCheck::areFirstSamplesFree()
    {
        if (context_.freeMotions > LIKELY || segments_ < FEWEST_SEGMENTS)
            return true;
        for (const int quarter : {2, 1, 3})
        {
            const int sample = quarter * segments_ / 4;
            for (unsigned int subject = 0; subject < subjectCount_; ++subject)
                if (check_.hasSeveralBodies(subjects_[subject]) &&
                    !test(subject, static_cast<double>(sample) / segments_).free)
                    return false;
        }
        return true;
    }

    bool DiscreteMotionCheck::areInnerSamplesFree()
    {
        if (!isBounded())
            return isFreeByStandard();
        proveFromStart();
        auto &queue = context_.open;
        queue.clear();
        for (unsigned int subject = 0; subject < subjectCount_; ++subject)
        {
            const auto [first, last] = openSamples(subject);
            skip(subject, std::min(segments_ - 1, segments_ - 1 - (last - first + 1)));
            if (first <= last)
                queue.push_back({subject, first, last});
        }
        // Breadth first, as in ompl::base::DiscreteMotionValidator: samples far from all known ones come first.
        for (std::size_t next = 0; next < queue.size(); ++next)
        {
            const auto [subject, first, last] = queue[next];
            const int middle = (first + last) / 2;
            const SubjectVerdict verdict = settleSample(subject, middle);
            if (!verdict.free)
                return false;
            const int before = samplesWithin(verdict.before), after = samplesWithin(verdict.after);
            skip(subject, std::min(before, middle - first) + std::min(after, last - middle));
            if (middle - 1 - before >= first)
                queue.push_back({subject, first, middle - 1 - before});
            if (middle + 1 + after <= last)
                queue.push_back({subject, middle + 1 + after, last});
        }
        return true;
    }

    bool DiscreteMotionCheck::isFreeByStandard()
    {
        const auto segments = static_cast<int>(countSegments());
        BreadthFirstSamples samples(context_.open, segments);
        if (context_.batch.isPossible())
        {
            const auto place = [&](int sample, std::size_t number)
            { placeInBatch(number, sample < segments ? static_cast<double>(sample) / segments : 1.0); };
            return BatchCheck(check_, context_, {subjects_, subjectCount_})
                .areFree(samples, static_cast<std::size_t>(std::max(segments, 1)), true, segments, place);
        }
        return isFreeByStandardAt(1.0) &&
               samples.areFree([&](int sample) { return isFreeByStandardAt(static_cast<double>(sample) / segments); });
    }

    bool DiscreteMotionCheck::isFreeByStandardAt(double time)
    {
        for (unsigned int subject = 0; subject < subjectCount_; ++subject)
        {
            place(subjects_[subject], time);
            if (!check_.isFreeByStandard(subjects_[subject], context_))
                return false;
        }
        return true;
    }

    void DiscreteMotionCheck::placeInBatch(std::size_t number, double time)
    {
        SampleBatch &batch = context_.batch;
        const auto placeRobot = [&](unsigned int robot)
        {
            const ompl::base::State *from = context_.from[robot], *to = context_.to[robot];
            batch.robotState(robot, number) = to;
            if (time < 1.0)
            {
                ompl::base::State *between = batch.robotSamples[robot * PoseBatch::SIZE + number];
                context_.curves[robot].interpolate(from, to, time, between);
                batch.robotState(robot, number) = between;
            }
        };
        for (unsigned int subject = 0; subject < subjectCount_; ++subject)
            subjects_[subject].forEachRobot(placeRobot);
    }

    bool DiscreteMotionCheck::isFree(double &freeUntil)
    {
        // The first sample known to be invalid. The end of the motion has number segments_, but at least 1.
        segments_ = static_cast<int>(countSegments());
        const int end = std::max(segments_, 1);
        int invalid = settleEnd() ? end + 1 : end;
        if (segments_ >= 2 && !isBounded())
        {
            for (int sample = 1; sample < end && sample < invalid; ++sample)
                if (!isFreeByStandardAt(static_cast<double>(sample) / end))
                    invalid = sample;
        }
        else if (segments_ >= 2)
        {
            proveFromStart();
            for (unsigned int subject = 0; subject < subjectCount_; ++subject)
            {
                const auto [first, last] = openSamples(subject);
                skip(subject, std::min(first, end) - 1);
                for (int sample = first; sample <= last && sample < invalid;)
                {
                    const SubjectVerdict verdict = settleSample(subject, sample);
                    if (!verdict.free)
                    {
                        invalid = sample;
                        break;
                    }
                    const int within = samplesWithin(verdict.after);
                    skip(subject, std::min(within, last - sample));
                    sample += 1 + within;
                }
            }
        }
        if (invalid > end)
            return true;
        freeUntil = static_cast<double>(invalid - 1) / static_cast<double>(end);
        return false;
    }
}
