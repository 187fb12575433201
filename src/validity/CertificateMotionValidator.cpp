#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include "MotionCheck.h"

#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** OMPL counts motions in plain integers, but validators are used by many threads. */
        void countMotion(unsigned int &counter)
        {
            __atomic_fetch_add(&counter, 1U, __ATOMIC_RELAXED);
        }
    }

    CertificateMotionValidator::CertificateMotionValidator(std::shared_ptr<const CertificateChecker> checker, Mode mode)
      : MotionValidator(checker ? checker->si_
                                : throw ompl::Exception("A motion validator needs a certificate checker"))
      , checker_(std::move(checker))
      , mode_(mode)
      , scratch_(std::make_unique<MotionScratchPool>(si_->getStateSpace()))
    {
    }

    CertificateMotionValidator::~CertificateMotionValidator() = default;

    bool CertificateMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2) const
    {
        const WorldLock::Check entry(checker_->worldLock_);
        const Statistics::Timer timer(checker_->getStatistics());
        const MotionScratchPool::Lease scratch(*scratch_);
        MotionCheck check(*checker_, *scratch, s1, s2);
        const bool valid = mode_ == DISCRETE ? check.areSamplesFree() : check.isWholeFree();
        checker_->getStatistics().add(check.getCounts());
        countMotion(valid ? valid_ : invalid_);
        return valid;
    }

    bool CertificateMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2,
                                                 std::pair<ob::State *, double> &lastValid) const
    {
        const WorldLock::Check entry(checker_->worldLock_);
        const Statistics::Timer timer(checker_->getStatistics());
        const MotionScratchPool::Lease scratch(*scratch_);
        MotionCheck check(*checker_, *scratch, s1, s2);
        double free = 1.0;
        const bool valid = mode_ == DISCRETE ? check.areSamplesFree(free) : check.isWholeFree(free);
        checker_->getStatistics().add(check.getCounts());
        countMotion(valid ? valid_ : invalid_);
        if (!valid)
        {
            lastValid.second = free;
            if (lastValid.first)
                checker_->getTeam().interpolate(s1, s2, free, lastValid.first);
        }
        return valid;
    }
}
