#ifndef OMPL_CERTIFICATES_SCENE_MOVE_IT_FRAMES_
#define OMPL_CERTIFICATES_SCENE_MOVE_IT_FRAMES_

#include "MoveItRobotState.h"
#include "YamlNode.h"
#include "ompl_certificates/scene/ArmFile.h"

#include <map>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief The poses of frames in the workspace */
    using MoveItFrames = std::map<std::string, Pose>;

    /** \brief The frames that obstacles or goals can be in: those that the planning scene \e root fixes, and the links,
        where \e state has them. Links that the joints \e moving move are not among them. */
    MoveItFrames readMoveItFrames(const YamlNode &root, const ArmFile &robot, const MoveItRobotState &state,
                                  const std::vector<std::string> &moving);

    /** \brief The pose of the frame that the header of \e node names */
    const Pose &readMoveItFrame(const YamlNode &node, const MoveItFrames &frames);
}

#endif
