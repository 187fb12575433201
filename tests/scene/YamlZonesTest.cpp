// Zones that robots keep out of, in scene files

#include "ompl_certificates/control/DynamicRobot.h"
#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/planning/ProvePath.h"
#include "ompl_certificates/team/TeamPathLength.h"
#include "ompl_certificates/robots/ConfinedRobot.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "support/Message.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    const std::string ENVIRONMENT = "environment: {min: [0, 0], max: [10, 10]}\nrobots:\n";
    const std::string ZONES =
        "keep_out: [{type: box, center: [5, 5], size: [2, 4], angle: 0.5}, "
        "{type: disc, center: [8, 2], radius: 1}]";

    Scene sceneOf(const std::string &robots, bool dynamics = false)
    {
        return sceneFromYaml(ENVIRONMENT + robots, "zones", dynamics);
    }

    std::string messageOf(const std::string &robot)
    {
        return test::messageOf([&] { sceneOf("  - " + robot + "\n").validate(); });
    }
}

TEST(YamlZones, AreOfRigidRobotsAndCars)
{
    const Scene scene = sceneOf(
        "  - {type: rigid, space: SE2, shape: {type: box, size: [0.5, 0.2]}, start: [1, 1, 0], goal: [9, 9, 0], " +
        ZONES +
        "}\n  - {type: car_with_trailer, car: {type: disc, radius: 0.2}, trailer: {type: disc, radius: 0.1}, "
        "hitch_length: 0.5, start: [1, 4, 0, 0], goal: {min: [1, 1], max: [3, 3]}, " +
        ZONES + "}\n  - {type: single_integrator, start: [5, 5], goal: [8, 2]}\n");
    scene.validate();
    for (const std::size_t i : {std::size_t(0), std::size_t(1)})
    {
        const auto &robot = dynamic_cast<const ConfinedRobot &>(*scene.getMembers()[i].robot);
        ASSERT_EQ(robot.getZones().size(), 2U);
        EXPECT_EQ(robot.getZones()[0].pose.matrix(), planarPose(5.0, 5.0, 0.5).matrix());
        EXPECT_EQ(robot.getZones()[1].body, Body::disc(1.0));
        EXPECT_EQ(robot.getBodies().size(), robot.getRobot()->getBodies().size() + 2);
    }
}

TEST(YamlZones, AreOfRobotsWithDynamics)
{
    const std::vector<std::pair<std::string, std::string>> types{{"double_integrator", ", 0, 0"},
                                                                 {"unicycle_first_order", ", 0"},
                                                                 {"unicycle_second_order", ", 0, 0, 0"},
                                                                 {"car_first_order", ", 0"},
                                                                 {"car_first_order_with_1_trailers", ", 0, 0"}};
    for (const auto &[type, zeros] : types)
    {
        const Scene scene = sceneOf(
            "  - {type: " + type + ", start: [1, 1" + zeros + "], goal: [9, 9" + zeros + "], " + ZONES + "}\n", true);
        scene.validate();
        const Robot &robot = *scene.getMembers()[0].robot;
        EXPECT_TRUE(dynamic_cast<const DynamicRobot *>(&robot)) << type;
        const std::size_t count = robot.getBodies().size();
        EXPECT_TRUE(robot.isZone(count - 1) && robot.isZone(count - 2)) << type;
        EXPECT_FALSE(robot.isZone(count - 3)) << type;
    }
}

TEST(YamlZones, AreNamedInMessages)
{
    EXPECT_EQ(messageOf("{type: single_integrator, start: [8, 2], goal: [9, 9], " + ZONES + "}"),
              "zones: robots[0].start [8, 2] of 'robot_0' touches keep_out[1]");
    EXPECT_EQ(messageOf("{type: car_with_trailer, car: {type: disc, radius: 0.2}, trailer: {type: disc, radius: 0.1}, "
                        "hitch_length: 1.5, start: [1, 1, 0, 0], goal: [6.4, 5, 0, 0], " +
                        ZONES + "}"),
              "zones: robots[0].goal [6.4, 5, 0, 0] of 'robot_0' touches keep_out[0] with body 1");
}

TEST(YamlZones, HaveErrorsThatNameTheirKeys)
{
    const std::string robot = "{type: single_integrator, start: [1, 1], goal: [9, 9], keep_out: ";
    EXPECT_NE(messageOf(robot + "[]}").find("robots[0].keep_out: must have from 1 to"), std::string::npos);
    EXPECT_NE(messageOf(robot + "[{type: box, size: [1, 1]}]}").find("robots[0].keep_out[0].center"),
              std::string::npos);
    const std::string cloud = messageOf(robot + "[{type: cloud, file: a.pcd}]}");
    EXPECT_NE(cloud.find("robots[0].keep_out[0].type: must be one of box, disc, capsule, polygon, mesh, compound in 2"),
              std::string::npos)
        << cloud;
    EXPECT_NE(messageOf("{type: arm, links: [{length: 1, width: 0.1}], start: [0], goal: [1], " + ZONES + "}")
                  .find("keep_out"),
              std::string::npos);
}

TEST(YamlZones, AreDrivenAroundByTheirRobotsAlone)
{
    const Scene scene = loadScene(std::string(OMPL_CERTIFICATES_SOURCE_DIR) + "/demos/scenes/zones.yaml");
    const TeamSetupPtr setup = scene.makeSetup(Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS);
    auto objective = std::make_shared<TeamPathLength>(setup->getSpaceInformation());
    objective->setCostThreshold(objective->infiniteCost());
    setup->setOptimizationObjective(objective);
    ASSERT_EQ(setup->solve(60.0), ompl::base::PlannerStatus::EXACT_SOLUTION);
    ompl::geometric::PathGeometric &path = setup->getSolutionPath();
    EXPECT_TRUE(provePath(path, setup->getTeamChecker()).isProved());
    path.interpolate(2000);
    std::vector<std::size_t> within(4, 0);
    const FclObstacles zones(dynamic_cast<const ConfinedRobot &>(*scene.getMembers()[0].robot).getZones(), 2);
    for (const ompl::base::State *state : path.getStates())
        for (unsigned int i = 0; i < within.size(); ++i)
        {
            const Robot &robot = *scene.getMembers()[i].robot;
            std::vector<Pose> poses(robot.getBodies().size());
            robot.placeBodies(state->as<ompl::base::CompoundState>()->components[i], poses.data());
            within[i] += zones.collides(robot.getBodies().front(), poses.front()) ? 1 : 0;
        }
    EXPECT_EQ(within[0], 0U);
    EXPECT_EQ(within[1], 0U);
    EXPECT_GT(within[2], 1000U);
    EXPECT_GT(within[3], 10U);
}
