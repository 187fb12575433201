#ifndef OMPL_CERTIFICATES_PLANNING_ROBOT_SPACE_INFORMATION_
#define OMPL_CERTIFICATES_PLANNING_ROBOT_SPACE_INFORMATION_

#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include <ompl/base/SpaceInformation.h>

namespace ompl_certificates
{
    /** \brief A space information for one robot of a team alone among the obstacles. Motions are valid in the mode of
        \e validator, which must outlive it. */
    ompl::base::SpaceInformationPtr makeRobotSpaceInformation(const CertificateMotionValidator &validator,
                                                              unsigned int robot);
}

#endif
