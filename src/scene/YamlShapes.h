#ifndef OMPL_CERTIFICATES_SCENE_YAML_SHAPES_
#define OMPL_CERTIFICATES_SCENE_YAML_SHAPES_

#include "YamlMeshes.h"
#include "YamlNode.h"
#include "ompl_certificates/geometry/Body.h"

namespace ompl_certificates
{
    /** \brief What \e node has under rotation or under quaternion; no rotation if it has neither */
    Eigen::Matrix3d readRotation(const YamlNode &node);

    /** \brief What \e node has under center, and under angle, rotation or quaternion
        \param needsCenter whether the center must be given: for shapes that say nothing else of their place */
    Pose readPose(const YamlNode &node, unsigned int dimension, bool needsCenter);

    /** \brief The obstacle that \e node describes, in a workspace of \e dimension */
    PlacedBody readObstacle(const YamlNode &node, unsigned int dimension, YamlMeshes &meshes);

    /** \brief The body of a robot: what \e node has under shape or under shapes */
    Body readBody(const YamlNode &node, unsigned int dimension, YamlMeshes &meshes);

    /** \brief A body of the one shape that \e node describes */
    Body readShape(const YamlNode &node, unsigned int dimension, YamlMeshes &meshes);
}

#endif
