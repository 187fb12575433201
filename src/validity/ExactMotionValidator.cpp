#include "ompl_certificates/validity/ExactMotionValidator.h"

#include "MotionCount.h"
#include "MotionScratch.h"

#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** One motion, cut into segments */
        class Samples
        {
        public:
            Samples(const TeamValidityChecker &checker, MotionScratch &scratch, const ob::State *s1,
                    const ob::State *s2)
              : checker_(checker), scratch_(scratch), s1_(s1), s2_(s2)
            {
                ++counts_.motions;
            }

            ~Samples()
            {
                counts_.motionSamples = counts_.robotPoses;
                checker_.getStatistics().add(counts_);
            }

            Samples(const Samples &) = delete;
            Samples &operator=(const Samples &) = delete;

            bool isEndFree()
            {
                return checker_.isFreeExactly(s2_, counts_);
            }

            int countSegments()
            {
                return segments_ = static_cast<int>(checker_.getTeam().validSegmentCount(s1_, s2_));
            }

            bool isFree(int sample)
            {
                checker_.getTeam().interpolate(s1_, s2_, static_cast<double>(sample) / segments_, scratch_.sample);
                return checker_.isFreeExactly(scratch_.sample, counts_);
            }

        private:
            const TeamValidityChecker &checker_;
            MotionScratch &scratch_;
            const ob::State *s1_, *s2_;
            int segments_{0};
            CheckCounts counts_;
        };
    }

    ExactMotionValidator::ExactMotionValidator(std::shared_ptr<const TeamValidityChecker> checker)
      : MotionValidator(checker ? checker->getSpaceInformation()
                                : throw ompl::Exception("A motion validator needs a validity checker"))
      , checker_(std::move(checker))
      , scratch_(std::make_unique<MotionScratchPool>(si_->getStateSpace()))
    {
    }

    ExactMotionValidator::~ExactMotionValidator() = default;

    bool ExactMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2) const
    {
        const WorldLock::Check world = checker_->holdObstacles();
        const Statistics::Timer timer(checker_->getStatistics());
        const MotionScratchPool::Lease scratch(*scratch_);
        Samples samples(*checker_, *scratch, s1, s2);
        const auto areFree = [&]
        {
            if (!samples.isEndFree())
                return false;
            auto &queue = (*scratch).open;
            queue.clear();
            if (const int segments = samples.countSegments(); segments > 1)
                queue.push_back({0, 1, segments - 1});
            for (std::size_t next = 0; next < queue.size(); ++next)
            {
                const auto [subject, first, last] = queue[next];
                const int middle = (first + last) / 2;
                if (!samples.isFree(middle))
                    return false;
                if (first < middle)
                    queue.push_back({subject, first, middle - 1});
                if (last > middle)
                    queue.push_back({subject, middle + 1, last});
            }
            return true;
        };
        const bool valid = areFree();
        countMotion(valid ? valid_ : invalid_);
        return valid;
    }

    bool ExactMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2,
                                           std::pair<ob::State *, double> &lastValid) const
    {
        const WorldLock::Check world = checker_->holdObstacles();
        const Statistics::Timer timer(checker_->getStatistics());
        const MotionScratchPool::Lease scratch(*scratch_);
        Samples samples(*checker_, *scratch, s1, s2);
        const int segments = std::max(samples.countSegments(), 1);
        int invalid = 1;
        while (invalid < segments && samples.isFree(invalid))
            ++invalid;
        const bool valid = invalid == segments && samples.isEndFree();
        countMotion(valid ? valid_ : invalid_);
        if (!valid)
        {
            lastValid.second = static_cast<double>(invalid - 1) / segments;
            if (lastValid.first)
                checker_->getTeam().interpolate(s1, s2, lastValid.second, lastValid.first);
        }
        return valid;
    }
}
