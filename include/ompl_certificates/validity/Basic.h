#ifndef OMPL_CERTIFICATES_VALIDITY_BASIC_
#define OMPL_CERTIFICATES_VALIDITY_BASIC_

#include "ompl_certificates/validity/TeamValidityChecker.h"

namespace ompl_certificates
{
    /** \brief The Basic Certificate method: the team certificate of a near state certifies all robots at once, or
        nothing.

        A team certificate holds one clearance for each body. It is made when a whole state was checked and found free.
        States hand it on by reference, so the near state is the one that a planner extends or checks from. This is the
        method for single robots, applied to a team unchanged. It is kept for comparison; it degrades with the number of
        robots.

        @par External documentation
        J. Bialkowski, M. Otte, E. Frazzoli, Fast Collision Checking: From Single Robots to Multi-Robot Teams, 2013,
        section II-A. */
    class Basic : public TeamValidityChecker
    {
    public:
        /** \brief For the team of a TeamStateSpace; see TeamValidityChecker::TeamValidityChecker() */
        Basic(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles)
          : TeamValidityChecker(si, obstacles, Method::BASIC)
        {
        }

        /** \brief For one robot, in its own space or any that Team reads */
        Basic(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles, const RobotPtr &robot)
          : TeamValidityChecker(si, obstacles, {robot}, Method::BASIC)
        {
        }

        /** \brief For several robots, in any space that Team reads */
        Basic(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles,
              const std::vector<RobotPtr> &robots)
          : TeamValidityChecker(si, obstacles, robots, Method::BASIC)
        {
        }
    };
}

#endif
