// Goals of more than one state, in scene files

#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/robots/ZoneGoal.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "support/Message.h"

#include <gtest/gtest.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

namespace ompl_certificates
{
    using namespace test;

    TEST(YamlGoal, CanBeAZone)
    {
        const std::string text =
            "environment: {min: [0, 0], max: [10, 10], obstacles: [{type: box, center: [8, 8], size: [1, 1]}]}\n"
            "robots:\n"
            "  - {type: single_integrator, start: [1, 1], goal: {min: [7, 7], max: [9, 9]}}\n"
            "  - {type: rigid, space: SE2, shape: {type: box, size: [0.5, 0.2]}, start: [1, 2, 0], goal: [9.2, 1, 0]}\n"
            "  - {type: car_with_trailer, car: {type: disc, radius: 0.2}, trailer: {type: disc, radius: 0.1}, "
            "hitch_length: 0.5, start: [1, 4, 0, 0], goal: {min: [7, 7], max: [9, 9]}}\n";
        const Scene scene = sceneFromYaml(text, "zones");
        scene.validate();
        EXPECT_TRUE(scene.hasRegions());
        EXPECT_FALSE(scene.getMembers()[1].region);
        for (const std::size_t i : {std::size_t(0), std::size_t(2)})
        {
            const auto &member = scene.getMembers()[i];
            const auto &zone = dynamic_cast<const ZoneGoal &>(*member.region);
            EXPECT_EQ(zone.getBox().low, (std::vector<double>{7, 7}));
            EXPECT_EQ(zone.getBox().high, (std::vector<double>{9, 9}));
            EXPECT_GE(member.goal[0], 7.0);
            EXPECT_LE(member.goal[0], 9.0);
        }
        EXPECT_EQ(scene.getMembers()[0].goal, sceneFromYaml(text, "zones").getMembers()[0].goal)
            << "a file has one goal";
        const auto setup = scene.makeSetup();
        // Not the optimizing planner of the setup, which would take all of its time
        setup->setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup->getSpaceInformation()));
        ASSERT_EQ(setup->solve(20.0), ompl::base::PlannerStatus::EXACT_SOLUTION);
        EXPECT_TRUE(setup->getGoal()->isSatisfied(setup->getSolutionPath().getStates().back()));
        EXPECT_TRUE(setup->getSolutionPath().check());

        const std::string full =
            "environment: {min: [0, 0], max: [10, 10], obstacles: [{type: box, center: [8, 8], size: [3, 3]}]}\n"
            "robots: [{type: single_integrator, start: [1, 1], goal: {min: [7, 7], max: [9, 9]}}]\n";
        EXPECT_NE(messageOf([&] { sceneFromYaml(full, "full").validate(); })
                      .find("full: robots[0].goal, where no free state was found: ["),
                  std::string::npos);
        EXPECT_EQ(messageOf(
                      []
                      {
                          sceneFromYaml(
                              "environment: {min: [0, 0], max: [5, 5]}\nrobots: [{type: single_integrator, "
                              "start: [1, 1], goal: {min: [7, 7], max: [9, 9]}}]\n",
                              "far");
                      }),
                  "far:2: robots[0].goal: robot_0: goal: the box is out of the bounds");
    }

    TEST(YamlGoal, CanBeAnyOfSeveral)
    {
        const std::string begin =
            "environment: {min: [0, 0], max: [10, 10], obstacles: [{type: box, center: [8, 8], size: "
            "[3, 3]}]}\nrobots:\n  - {type: rigid, space: SE2, shape: {type: box, size: [0.5, "
            "0.2]}, start: [1, 2, 0], goal: ";
        const auto readWith = [&](const std::string &goal) { return sceneFromYaml(begin + goal + "}\n", "docks"); };
        // The first is blocked.
        const Scene scene = readWith("{any: [[8, 8, 0], [9, 1, -4], {min: [1, 9], max: [2, 9.5]}]}");
        scene.validate();
        const Scene::Member &member = scene.getMembers()[0];
        EXPECT_EQ(member.region->describe(), "any of its 3 goals");
        const auto setup = scene.makeSetup();
        ASSERT_EQ(setup->solve(5.0), ompl::base::PlannerStatus::EXACT_SOLUTION);
        EXPECT_TRUE(setup->getGoal()->isSatisfied(setup->getSolutionPath().getStates().back()));
        EXPECT_EQ(readWith("{any: [[9, 1, 0.5]]}").getMembers()[0].goal, (std::vector<double>{9, 1, 0.5}));
        EXPECT_FALSE(readWith("{any: [[9, 1, 0.5]]}").hasRegions());

        const std::pair<std::string, std::string> wrong[] = {
            {"{any: []}", "docks:3: robots[0].goal.any: must have from 1"},
            {"{any: [[1, 1, 0], [1, 1]]}", "docks:3: robots[0].goal.any[1]: must be a list of 3 numbers"},
            {"{any: [[1, 1, 0], [1, 11, 0]]}", "docks:3: robots[0].goal.any[1]: is outside the bounds: y is 11"},
            {"{any: [[1, 1, 0]], min: [1, 1]}", "docks:3: robots[0].goal.min: unknown key"},
            {"{any: 3}", "docks:3: robots[0].goal.any: must be a list"},
            {"{any: [{min: [20, 20], max: [30, 30]}]}",
             "docks:3: robots[0].goal.any[0]: robot_0: goal: the box is out"}};
        for (const auto &[goal, message] : wrong)
            EXPECT_EQ(messageOf([&, &text = goal] { readWith(text); }).rfind(message, 0), 0U)
                << messageOf([&, &text = goal] { readWith(text); });
    }
}
