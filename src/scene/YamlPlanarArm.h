#ifndef OMPL_CERTIFICATES_SCENE_YAML_PLANAR_ARM_
#define OMPL_CERTIFICATES_SCENE_YAML_PLANAR_ARM_

#include "YamlMeshes.h"
#include "YamlNode.h"
#include "ompl_certificates/scene/Scene.h"

namespace ompl_certificates
{
    /** \brief Read a chain of links in the plane, a robot of type arm: robot, start and goal of \e member */
    void readPlanarArm(const YamlNode &node, const std::string &name, YamlMeshes &meshes, Scene::Member &member);
}

#endif
