#ifndef OMPL_CERTIFICATES_VALIDITY_SHARED_PROJECTION_
#define OMPL_CERTIFICATES_VALIDITY_SHARED_PROJECTION_

#include "ompl_certificates/validity/TeamValidityChecker.h"

namespace ompl_certificates
{
    /** \brief The Shared Projection method: certificates made by any robot certify any robot, whatever their shapes.
        This works because certificates live in the workspace. All robots share one tree. Choose this method unless you
        compare methods.

        @par External documentation
        J. Bialkowski, M. Otte, E. Frazzoli, Fast Collision Checking: From Single Robots to Multi-Robot Teams, 2013,
        section II-C. */
    class SharedProjection : public TeamValidityChecker
    {
    public:
        /** \brief For the team of a TeamStateSpace; see TeamValidityChecker::TeamValidityChecker() */
        SharedProjection(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles)
          : TeamValidityChecker(si, obstacles, Method::SHARED_PROJECTION)
        {
        }

        /** \brief For one robot, in its own space or any that Team reads */
        SharedProjection(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles,
                         const RobotPtr &robot)
          : TeamValidityChecker(si, obstacles, {robot}, Method::SHARED_PROJECTION)
        {
        }

        /** \brief For several robots, in any space that Team reads */
        SharedProjection(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles,
                         const std::vector<RobotPtr> &robots)
          : TeamValidityChecker(si, obstacles, robots, Method::SHARED_PROJECTION)
        {
        }
    };
}

#endif
