#ifndef OMPL_CERTIFICATES_CONTROL_LIMITED_VALIDITY_CHECKER_
#define OMPL_CERTIFICATES_CONTROL_LIMITED_VALIDITY_CHECKER_

#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <memory>

namespace ompl_certificates
{
    /** \brief Checks that all robots are within their limits, then whatever a TeamValidityChecker checks. Controls
        drive robots out of their bounds, and OMPL's control planners do not ask for these. */
    class LimitedValidityChecker : public ompl::base::StateValidityChecker
    {
    public:
        /** \brief A checker for the states of \e checker
            \throws ompl::Exception if a robot is no DynamicRobot */
        explicit LimitedValidityChecker(std::shared_ptr<const TeamValidityChecker> checker);

        /** \brief Whether all robots are within their limits, and the team is free */
        bool isValid(const ompl::base::State *state) const override;

        using ompl::base::StateValidityChecker::isValid;

        /** \brief See TeamValidityChecker::clearance(); minus infinity beyond a limit */
        double clearance(const ompl::base::State *state) const override;

        using ompl::base::StateValidityChecker::clearance;

        /** \brief The checker of the team, which ignores limits */
        const std::shared_ptr<const TeamValidityChecker> &getTeamChecker() const
        {
            return checker_;
        }

    private:
        bool isWithinLimits(const ompl::base::State *state) const;

        const std::shared_ptr<const TeamValidityChecker> checker_;
    };
}

#endif
