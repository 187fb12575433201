#ifndef OMPL_CERTIFICATES_SCENE_YAML_ROBOTS_
#define OMPL_CERTIFICATES_SCENE_YAML_ROBOTS_

#include "YamlArms.h"
#include "YamlMeshes.h"
#include "YamlNode.h"
#include "ompl_certificates/scene/Scene.h"

namespace ompl_certificates
{
    /** \brief Bounds of a workspace of \e dimension: what \e node has under min and max */
    ompl::base::RealVectorBounds readBounds(const YamlNode &node, unsigned int dimension);

    /** \brief Add the robot that \e node describes to \e scene
        \param dynamics whether it moves by controls; see readSceneFile() */
    void readRobot(const YamlNode &node, bool dynamics, Scene &scene, YamlMeshes &meshes, YamlArms &arms);
}

#endif
