#ifndef OMPL_CERTIFICATES_PLANNING_ROBOT_SPACE_INFORMATION_
#define OMPL_CERTIFICATES_PLANNING_ROBOT_SPACE_INFORMATION_

#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <ompl/base/SpaceInformation.h>

namespace ompl_certificates
{
    /** \brief A space information for one robot of a team alone among the obstacles. \e checker must outlive it. */
    ompl::base::SpaceInformationPtr makeRobotSpaceInformation(const TeamValidityChecker &checker, unsigned int robot);
}

#endif
