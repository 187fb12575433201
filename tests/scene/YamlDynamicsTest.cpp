#include "ompl_certificates/control/DynamicRobot.h"
#include "ompl_certificates/scene/SceneFile.h"

#include "support/Message.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    Scene sceneOf(const std::string &robot, bool dynamics = true)
    {
        return sceneFromYaml("environment: {min: [0, 0], max: [4, 4], obstacles: []}\nrobots:\n  - " + robot + "\n",
                             "scene.yaml", dynamics);
    }

    const DynamicRobot &robotOf(const Scene &scene)
    {
        return dynamic_cast<const DynamicRobot &>(*scene.getMembers().front().robot);
    }
}

TEST(YamlDynamicsTest, AllTypesHaveTheLimitsOfDbCbs)
{
    struct Type
    {
        const char *name, *state;
        unsigned int dimension;
        std::vector<double> controls;
    };
    const Type types[]{{"single_integrator_0", "[1, 1]", 2, {0.5, 0.5}},
                       {"double_integrator_0", "[1, 1, 0.1, 0.2]", 4, {2.0, 2.0}},
                       {"unicycle_first_order_0", "[1, 1, 0]", 3, {0.5, 0.5}},
                       {"unicycle_first_order_0_sphere", "[1, 1, 0]", 3, {0.5, 2.0}},
                       {"unicycle_second_order_0", "[1, 1, 0, 0.3, 0.4]", 5, {0.25, 0.25}},
                       {"car_first_order_0", "[1, 1, 0]", 3, {0.5, 1.0471975511965976}},
                       {"car_first_order_with_1_trailers_0", "[1, 1, 0, 0]", 4, {0.5, 1.0471975511965976}}};
    for (const Type &type : types)
    {
        const Scene scene =
            sceneOf(std::string("{type: ") + type.name + ", start: " + type.state + ", goal: " + type.state + "}");
        EXPECT_EQ(robotOf(scene).getStateSpace()->getDimension(), type.dimension) << type.name;
        EXPECT_EQ(robotOf(scene).getControlBounds().high, type.controls) << type.name;
        EXPECT_TRUE(scene.getNotes().empty()) << type.name;
        EXPECT_NO_THROW(scene.validate()) << type.name;
    }
    EXPECT_EQ(sceneOf("{type: unicycle_second_order_0, start: [1, 1, 0, 0.3, 0.4], goal: [2, 1, 0, 0, 0]}")
                  .getMembers()
                  .front()
                  .start,
              (std::vector<double>{1, 1, 0, 0.3, 0.4}));
}

TEST(YamlDynamicsTest, NotesThatSpeedsDoNotCount)
{
    const std::string robot = "{type: single_integrator, start: [1, 1], goal: [2, 2], speed: 3}";
    const Scene scene = sceneOf(robot);
    ASSERT_EQ(scene.getNotes().size(), 1U);
    EXPECT_EQ(scene.getNotes().front(), "speed of robot 'robot_0' does not count: it moves by controls");
    EXPECT_TRUE(sceneOf(robot, false).getNotes().empty());
}

TEST(YamlDynamicsTest, ErrorsNameFileKeyAndValue)
{
    EXPECT_NE(messageOf([] { sceneOf("{type: single_integrator, start: [1, 1], goal: {min: [2, 2], max: [3, 3]}}"); })
                  .find("scene.yaml:3: robots[0].goal: must be a list: with dynamics the goal is one state"),
              std::string::npos);
    EXPECT_NE(
        messageOf([]
                  { sceneOf("{type: rigid, space: R2, shape: {type: disc, radius: 1}, start: [1, 1], goal: [2, 2]}"); })
            .find("scene.yaml:3: robots[0].type: 'rigid' has no dynamics"),
        std::string::npos);
    EXPECT_NE(messageOf([] { sceneOf("{type: double_integrator_0, start: [1, 1], goal: [2, 2, 0, 0]}"); })
                  .find("robots[0].start"),
              std::string::npos);
    EXPECT_NE(
        messageOf([] { sceneOf("{type: double_integrator_0, start: [1, 1, 0.7, 0], goal: [2, 2, 0, 0]}").validate(); })
            .find("robots[0].start [1, 1, 0.7, 0] of 'robot_0' is outside the bounds"),
        std::string::npos);
    EXPECT_NE(messageOf(
                  [] {
                      sceneOf("{type: car_first_order_with_1_trailers_0, start: [1, 1, 0, 0], goal: [2, 2, 0, 1]}")
                          .validate();
                  })
                  .find("robots[0].goal [2, 2, 0, 1] of 'robot_0' turns the hinge too far"),
              std::string::npos);
}
