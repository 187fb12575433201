#ifndef OMPL_CERTIFICATES_SCENE_YAML_OCTOMAP_
#define OMPL_CERTIFICATES_SCENE_YAML_OCTOMAP_

#include "YamlNode.h"
#include "ompl_certificates/obstacles/Obstacles.h"

namespace ompl_certificates
{
    /** \brief The octomap that \e node describes: file, depth, unknown and, in the plane, heights
        \param source the scene's file, whose folder the map's path is relative to */
    ObstaclesPtr readOctomap(const YamlNode &node, unsigned int dimension, const std::string &source);
}

#endif
