#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include "ContinuousMotionCheck.h"
#include "DiscreteMotionCheck.h"
#include "MotionCount.h"

#include <algorithm>
#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    CertificateMotionValidator::CertificateMotionValidator(std::shared_ptr<const CertificateChecker> checker, Mode mode)
      : MotionValidator(checker ? checker->getSpaceInformation()
                                : throw ompl::Exception("A motion validator needs a certificate checker"))
      , checker_(std::move(checker))
      , mode_(mode)
      , scratch_(std::make_unique<MotionScratchPool>(si_->getStateSpace()))
    {
    }

    CertificateMotionValidator::~CertificateMotionValidator() = default;

    bool CertificateMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2) const
    {
        const WorldLock::Check world = checker_->holdObstacles();
        const Statistics::Timer timer(checker_->getStatistics());
        const MotionScratchPool::Lease scratch(*scratch_);
        const auto run = [this](auto &&check)
        {
            const bool free = check.isFree();
            checker_->getStatistics().add(check.getCounts());
            return free;
        };
        const bool valid = mode_ == DISCRETE ? run(DiscreteMotionCheck(*checker_, *scratch, s1, s2))
                                             : run(ContinuousMotionCheck(*checker_, *scratch, s1, s2));
        countMotion(valid ? valid_ : invalid_);
        return valid;
    }

    bool CertificateMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2,
                                                 std::pair<ob::State *, double> &lastValid) const
    {
        const WorldLock::Check world = checker_->holdObstacles();
        const Statistics::Timer timer(checker_->getStatistics());
        const MotionScratchPool::Lease scratch(*scratch_);
        double free = 1.0;
        const bool valid =
            mode_ == DISCRETE ? areSamplesFree(*scratch, s1, s2, free) : isProved(*scratch, s1, s2, free);
        countMotion(valid ? valid_ : invalid_);
        if (!valid)
        {
            lastValid.second = free;
            if (lastValid.first)
                checker_->getTeam().interpolate(s1, s2, free, lastValid.first);
        }
        return valid;
    }

    bool CertificateMotionValidator::areSamplesFree(MotionScratch &scratch, const ob::State *s1, const ob::State *s2,
                                                    double &free) const
    {
        DiscreteMotionCheck check(*checker_, scratch, s1, s2);
        const bool valid = check.isFree(free);
        checker_->getStatistics().add(check.getCounts());
        return valid;
    }

    bool CertificateMotionValidator::isProved(MotionScratch &scratch, const ob::State *s1, const ob::State *s2,
                                              double &free) const
    {
        ContinuousMotionCheck check(*checker_, scratch, s1, s2);
        const bool valid = check.isFree(free);
        checker_->getStatistics().add(check.getCounts());
        // The motion to the last valid state has cells of its own, and is to be proved in those.
        double step = check.getCell();
        while (!valid && free > 0.0)
        {
            checker_->getTeam().interpolate(s1, s2, free, scratch.last);
            ContinuousMotionCheck first(*checker_, scratch, s1, scratch.last);
            const bool proved = first.isFree();
            CheckCounts counts = first.getCounts();
            counts.motions = 0;
            checker_->getStatistics().add(counts);
            if (proved)
                break;
            free = std::max(0.0, free - step);
            step *= 2.0;
        }
        return valid;
    }
}
