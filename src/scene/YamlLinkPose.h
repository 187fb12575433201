#ifndef OMPL_CERTIFICATES_SCENE_YAML_LINK_POSE_
#define OMPL_CERTIFICATES_SCENE_YAML_LINK_POSE_

#include "YamlNode.h"
#include "ompl_certificates/robots/LinkPoseGoal.h"

namespace ompl_certificates
{
    /** \brief Whether \e node, the goal of an arm of \e tree, is the pose of a link: a map with the key link, or with
        others of such a pose. A joint may have these names, too. */
    bool isLinkPose(const YamlNode &node, const KinematicTree &tree);

    /** \brief The goal of \e arm that \e node describes; see docs/scene-format.md */
    RobotGoalPtr readLinkPoseGoal(const YamlNode &node, const std::shared_ptr<const Arm> &arm);
}

#endif
