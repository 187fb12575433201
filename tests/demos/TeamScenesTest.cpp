#include "files/WholeFile.h"
#include "generators/TeamPlaces.h"
#include "generators/TeamScenes.h"
#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/planning/DRRTstar.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "support/Folder.h"
#include "support/Random.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        using generators::Ends;
        using generators::TeamKind;
        using generators::TeamSettings;
        using generators::Zone;

        const std::string SHIPPED = OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/teams/";

        const TeamKind &kindOf(const std::string &name)
        {
            const auto &kinds = generators::teamKinds();
            return *std::find_if(kinds.begin(), kinds.end(), [&](const TeamKind &kind) { return kind.name == name; });
        }

        /** A file of demos/scenes/teams: its kind, robots, obstacles and size */
        struct Shipped
        {
            std::string file, kind;
            TeamSettings settings;
        };

        const std::vector<Shipped> FILES{
            {"boxes_8", "boxes", {8, 10, 10.0}},    {"boxes_16", "boxes", {16, 10, 10.0}},
            {"discs_30", "discs", {30, 0, 20.0}},   {"discs_50", "discs", {50, 0, 40.0}},
            {"discs_100", "discs", {100, 0, 60.0}}, {"warehouse_16", "warehouse", {16, 0, 20.0}},
            {"window_8", "window", {8, 0, 10.0}},   {"drones_30", "drones", {30, 16, 30.0}},
            {"mixed_8", "mixed", {8, 10, 16.0}}};

        Scene makeScene(const TeamKind &kind, const TeamSettings &settings)
        {
            const test::Folder folder;
            writeScene(kind.make(settings), folder / "scene.yaml");
            return loadScene(folder / "scene.yaml");
        }
    }

    TEST(TeamScenes, MadeTheScenesOfTheDemos)
    {
        const test::Folder folder;
        for (const Shipped &shipped : FILES)
        {
            SCOPED_TRACE(shipped.file);
            const generators::SceneTexts texts = kindOf(shipped.kind).make(shipped.settings);
            writeScene(texts, folder / (shipped.file + ".yaml"));
            EXPECT_EQ(readWholeFile(folder / (shipped.file + ".yaml")),
                      readWholeFile(SHIPPED + shipped.file + ".yaml"));
            for (const auto &[name, text] : texts.meshes)
                EXPECT_TRUE(readWholeFile(SHIPPED + shipped.file + "_" + name) == text) << name;
        }
    }

    TEST(TeamScenes, CanBeSolved)
    {
        for (const Shipped &shipped : FILES)
        {
            SCOPED_TRACE(shipped.file);
            const TeamSetupPtr setup = loadScene(SHIPPED + shipped.file + ".yaml").makeSetup();
            const auto planner = std::make_shared<DRRTstar>(setup->getSpaceInformation());
            setup->setPlanner(planner);
            const auto deadline = ompl::base::timedPlannerTerminationCondition(60.0);
            EXPECT_EQ(setup->solve(ompl::base::PlannerTerminationCondition(
                          [&] { return deadline() || std::isfinite(planner->getBestCost().value()); })),
                      ompl::base::PlannerStatus::EXACT_SOLUTION);
        }
    }

    TEST(TeamScenes, SameSeedSameText)
    {
        for (const TeamKind &kind : generators::teamKinds())
        {
            TeamSettings settings = kind.defaults;
            settings.seed = 7;
            const std::string text = kind.make(settings).yaml;
            EXPECT_EQ(kind.make(settings).yaml, text) << kind.name;
            settings.seed = 8;
            const std::string other = kind.make(settings).yaml;
            EXPECT_NE(other.substr(other.find("robots:")), text.substr(text.find("robots:"))) << kind.name;
        }
    }

    TEST(TeamScenes, StartsAndGoalsAreValidForEachSeed)
    {
        for (const TeamKind &kind : generators::teamKinds())
            for (std::uint64_t seed = 2; seed < 2 + test::scaled(5); ++seed)
            {
                SCOPED_TRACE(kind.name + ", seed " + std::to_string(seed));
                TeamSettings settings = kind.defaults;
                settings.robots = static_cast<unsigned int>(1 + 5 * (seed % 4));
                settings.obstacles = kind.hasObstacles ? static_cast<unsigned int>(2 * (seed % 7)) : 0;
                settings.size *= 1.0 + 0.137 * static_cast<double>(seed % 3);
                settings.seed = seed;
                const Scene scene = makeScene(kind, settings);
                EXPECT_NO_THROW(scene.validate());
                EXPECT_EQ(scene.getMembers().size(), settings.robots);
                EXPECT_TRUE(scene.getNotes().empty());
                if (kind.hasObstacles)
                {
                    EXPECT_EQ(scene.getObstacles().size(), settings.obstacles);
                }
            }
    }

    TEST(TeamScenes, GroupsChangeSidesThroughTheWindow)
    {
        const Scene scene = makeScene(kindOf("window"), kindOf("window").defaults);
        for (const Scene::Member &member : scene.getMembers())
            EXPECT_LT((member.start[0] - 5.0) * (member.goal[0] - 5.0), 0.0) << member.robot->getName();
    }

    TEST(TeamScenes, RobotsComeFromBothEndsOfTheWarehouse)
    {
        const Scene scene = makeScene(kindOf("warehouse"), kindOf("warehouse").defaults);
        unsigned int left = 0, inAisles = 0;
        for (const Scene::Member &member : scene.getMembers())
        {
            EXPECT_TRUE(member.start[0] < 4.0 || member.start[0] > 16.0) << member.robot->getName();
            left += member.start[0] < 4.0 ? 1 : 0;
            inAisles += member.goal[0] >= 4.0 && member.goal[0] <= 16.0 ? 1 : 0;
        }
        EXPECT_EQ(left, 8u);
        EXPECT_EQ(inAisles, 8u);
    }

    /** A wall divides the square into rooms of different sizes: all are placed in the larger one. */
    TEST(TeamPlaces, GoalsCanBeReached)
    {
        ompl::base::RealVectorBounds bounds(2);
        bounds.setLow(0.0);
        bounds.setHigh(10.0);
        const auto team = std::make_shared<TeamStateSpace>();
        const Zone square(Eigen::Vector3d::Zero(), Eigen::Vector3d(10.0, 10.0, 0.0));
        std::vector<Ends<Zone>> zones;
        for (const std::string name : {"a", "b", "c", "d", "e", "f"})
        {
            team->addRobot(RigidRobot::inSE2(name, Body::box(0.5, 0.25), bounds));
            zones.push_back({square, square});
        }
        // The gap above the wall is 0.2 wide: too narrow for a box that turns, though it may stick out of the square.
        const auto wall =
            std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(0.2, 9.8), poseAt({4.0, 4.9, 0.0})}}, 2);
        generators::SeededRandom random(1);
        for (const auto &ends : placeTeam(team, wall, square, zones, random))
        {
            EXPECT_GT(ends.start[0], 4.0);
            EXPECT_GT(ends.goal[0], 4.0);
        }
        zones.front().goal.max().x() = 4.0;
        EXPECT_THROW(placeTeam(team, wall, square, zones, random), ompl::Exception);
    }

    TEST(TeamScenes, RefusesNonsense)
    {
        for (const TeamKind &kind : generators::teamKinds())
        {
            const auto refuses = [&kind](auto change)
            {
                TeamSettings settings = kind.defaults;
                change(settings);
                EXPECT_THROW(kind.make(settings), ompl::Exception) << kind.name;
            };
            refuses([](auto &settings) { settings.robots = 0; });
            refuses([](auto &settings) { settings.robots = 1001; });
            refuses([&](auto &settings) { settings.obstacles = kind.hasObstacles ? 1001 : 1; });
            refuses([&](auto &settings) { settings.size = 0.99 * kind.smallest; });
            refuses([](auto &settings) { settings.size = 1001.0; });
            refuses([](auto &settings) { settings.size = std::numeric_limits<double>::quiet_NaN(); });
        }
        EXPECT_THROW(kindOf("discs").make({20, 0, 1.0}), ompl::Exception);  // no place left
    }
}
