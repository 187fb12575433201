#ifndef OMPL_CERTIFICATES_SCENE_MOVE_IT_GOAL_
#define OMPL_CERTIFICATES_SCENE_MOVE_IT_GOAL_

#include "MoveItFrames.h"
#include "MoveItRobotState.h"
#include "YamlNode.h"
#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/scene/ArmFile.h"
#include "ompl_certificates/scene/Scene.h"

#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief The values of joints as coordinates of the group of \e arm; \e node is where a message says that one is
        missing */
    std::vector<double> moveItCoordinates(const YamlNode &node, const Arm &arm, const MoveItJoints &values);

    /** \brief Read the goal of \e member, whose robot is an arm of \e robot, from the Constraints that \e node lists,
        any of which will do: each is for all joints of the group, or the pose of a link.
        \param start where the joints are that the group does not move
        \param notes what a user should know is added here */
    void readMoveItGoal(const YamlNode &node, const ArmFile &robot, const MoveItFrames &frames,
                        const MoveItRobotState &start, Scene::Member &member, std::vector<std::string> &notes);
}

#endif
