#ifndef OMPL_CERTIFICATES_GEOMETRY_TRIAL_TEXT_
#define OMPL_CERTIFICATES_GEOMETRY_TRIAL_TEXT_

#include "ompl_certificates/geometry/Pose.h"

#include <ompl/base/StateSpace.h>
#include <ompl/util/Exception.h>
#include <string>

namespace ompl_certificates
{
    /** \brief A number, with enough digits to repeat a case */
    std::string textOf(double number);

    /** \brief (x, y, z) */
    std::string textOf(const Eigen::Vector3d &point);

    /** \brief The position of a pose, and its rotation as a quaternion (x, y, z, w) */
    std::string textOf(const Pose &pose);

    /** \brief The coordinates of a state, from OMPL's copyToReals() */
    std::string textOf(const ompl::base::StateSpace &space, const ompl::base::State *state);
}

#endif
