#include "ompl_certificates/robots/CarWithTrailer.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "files/WholeFile.h"
#include "support/DecimalCommas.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace fs = std::filesystem;

    namespace
    {
        std::vector<fs::path> yamlFiles(const fs::path &folder)
        {
            std::vector<fs::path> files;
            if (fs::is_directory(folder))
                for (const auto &entry : fs::directory_iterator(folder))
                    if (entry.path().extension() == ".yaml")
                        files.push_back(entry.path());
            std::sort(files.begin(), files.end());
            return files;
        }

        /** What is thrown, or "" */
        template <typename Function>
        std::string messageOf(const Function &function)
        {
            try
            {
                function();
            }
            catch (const ompl::Exception &exception)
            {
                return exception.what();
            }
            return "";
        }

        const fs::path DB_CBS = fs::path(OMPL_CERTIFICATES_SHARED_DIR) / "scenes" / "db-cbs";
        const fs::path SOURCE = OMPL_CERTIFICATES_SOURCE_DIR;
    }

    TEST(YamlFile, ReadsEveryFileOfDbCbs)
    {
        const auto files = yamlFiles(DB_CBS);
        if (files.empty())
            GTEST_SKIP() << DB_CBS << " is not there";
        for (const auto &file : files)
        {
            SCOPED_TRACE(file.string());
            const Scene scene = loadScene(file.string());
            EXPECT_EQ(scene.getDimension(), 2u);
            EXPECT_FALSE(scene.getMembers().empty());
            const std::string message = messageOf([&] { scene.validate(); });
            if (file.stem() == "infeasible_0")
            {
                EXPECT_NE(message.find("infeasible_0.yaml: robots[0].goal [2.5, 2.5, 0]"), std::string::npos)
                    << message;
                EXPECT_NE(message.find("robots[1].goal [2.5, 2.5, 3.14]"), std::string::npos) << message;
                EXPECT_NE(message.find("overlap"), std::string::npos) << message;
            }
            else
                EXPECT_EQ(message, "");
        }
    }

    TEST(YamlFile, IsReadInAnyLocale)
    {
        const test::DecimalCommas commas;
        const Scene scene = sceneFromYaml(
            "environment: {min: [0.5, 0], max: [9.5, 9]}\n"
            "robots: [{type: single_integrator, start: [1.25, 1], goal: [2.5, 2]}]\n",
            "commas");
        EXPECT_EQ(scene.getMembers()[0].start, (std::vector<double>{1.25, 1.0}));
        EXPECT_EQ(scene.getBounds().high[0], 9.5);
    }

    TEST(YamlFile, NotesDroppedVelocities)
    {
        const Scene scene = sceneFromYaml(
            "environment: {min: [0, 0], max: [5, 5]}\n"
            "robots: [{type: double_integrator_0, start: [1, 2, 9, 9], "
            "goal: [3, 3, 0, 0]}]",
            "velocities.yaml");
        ASSERT_EQ(scene.getNotes().size(), 1u);
        EXPECT_NE(scene.getNotes()[0].find("velocities of robot 'robot_0' dropped"), std::string::npos);
        EXPECT_EQ(scene.getMembers()[0].start, (std::vector<double>{1.0, 2.0}));
        EXPECT_EQ(scene.getName(), "velocities");
    }

    TEST(YamlFile, NotesThatDynamicsDoNotCount)
    {
        const Scene scene = sceneFromYaml(
            "environment: {min: [0, 0], max: [5, 5]}\n"
            "robots: [{type: unicycle_second_order_0, start: [1, 2, 0, 0, 0], goal: [3, 3, 0, 0, 0]}, "
            "{type: single_integrator_0, start: [1, 4], goal: [4, 4]}]",
            "unicycle");
        EXPECT_EQ(scene.getNotes(),
                  (std::vector<std::string>{"velocities of robot 'robot_0' dropped: plans are geometric",
                                            "robot 'robot_0' may move in any direction: plans are geometric"}));
    }

    TEST(YamlFile, KnowsTypesWithAndWithoutVersion)
    {
        for (const std::string type : {"unicycle_first_order", "unicycle_first_order_0", "unicycle_first_order_sphere",
                                       "unicycle_first_order_0_sphere", "car_first_order", "car_first_order_0"})
        {
            SCOPED_TRACE(type);
            const Scene scene = sceneFromYaml("environment: {min: [0, 0], max: [5, 5]}\nrobots: [{type: " + type +
                                                  ", start: [1, 2, 0], goal: [3, 3, 1]}]",
                                              "types");
            EXPECT_EQ(scene.getMembers()[0].robot->getBodies()[0].isBall(), type.find("sphere") != std::string::npos);
        }
    }

    TEST(YamlFile, CarsDriveAlongCurves)
    {
        const std::string car =
            "  - {type: rigid, space: ReedsShepp, turning_radius: 2, "
            "shape: {type: box, size: [1, 0.5]}, start: [2, 2, 0], goal: ";
        const Scene scene = sceneFromYaml("environment: {min: [0, 0], max: [9, 9]}\nrobots:\n" + car + "[2, 4, 0]}\n" +
                                              car + "{min: [7, 7], max: [8, 8]}}\n",
                                          "cars");
        for (const Scene::Member &member : scene.getMembers())
        {
            EXPECT_EQ(dynamic_cast<const RigidRobot &>(*member.robot).getTurningRadius(), 2.0);
            EXPECT_TRUE(dynamic_cast<const ompl::base::ReedsSheppStateSpace *>(member.robot->getStateSpace().get()));
        }
        EXPECT_TRUE(scene.hasRegions());
    }

    TEST(YamlFile, WrapsHeadings)
    {
        const Scene scene = sceneFromYaml(
            "environment: {min: [0, 0], max: [5, 5]}\n"
            "robots: [{type: car_first_order_with_1_trailers_0, "
            "start: [1, 2, 4, -10], goal: [3, 3, 3.141592653589793, 3]}]",
            "angles");
        const auto &member = scene.getMembers()[0];
        EXPECT_NEAR(member.start[2], 4.0 - 2.0 * M_PI, 1e-15);
        EXPECT_NEAR(member.start[3], -10.0 + 4.0 * M_PI, 1e-14);
        EXPECT_EQ(member.goal[2], -M_PI);
        EXPECT_EQ(member.goal[3], 3.0);
        EXPECT_EQ(scene.getNotes(),
                  (std::vector<std::string>{"robot 'robot_0' may move in any direction: plans are geometric",
                                            "robots[0].start: an angle is more than a whole turn; angles "
                                            "are in radians"}));
        scene.validate();
    }

    TEST(YamlFile, ReadsWhetherATrailerMustNotTouchItsCar)
    {
        for (const std::string key : {"", "self_collision: false, ", "self_collision: true, "})
        {
            const Scene scene = sceneFromYaml(
                "environment: {min: [0, 0], max: [5, 5]}\n"
                "robots: [{type: car_with_trailer, car: {type: box, size: [0.6, 0.4]}, "
                "trailer: {type: box, size: [0.5, 0.4]}, hitch_length: 0.6, " +
                    key + "start: [1, 2, 0, 0], goal: [3, 3, 0, 0]}]",
                "trailers");
            EXPECT_EQ(scene.getMembers()[0].robot->getBodyPairs().empty(), key != "self_collision: true, ");
        }
    }

    TEST(YamlFile, NormalisesQuaternions)
    {
        const Scene scene = sceneFromYaml(
            "environment: {min: [0, 0, 0], max: [5, 5, 5]}\n"
            "robots: [{type: rigid, space: SE3, shape: {type: point}, "
            "start: [1, 2, 3, 0, 0, 3, 4], goal: [1, 1, 1, 0, 0, 0, 1]}]",
            "quaternions");
        EXPECT_EQ(scene.getMembers()[0].start, (std::vector<double>{1, 2, 3, 0, 0, 0.6, 0.8}));
        EXPECT_EQ(scene.getNotes().size(), 1u);
        scene.validate();
    }

    TEST(YamlFile, PlacesShapes)
    {
        const Scene scene = sceneFromYaml(
            "environment:\n  min: [0, 0]\n  max: [9, 9]\n  obstacles:\n"
            "    - {type: box, center: [2, 2], size: [2, 0.2], angle: 1.5707963267948966}\n"
            "    - {type: compound, center: [6, 6], angle: 1.5707963267948966,\n"
            "       shapes: [{type: disc, center: [1, 0], radius: 0.1}, {type: disc, center: [-1, 0], radius: 0.1}]}\n"
            "robots: [{type: rigid, space: SE2, shape: {type: disc, center: [1, 0], radius: 0.5}, start: [4, 4, 0], "
            "goal: [4, 5, 0]}]",
            "places");
        const auto obstacles = scene.makeObstacles();
        EXPECT_NEAR(obstacles->clearance({2.0, 4.0, 0.0}), 1.0, 1e-12);
        EXPECT_NEAR(obstacles->clearance({6.0, 7.5, 0.0}), 0.4, 1e-12);
        EXPECT_NEAR(obstacles->clearance({6.0, 4.8, 0.0}), 0.1, 1e-12);
        EXPECT_NEAR(scene.getMembers()[0].robot->getBodies()[0].signedDistance({1.0, 1.0, 0.0}), 0.5, 1e-12);
    }

    TEST(YamlFile, TakesPolytopesOfManyCorners)
    {
        std::string corners;
        for (std::size_t i = 0; i < MAX_HULL_POINTS; ++i)
        {
            const double z = 2.0 * (static_cast<double>(i) + 0.5) / MAX_HULL_POINTS - 1.0,
                         angle = 2.4 * static_cast<double>(i);
            const double radius = std::sqrt(1.0 - z * z);
            corners += (i == 0 ? "[" : ", [") + std::to_string(radius * std::cos(angle)) + ", " +
                       std::to_string(radius * std::sin(angle)) + ", " + std::to_string(z) + "]";
        }
        const Scene scene = sceneFromYaml(
            "environment: {min: [0, 0, 0], max: [9, 9, 9]}\nrobots: [{type: rigid, space: R3, start: [1, 1, 1], goal: "
            "[8, 8, 8], shape: {type: polytope, vertices: [" +
                corners + "]}}]",
            "ball");
        EXPECT_NO_THROW(scene.validate());
    }

    TEST(YamlFile, MakesSetupsThatPlan)
    {
        for (const auto &file : yamlFiles(SOURCE / "demos" / "scenes"))
        {
            SCOPED_TRACE(file.string());
            // Its largest mesh is made when the demos are built.
            if (file.stem() == "canyon" && !fs::exists(file.parent_path() / "canyon_terrain.obj"))
                continue;
            const Scene scene = loadScene(file.string());
            EXPECT_EQ(messageOf([&] { scene.validate(); }), "");
            const TeamSetupPtr setup = scene.makeSetup();
            setup->setup();
            const auto &si = setup->getSpaceInformation();
            EXPECT_TRUE(si->satisfiesBounds(setup->getProblemDefinition()->getStartState(0)));
            EXPECT_TRUE(si->isValid(setup->getProblemDefinition()->getStartState(0)));
        }
        EXPECT_EQ(yamlFiles(SOURCE / "demos" / "scenes").size(), 14u);
    }

    TEST(YamlFile, ReadsTheExamplesOfItsDocumentation)
    {
        const std::string doc = readWholeFile((SOURCE / "docs" / "scene-format.md").string());
        std::size_t count = 0;
        for (std::size_t begin = doc.find("```yaml\n"); begin != std::string::npos;
             begin = doc.find("```yaml\n", begin))
        {
            begin += 8;
            const Scene scene =
                sceneFromYaml(doc.substr(begin, doc.find("```", begin) - begin), "example " + std::to_string(count));
            EXPECT_EQ(messageOf([&] { scene.validate(); }), "");
            ++count;
        }
        EXPECT_EQ(count, 2u);
    }

    TEST(Scene, KeepsAllElseWithFewerRobots)
    {
        const std::string robot = "type: rigid, space: R2, start: [1, 1], goal: [4, 4], shape: {type: disc, radius: 1}";
        const Scene scene = sceneFromYaml(
            "resolution: 0.02\nenvironment: {min: [0, 0], max: [5, 5], obstacles: "
            "[{type: box, center: [3, 1], size: [1, 1]}]}\nrobots: [{name: a, " +
                robot + "}, {name: b, " + robot + "}, {name: c, " + robot + "}]",
            "three");
        const Scene two = scene.withFirstRobots(2);
        ASSERT_EQ(two.getMembers().size(), 2u);
        EXPECT_EQ(two.getMembers()[1].robot, scene.getMembers()[1].robot);
        EXPECT_EQ(two.getObstacles().size(), 1u);
        EXPECT_EQ(two.getResolution(), 0.02);
        EXPECT_EQ(two.getName(), "three");
        EXPECT_EQ(scene.withFirstRobots(4).getMembers().size(), 3u);
    }

    TEST(YamlFile, SetsTheResolution)
    {
        const std::string rest =
            "environment: {min: [0, 0], max: [5, 5]}\n"
            "robots: [{type: single_integrator_0, start: [1, 2], goal: [3, 3], weight: 3}]";
        const auto fine = sceneFromYaml("resolution: 0.002\n" + rest, "fine").makeTeam();
        EXPECT_EQ(fine->getLongestValidSegmentFraction(), 0.002);
        EXPECT_EQ(fine->getSubspaceWeight(0), 3.0);
    }

    TEST(YamlFile, RobotsHaveSpeeds)
    {
        const auto scene = sceneFromYaml(
            "environment: {min: [0, 0], max: [5, 5]}\n"
            "robots:\n"
            "  - {type: single_integrator_0, start: [1, 2], goal: [3, 3]}\n"
            "  - {type: rigid, space: R2, shape: {type: disc, radius: 0.1}, start: [1, 4], goal: [3, 4], speed: 2.5}",
            "fast");
        const auto team = scene.makeTeam();
        EXPECT_EQ(team->getSpeed(0), 1.0);
        EXPECT_EQ(team->getSpeed(1), 2.5);
        EXPECT_EQ(scene.makeSetup()->getTeam().getSpeed(1), 2.5);
    }

    TEST(YamlFile, NamesFilesThatCannotBeRead)
    {
        const fs::path missing = fs::temp_directory_path() / "ompl_certificates_no_such_file.yaml";
        EXPECT_EQ(messageOf([&] { loadScene(missing.string()); }).find(missing.string() + ": cannot be read"), 0u);
        const std::string folder = fs::temp_directory_path().string();
        EXPECT_EQ(messageOf([&] { loadScene(folder); }), folder + ": is a directory, not a file");
    }

    TEST(Scene, ValidateNamesWhatIsWrong)
    {
        const auto validate = [](const std::string &robots)
        {
            const auto scene = sceneFromYaml(
                "environment: {min: [0, 0], max: [5, 5], obstacles: [{type: disc, center: "
                "[9, 9], radius: 1}, {type: disc, center: [4, 4], radius: 0.5}]}\n"
                "robots: [" +
                    robots + "]",
                "file.yaml");
            return messageOf([&] { scene.validate(); });
        };
        EXPECT_EQ(validate("{type: single_integrator, start: [1, 1], goal: [2, 2]}"), "");
        EXPECT_EQ(validate("{type: single_integrator, name: a, start: [6, 1], goal: [2, 2]}"),
                  "file.yaml: robots[0].start [6, 1] of 'a' is outside the bounds: x is 6, not from 0 to 5");
        EXPECT_EQ(validate("{type: single_integrator, name: a, start: [1, 1], goal: [4, 4.55]}"),
                  "file.yaml: robots[0].goal [4, 4.55] of 'a' touches environment.obstacles[1]");
        EXPECT_EQ(validate("{type: single_integrator, name: a, start: [1, 1], goal: [2, 2]},"
                           "{type: single_integrator, name: b, start: [1.1, 1], goal: [3, 2]}"),
                  "file.yaml: robots[0].start [1, 1] of 'a' and robots[1].start [1.1, 1] of 'b' overlap");
    }

    // Its tolerance would be too large for anything to be certified near it.
    TEST(YamlFile, PlacesPolygonsOfAMapsCoordinates)
    {
        const Scene scene = sceneFromYaml(
            "environment: {min: [500000, 5400000], max: [500010, 5400010], obstacles: ["
            "{type: polygon, vertices: [[500004, 5400004], [500006, 5400004], "
            "[500005, 5400006]]}]}\nrobots:\n  - {type: rigid, space: R2, shape: "
            "{type: disc, radius: 1}, start: [500001, 5400001], goal: [500009, "
            "5400009]}\n",
            "map");
        EXPECT_LT(scene.makeObstacles()->getTolerance(), 1e-4);
        EXPECT_NEAR(scene.makeObstacles()->clearance({500005.0, 5400003.0, 0.0}), 1.0, 1e-9);
    }

    TEST(Scene, RefusesWhatDoesNotFit)
    {
        ompl::base::RealVectorBounds bounds(2);
        bounds.setLow(0.0);
        bounds.setHigh(1.0);
        Scene scene("room", "room.yaml", bounds);
        EXPECT_THROW(scene.validate(), ompl::Exception);
        EXPECT_THROW(scene.addObstacle({Body::sphere(0.1)}), ompl::Exception);
        EXPECT_THROW(scene.addMember({}), ompl::Exception);
        Pose lifted = planarPose(0.5, 0.5);
        lifted.translation().z() = 0.1;
        const Pose tilted(planarPose(0.5, 0.5) * Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()));
        EXPECT_THROW(scene.addObstacle({Body::box(0.1, 0.1), lifted}), ompl::Exception);
        EXPECT_THROW(scene.addObstacle({Body::box(0.1, 0.1), tilted}), ompl::Exception);
        EXPECT_TRUE(scene.getObstacles().empty());
        for (const double bad : {1.0, 1e-7, -0.1, std::nan("")})
            EXPECT_THROW(scene.setResolution(bad), ompl::Exception);
        EXPECT_THROW(Scene("room", "room.yaml", ompl::base::RealVectorBounds(4)), ompl::Exception);
    }
}
