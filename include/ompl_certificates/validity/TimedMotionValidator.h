#ifndef OMPL_CERTIFICATES_VALIDITY_TIMED_MOTION_VALIDATOR_
#define OMPL_CERTIFICATES_VALIDITY_TIMED_MOTION_VALIDATOR_

#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <memory>
#include <ompl/base/DiscreteMotionValidator.h>

namespace ompl_certificates
{
    /** \brief OMPL's own motion validator, whose time and motions are added to the statistics of a checker: the standard path
        of a comparison, timed as the one with certificates is. */
    class TimedMotionValidator : public ompl::base::DiscreteMotionValidator
    {
    public:
        /** \brief OMPL's validator for the space information of \e checker */
        TimedMotionValidator(const ompl::base::SpaceInformationPtr &si,
                             std::shared_ptr<const TeamValidityChecker> checker);

        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2) const override;

        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2,
                         std::pair<ompl::base::State *, double> &lastValid) const override;

    private:
        std::shared_ptr<const TeamValidityChecker> checker_;
    };
}

#endif
