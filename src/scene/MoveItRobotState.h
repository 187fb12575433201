#ifndef OMPL_CERTIFICATES_SCENE_MOVE_IT_ROBOT_STATE_
#define OMPL_CERTIFICATES_SCENE_MOVE_IT_ROBOT_STATE_

#include "YamlNode.h"
#include "ompl_certificates/scene/ArmFile.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief A number of a message, and where it is there */
    struct MoveItNumber
    {
        double value;
        YamlNode node;
    };

    /** \brief The values of joints, by their names */
    using MoveItJoints = std::map<std::string, MoveItNumber>;

    /** \brief What a scene or a request of MoveIt says of its robot */
    struct MoveItRobotState
    {
        /** \brief The values of joints */
        MoveItJoints joints;

        /** \brief Where the robot stands, if the message says so */
        std::optional<Pose> base;

        /** \brief The objects that it holds */
        std::vector<AttachedBody> attached;

        /** \brief What a user should know of each of them, by their names */
        std::map<std::string, std::vector<std::string>> notes;

        /** \brief Whether it says that it is no difference to another state */
        bool isWhole{false};
    };

    /** \brief A RobotState of \e robot; meshes of files are looked for in \e folder */
    MoveItRobotState readMoveItRobotState(const YamlNode &node, const ArmFile &robot, const std::string &folder);

    /** \brief The value of a joint that nobody tells: for MoveIt 0, or the middle of limits that 0 is not within */
    double moveItValueUntold(const KinematicTree::Joint &joint);

    /** \brief The value of a joint in a state; of one that follows another by that one's */
    double moveItValue(const MoveItRobotState &state, const KinematicTree &tree, const KinematicTree::Joint &joint);

    /** \brief The distances that a planning scene has links keep, by their names. Links cannot be scaled. */
    std::map<std::string, double> readMoveItPadding(const YamlNode &root, const KinematicTree &tree);
}

#endif
