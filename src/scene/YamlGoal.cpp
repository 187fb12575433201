#include "YamlGoal.h"

#include "ompl_certificates/robots/AnyOfGoals.h"
#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/robots/ZoneGoal.h"
#include "ompl_certificates/team/Coordinates.h"

#include <ompl/base/ScopedState.h>
#include <utility>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t MAX_GOALS = 10000;

        /** Whether a node lists goals. An arm's state may tell of a joint of that name. */
        bool hasSeveral(const YamlNode &node, const Robot &robot)
        {
            if (!node.isMap() || !node.has("any"))
                return false;
            const auto *arm = dynamic_cast<const Arm *>(&robot);
            return !arm || !arm->getTree().hasJoint("any") || node.at("any").isList();
        }

        void requireBounds(const YamlNode &node, const Robot &robot, const std::vector<double> &coordinates)
        {
            ompl::base::ScopedState<> state(robot.getStateSpace());
            state = coordinates;
            if (const std::string why = describeOutOfBounds(robot, state.get()); !why.empty())
                node.fail(why);
        }
    }

    void readGoal(const YamlNode &node, const std::function<std::vector<double>(const YamlNode &)> &readState,
                  const std::function<RobotGoalPtr(const YamlNode &)> &readRegion, Scene::Member &member)
    {
        if (!hasSeveral(node, *member.robot))
        {
            member.region = readRegion(node);
            if (!member.region)
                member.goal = readState(node);
            return;
        }
        node.allow({"any"});
        std::vector<std::vector<double>> states;
        std::vector<RobotGoalPtr> goals;
        for (const YamlNode &item : node.at("any").items(1, MAX_GOALS))
            if (RobotGoalPtr goal = readRegion(item))
                goals.push_back(std::move(goal));
            else
            {
                states.push_back(readState(item));
                requireBounds(item, *member.robot, states.back());
            }
        setGoals(states, std::move(goals), member);
    }

    void setGoals(const std::vector<std::vector<double>> &states, std::vector<RobotGoalPtr> goals,
                  Scene::Member &member)
    {
        if (states.size() + goals.size() > 1)
            member.region = std::make_shared<AnyOfGoals>(member.robot, states, std::move(goals));
        else if (!goals.empty())
            member.region = goals.front();
        else
            member.goal = states.front();
    }

    RobotGoalPtr readZone(const YamlNode &node, const RobotPtr &robot)
    {
        node.allow({"min", "max"});
        const unsigned int dimension = robot->getWorkspaceDimension();
        ompl::base::RealVectorBounds box(dimension);
        box.low = node.at("min").numbers(dimension);
        box.high = node.at("max").numbers(dimension);
        const auto low = node.at("min").items(dimension, dimension), high = node.at("max").items(dimension, dimension);
        for (unsigned int i = 0; i < dimension; ++i)
            if (box.high[i] < box.low[i])
                high[i].fail("must not be below min, which is " + low[i].describe() + ", but is " + high[i].describe());
        return node.orFail([&] { return std::make_shared<ZoneGoal>(robot, box); });
    }
}
