#ifndef OMPL_CERTIFICATES_VALIDITY_EXACT_MOTION_VALIDATOR_
#define OMPL_CERTIFICATES_VALIDITY_EXACT_MOTION_VALIDATOR_

#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <memory>
#include <ompl/base/MotionValidator.h>

namespace ompl_certificates
{
    class MotionScratchPool;

    /** \brief Checks motions without certificates: the verdicts, the last valid states and the order of samples are those of
        ompl::base::DiscreteMotionValidator. The baseline of comparisons: as CertificateMotionValidator does, it takes the
        checker's lock once for a motion, counts and times it as a whole, and allocates nothing. May be used by many threads
        at once. */
    class ExactMotionValidator : public ompl::base::MotionValidator
    {
    public:
        /** \brief A motion validator that asks \e checker for each sample
            \throws ompl::Exception if \e checker is null */
        explicit ExactMotionValidator(std::shared_ptr<const TeamValidityChecker> checker);

        ~ExactMotionValidator() override;

        /** \brief Whether the motion from \e s1 to \e s2 is valid, if \e s1 is */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2) const override;

        /** \brief The same; if it is not, \e lastValid is set to the last valid state found, and its time */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2,
                         std::pair<ompl::base::State *, double> &lastValid) const override;

    private:
        std::shared_ptr<const TeamValidityChecker> checker_;
        std::unique_ptr<MotionScratchPool> scratch_;
    };
}

#endif
