#ifndef OMPL_CERTIFICATES_VALIDITY_SHARED_PROJECTION_
#define OMPL_CERTIFICATES_VALIDITY_SHARED_PROJECTION_

#include "ompl_certificates/validity/ProjectedChecker.h"

namespace ompl_certificates
{
    /** \brief The Shared Projection method: a robot may be certified by any certificate that any robot made, whatever their
        shapes, since certificates live in the workspace. All robots share one tree. The method to choose.

        @par External documentation
        J. Bialkowski, M. Otte, E. Frazzoli, Fast Collision Checking: From Single Robots to Multi-Robot Teams, 2013,
        section II-C. */
    class SharedProjection : public ProjectedChecker
    {
    public:
        /** \brief See TeamValidityChecker::TeamValidityChecker() */
        SharedProjection(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles);

        std::string getMethodName() const override
        {
            return "shared";
        }
    };
}

#endif
