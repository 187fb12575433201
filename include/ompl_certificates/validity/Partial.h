#ifndef OMPL_CERTIFICATES_VALIDITY_PARTIAL_
#define OMPL_CERTIFICATES_VALIDITY_PARTIAL_

#include "ompl_certificates/validity/TeamValidityChecker.h"

namespace ompl_certificates
{
    /** \brief The Partial Certificate method: certificates made by a robot certify that robot. Each robot has a tree of
        its own.

        @par External documentation
        J. Bialkowski, M. Otte, E. Frazzoli, Fast Collision Checking: From Single Robots to Multi-Robot Teams, 2013,
        section II-B. */
    class Partial : public TeamValidityChecker
    {
    public:
        /** \brief For the team of a TeamStateSpace; see TeamValidityChecker::TeamValidityChecker() */
        Partial(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles)
          : TeamValidityChecker(si, obstacles, Method::PARTIAL)
        {
        }

        /** \brief For one robot, in its own space or any that Team reads */
        Partial(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles, const RobotPtr &robot)
          : TeamValidityChecker(si, obstacles, {robot}, Method::PARTIAL)
        {
        }

        /** \brief For several robots, in any space that Team reads */
        Partial(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles,
                const std::vector<RobotPtr> &robots)
          : TeamValidityChecker(si, obstacles, robots, Method::PARTIAL)
        {
        }
    };
}

#endif
