#ifndef OMPL_CERTIFICATES_SCENE_YAML_GOAL_
#define OMPL_CERTIFICATES_SCENE_YAML_GOAL_

#include "YamlNode.h"
#include "ompl_certificates/scene/Scene.h"

#include <functional>
#include <vector>

namespace ompl_certificates
{
    /** \brief Read the goal of \e member, whose robot is known: one goal, or with the key any a list of them, each of
        which will do
        \param readState the coordinates that a node tells
        \param readRegion what other goal a node tells, such as a zone; null if it tells a state */
    void readGoal(const YamlNode &node, const std::function<std::vector<double>(const YamlNode &)> &readState,
                  const std::function<RobotGoalPtr(const YamlNode &)> &readRegion, Scene::Member &member);

    /** \brief Make one goal, or several of which any will do, that of \e member; see AnyOfGoals */
    void setGoals(const std::vector<std::vector<double>> &states, std::vector<RobotGoalPtr> goals,
                  Scene::Member &member);

    /** \brief A goal that is a box for the position of \e robot: its corners min and max */
    RobotGoalPtr readZone(const YamlNode &node, const RobotPtr &robot);
}

#endif
