#ifndef OMPL_CERTIFICATES_SCENE_MOVE_IT_PLANES_
#define OMPL_CERTIFICATES_SCENE_MOVE_IT_PLANES_

#include "YamlNode.h"
#include "ompl_certificates/robots/Arm.h"

#include <map>
#include <string>

namespace ompl_certificates
{
    /** \brief The frame whose x and y axes span the plane of a Plane message: a x + b y + c z + d = 0
        \throws ompl::Exception that names \e node, unless a, b and c are a normal */
    Pose readMoveItPlane(const YamlNode &node);

    /** \brief An upper bound of the distance of any point of the arm from the origin of its root link, for all values
        of its joints
        \param jointValues values of joints that the arm does not move; no such joint is PLANAR or FLOATING */
    double reachOf(const Arm &arm, const std::map<std::string, double> &jointValues);

    /** \brief The part of a plane that a body can touch which stays within \e reach of \e center: a square, two
        triangles without an inside, as FCL's own plane has none */
    PlacedBody planeWithin(const Pose &plane, const Eigen::Vector3d &center, double reach);
}

#endif
