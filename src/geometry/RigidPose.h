#ifndef OMPL_CERTIFICATES_GEOMETRY_RIGID_POSE_
#define OMPL_CERTIFICATES_GEOMETRY_RIGID_POSE_

#include "ompl_certificates/geometry/Pose.h"

#include <string>

namespace ompl_certificates
{
    /** \brief \e pose with a true rotation. Turns that are written with three decimals, or come from single precision,
        are not quite rotations: bodies would be larger for one check than for another.
        \param owner for messages, what the pose belongs to
        \throws ompl::Exception if the pose is not finite, scales or mirrors */
    Pose rigidPose(const Pose &pose, const std::string &owner);
}

#endif
