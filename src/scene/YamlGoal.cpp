#include "YamlGoal.h"

#include "ompl_certificates/robots/AnyOfGoals.h"
#include "ompl_certificates/robots/ZoneGoal.h"

#include <utility>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t MAX_GOALS = 10000;

        /** Whether a node lists goals. What an arm's state tells of a joint of that name is no list. */
        bool hasSeveral(const YamlNode &node)
        {
            return node.isMap() && node.has("any") && node.at("any").isList();
        }
    }

    void readGoal(const YamlNode &node, const std::function<std::vector<double>(const YamlNode &)> &readState,
                  const std::function<RobotGoalPtr(const YamlNode &)> &readRegion, Scene::Member &member)
    {
        if (!hasSeveral(node))
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
                // It tells where a state is that is out of the bounds.
                item.orFail([&] { return AnyOfGoals(member.robot, {states.back()}); });
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
