#ifndef OMPL_CERTIFICATES_SCENE_YAML_SHAPES_
#define OMPL_CERTIFICATES_SCENE_YAML_SHAPES_

#include "YamlMeshes.h"
#include "YamlNode.h"
#include "ompl_certificates/geometry/Body.h"

namespace ompl_certificates
{
    /** \brief What is noted about an angle that is more than a whole turn */
    constexpr const char *ANGLE_NOTE = "an angle is more than a whole turn; angles are in radians";

    /** \brief An angle in radians; noted if it is more than a whole turn, as one in degrees mostly is */
    double readAngle(const YamlNode &node);

    /** \brief A distance: a number that is not negative */
    double readDistance(const YamlNode &node);

    /** \brief What \e node has under padding; 0 if it has none */
    double readPadding(const YamlNode &node);

    /** \brief What \e node has under rotation or under quaternion; no rotation if it has neither */
    Eigen::Matrix3d readRotation(const YamlNode &node);

    /** \brief Where a frame is in space: what \e node has under position, and under rotation or quaternion */
    Pose readFrame(const YamlNode &node);

    /** \brief What \e node has under center, and under angle, rotation or quaternion
        \param needsCenter whether the center must be given: for shapes that say nothing else of their place */
    Pose readPose(const YamlNode &node, unsigned int dimension, bool needsCenter);

    /** \brief The obstacle that \e node describes, in a workspace of \e dimension */
    PlacedBody readObstacle(const YamlNode &node, unsigned int dimension, YamlMeshes &meshes);

    /** \brief The zones that \e list describes as shapes, which a robot keeps out of */
    std::vector<PlacedBody> readZones(const YamlNode &list, unsigned int dimension, YamlMeshes &meshes);

    /** \brief The body of a robot: what \e node has under shape or under shapes */
    Body readBody(const YamlNode &node, unsigned int dimension, YamlMeshes &meshes);

    /** \brief A body of the one shape that \e node describes */
    Body readShape(const YamlNode &node, unsigned int dimension, YamlMeshes &meshes);
}

#endif
