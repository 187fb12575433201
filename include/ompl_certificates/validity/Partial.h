#ifndef OMPL_CERTIFICATES_VALIDITY_PARTIAL_
#define OMPL_CERTIFICATES_VALIDITY_PARTIAL_

#include "ompl_certificates/validity/ProjectedChecker.h"

namespace ompl_certificates
{
    /** \brief The Partial Certificate method: a robot may be certified by any certificate that the same robot made. Each robot
        has a tree of its own.

        @par External documentation
        J. Bialkowski, M. Otte, E. Frazzoli, Fast Collision Checking: From Single Robots to Multi-Robot Teams, 2013,
        section II-B. */
    class Partial : public ProjectedChecker
    {
    public:
        /** \brief See TeamValidityChecker::TeamValidityChecker() */
        Partial(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles);

        std::string getMethodName() const override
        {
            return "partial";
        }
    };
}

#endif
