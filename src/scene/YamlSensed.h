#ifndef OMPL_CERTIFICATES_SCENE_YAML_SENSED_
#define OMPL_CERTIFICATES_SCENE_YAML_SENSED_

#include "YamlNode.h"
#include "ompl_certificates/obstacles/Obstacles.h"

namespace ompl_certificates
{
    /** \brief The point cloud that \e node describes, in a workspace of \e dimension */
    ObstaclesPtr readCloud(const YamlNode &node, unsigned int dimension);

    /** \brief The octomap that \e node describes: file, depth, unknown, origin and, in the plane, heights. Fails if the
        program was built without octomap. */
    ObstaclesPtr readOctomap(const YamlNode &node, unsigned int dimension);

    /** \brief The map of ROS's map_server that \e node describes: file and unknown */
    ObstaclesPtr readOccupancyMap(const YamlNode &node, unsigned int dimension);

    /** \brief The key \c unknown of a map, by default free */
    bool readUnknownIsOccupied(const YamlNode &node);
}

#endif
