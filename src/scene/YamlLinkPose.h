#ifndef OMPL_CERTIFICATES_SCENE_YAML_LINK_POSE_
#define OMPL_CERTIFICATES_SCENE_YAML_LINK_POSE_

#include "YamlNode.h"
#include "ompl_certificates/robots/LinkPoseGoal.h"

namespace ompl_certificates
{
    /** \brief The goal of \e arm that \e node describes if it is the pose of a link, else null: a map with the key
        link, or with others of such a pose. A joint may have these names, too. See docs/scene-format.md. */
    RobotGoalPtr readLinkPoseGoal(const YamlNode &node, const std::shared_ptr<const Arm> &arm);
}

#endif
