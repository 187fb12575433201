#ifndef OMPL_CERTIFICATES_SCENE_MOVE_IT_OCTOMAP_
#define OMPL_CERTIFICATES_SCENE_MOVE_IT_OCTOMAP_

#include "MoveItFrames.h"
#include "YamlNode.h"
#include "ompl_certificates/obstacles/CellObstacles.h"

#include <memory>

namespace ompl_certificates
{
    /** \brief The name of the octomap in an allowed collision matrix */
    constexpr const char *MOVE_IT_OCTOMAP = "<octomap>";

    /** \brief The occupied cells of an OctomapWithPose; null if it has no data
        \throws ompl::Exception that names the node: if the map is damaged or turned, or if the library was built
        without octomap */
    std::shared_ptr<const CellObstacles> readMoveItOctomap(const YamlNode &node, const MoveItFrames &frames);
}

#endif
