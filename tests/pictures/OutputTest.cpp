#include "ompl_certificates/pictures/ScenePicture.h"
#include "ompl_certificates/pictures/PathFile.h"
#include "ompl_certificates/pictures/PlanReport.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "files/WholeFile.h"
#include "support/ArmTexts.h"
#include "support/DecimalCommas.h"
#include "support/Folder.h"
#include "support/Svg.h"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>
#include <set>
#include <sstream>
#include <sys/resource.h>
#include <sys/stat.h>

namespace ompl_certificates
{
    namespace fs = std::filesystem;
    namespace ob = ompl::base;

    namespace
    {
        /** A folder for each test, removed afterwards */
        class Output : public ::testing::Test
        {
        protected:
            std::string file(const std::string &name) const
            {
                return folder_ / name;
            }

            std::size_t fileCount() const
            {
                return folder_.list().size();
            }

            const test::Folder folder_;
        };

        using Points = std::vector<std::pair<double, double>>;
        using Edges = std::vector<std::pair<std::size_t, std::size_t>>;

        std::string digestOf(const Points &points, const Edges &edges)
        {
            auto space = std::make_shared<ob::RealVectorStateSpace>(2);
            space->setBounds(-10.0, 10.0);
            auto si = std::make_shared<ob::SpaceInformation>(space);
            si->setStateValidityChecker([](const ob::State *) { return true; });
            si->setup();
            std::vector<ob::ScopedState<>> states;
            ob::PlannerData data(si);
            for (const auto &[x, y] : points)
            {
                states.emplace_back(space);
                states.back()[0] = x;
                states.back()[1] = y;
            }
            std::vector<unsigned int> index;
            for (const auto &state : states)
                index.push_back(data.addVertex(ob::PlannerDataVertex(state.get())));
            for (const auto &[from, to] : edges)
                data.addEdge(index[from], index[to]);
            return treeDigest(data);
        }

        Scene sceneOf(const std::string &name)
        {
            return loadScene((fs::path(OMPL_CERTIFICATES_SOURCE_DIR) / "demos" / "scenes" / name).string());
        }
    }

    TEST(TreeDigest, DependsOnTheTreeAlone)
    {
        const std::string digest = digestOf({{0, 0}, {1, 0}, {1, 2}}, {{0, 1}, {1, 2}});
        EXPECT_EQ(digest.size(), 16u);
        EXPECT_EQ(digest.find_first_not_of("0123456789abcdef"), std::string::npos);
        EXPECT_EQ(digestOf({{1, 2}, {0, 0}, {1, 0}}, {{2, 0}, {1, 2}}), digest);
        EXPECT_EQ(digestOf({{-0.0, 0}, {1, -0.0}, {1, 2}}, {{0, 1}, {1, 2}}), digest);

        EXPECT_NE(digestOf({{0, 0}, {1, 0}, {1, 2}}, {{1, 0}, {1, 2}}), digest);
        EXPECT_NE(digestOf({{0, 0}, {1, 0}, {1, 2}}, {{0, 1}, {0, 2}}), digest);
        EXPECT_NE(digestOf({{0, 0}, {1, 0}, {1, 2}}, {{0, 1}}), digest);
        EXPECT_NE(digestOf({{0, 0}, {1, 0}, {1, 2.0000000000000004}}, {{0, 1}, {1, 2}}), digest);
        EXPECT_NE(digestOf({{0, 0}, {1, 0}, {1, 2}, {1, 2}}, {{0, 1}, {1, 2}}), digest);
        EXPECT_EQ(digestOf({}, {}).size(), 16u);
    }

    TEST(TreeDigest, DoesNotDependOnTheOrderOfEqualStates)
    {
        EXPECT_EQ(digestOf({{0, 0}, {0, 0}, {1, 2}}, {{0, 2}}), digestOf({{0, 0}, {0, 0}, {1, 2}}, {{1, 2}}));
    }

    TEST_F(Output, ReportHasItsKeysInOrder)
    {
        PlanReport report;
        report.scene = "a \"scene\"\xff";
        report.seed = 18446744073709551615u;
        report.checks.robotPoses = 7;
        report.write(file("report.json"));
        const auto json = nlohmann::ordered_json::parse(readWholeFile(file("report.json")));
        const auto keysOf = [](const nlohmann::ordered_json &object)
        {
            std::string keys;
            for (const auto &item : object.items())
                keys += item.key() + " ";
            return keys;
        };
        EXPECT_EQ(keysOf(json),
                  "scene planner method motion objective seed solved approximate reason cost "
                  "simplified_cost unproved_motions unseen_motions collision iterations tree checks seconds ");
        EXPECT_TRUE(json["reason"].is_null());
        EXPECT_EQ(keysOf(json["tree"]), "states edges digest ");
        EXPECT_EQ(keysOf(json["checks"]),
                  "robot_poses certified_free certified_colliding asked asked_colliding by_clearances by_contact exact "
                  "clearance_queries contact_tests exact_calls pair_poses pair_exact motions motion_samples "
                  "motion_samples_skipped certificates ");
        EXPECT_EQ(keysOf(json["seconds"]), "total checking nearest first_solution simplifying ");
        EXPECT_TRUE(json["seconds"]["nearest"].is_null());
        EXPECT_TRUE(json["seconds"]["simplifying"].is_null());
        EXPECT_TRUE(json["cost"].is_null());
        EXPECT_TRUE(json["simplified_cost"].is_null());
        EXPECT_TRUE(json["unproved_motions"].is_null());
        EXPECT_TRUE(json["collision"].is_null());
        EXPECT_EQ(json["seed"], 18446744073709551615u);
        EXPECT_EQ(json["checks"]["robot_poses"], 7);
        EXPECT_EQ(fileCount(), 1u);

        report.nearestSeconds = 0.5;
        EXPECT_EQ(nlohmann::json::parse(report.toJson())["seconds"]["nearest"], 0.5);
        report.solved = true;
        report.cost = 2.5;
        EXPECT_EQ(nlohmann::json::parse(report.toJson())["cost"], 2.5);
        report.cost = std::numeric_limits<double>::infinity();
        EXPECT_TRUE(nlohmann::json::parse(report.toJson())["cost"].is_null());
    }

    namespace
    {
        /** All keys of a JSON object; keys of nested objects with a dot */
        std::set<std::string> keysOf(const nlohmann::json &object, const std::string &prefix = "")
        {
            std::set<std::string> keys;
            for (const auto &[key, value] : object.items())
                if (value.is_object())
                    keys.merge(keysOf(value, prefix + key + "."));
                else
                    keys.insert(prefix + key);
            return keys;
        }
    }

    TEST(PlanReport, HasTheKeysOfItsPageAndNoOthers)
    {
        const std::string page = readWholeFile(OMPL_CERTIFICATES_SOURCE_DIR "/docs/plan-team.md");
        std::istringstream lines(page.substr(page.find("## The report")));
        std::set<std::string> explained;
        for (std::string line; std::getline(lines, line);)
            if (line.compare(0, 3, "| `") == 0)
            {
                EXPECT_TRUE(explained.insert(line.substr(3, line.find('`', 3) - 3)).second) << line;
            }
        EXPECT_EQ(explained, keysOf(nlohmann::json::parse(PlanReport().toJson())));
    }

    TEST_F(Output, FilesAreReplacedWhole)
    {
        writeWholeFile(file("a.txt"), "first, and longer");
        writeWholeFile(file("a.txt"), "second");
        EXPECT_EQ(readWholeFile(file("a.txt")), "second");
        fs::create_symlink(file("a.txt"), file("link.txt"));
        writeWholeFile(file("link.txt"), "third");
        EXPECT_TRUE(fs::is_symlink(file("link.txt")));
        EXPECT_EQ(readWholeFile(file("a.txt")), "third");
        EXPECT_EQ(fileCount(), 2u);
        fs::permissions(file("a.txt"), fs::perms::owner_read | fs::perms::owner_write);
        writeWholeFile(file("a.txt"), "secret");
        EXPECT_EQ(fs::status(file("a.txt")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
        writeWholeFile("/dev/null", "nothing");
        EXPECT_FALSE(fs::is_regular_file("/dev/null"));
    }

    TEST_F(Output, AFullDiskLeavesWhatWasThere)
    {
        writeWholeFile(file("a.txt"), "old");
        // A limit on the size of files acts like a full disk: some of the text is written, then no more.
        rlimit before;
        ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
        const rlimit small{10000, before.rlim_max};
        const auto handler = std::signal(SIGXFSZ, SIG_IGN);
        ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
        EXPECT_THROW(writeWholeFile(file("a.txt"), std::string(1000000, 'x')), ompl::Exception);
        EXPECT_THROW(writeWholeFile(file("b.txt"), std::string(1000000, 'x')), ompl::Exception);
        setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, handler);
        EXPECT_EQ(readWholeFile(file("a.txt")), "old");
        EXPECT_EQ(fileCount(), 1u) << "neither a part of a file nor a temporary one is left";
        EXPECT_THROW(writeWholeFile("/dev/full", "text"), ompl::Exception);
    }

    TEST_F(Output, FilesThatCannotBeWrittenAreNamed)
    {
        for (const std::string &name : {file("no/such/folder/a.txt"), folder_.path()})
            try
            {
                writeWholeFile(name, "text");
                ADD_FAILURE() << name;
            }
            catch (const ompl::Exception &exception)
            {
                EXPECT_EQ(std::string(exception.what()).find(name + ": "), 0u) << exception.what();
            }
        EXPECT_THROW(writeWholeFile("", "text"), ompl::Exception);
        EXPECT_EQ(fileCount(), 0u);
    }

    TEST_F(Output, WhatCannotBeWrittenIsFoundBeforehand)
    {
        writeWholeFile(file("a.txt"), "old");
        fs::create_symlink(file("a.txt"), file("link.txt"));
        ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
        for (const std::string &name :
             {file("a.txt"), file("link.txt"), file("new.txt"), file("pipe"), std::string("/dev/null")})
            EXPECT_NO_THROW(requireWritable(name)) << name;
        EXPECT_EQ(readWholeFile(file("a.txt")), "old");
        EXPECT_EQ(fileCount(), 3u);
        // For root, access rights say nothing about the last ones.
        for (const std::string &name :
             {file("no/a.txt"), file("a.txt/b.txt"), folder_.path(), std::string(), std::string("/dev/full"),
              std::string("/proc/a.txt"), std::string("/proc/version")})
            try
            {
                requireWritable(name);
                ADD_FAILURE() << name;
            }
            catch (const ompl::Exception &exception)
            {
                EXPECT_EQ(std::string(exception.what()).find((name.empty() ? "''" : name) + ": "), 0u)
                    << exception.what();
            }
        EXPECT_EQ(fileCount(), 3u);
    }

    TEST_F(Output, PathsAreTablesInFullPrecision)
    {
        const Scene scene = sceneOf("paper_three_discs.yaml");
        const TeamSetupPtr setup = scene.makeSetup();
        setup->setup();
        ob::ScopedState<> start = scene.makeStart(std::dynamic_pointer_cast<TeamStateSpace>(setup->getStateSpace()));
        ob::ScopedState<> goal = start;
        start[0] = 1.0 / 3.0;
        goal[0] = 1.0 / 3.0 + 2.5;
        const ompl::geometric::PathGeometric path(setup->getSpaceInformation(), start.get(), goal.get());
        writePath(file("path.csv"), path);
        std::istringstream text(readWholeFile(file("path.csv")));
        std::string line;
        std::getline(text, line);
        EXPECT_EQ(line, "length,disc_1.x,disc_1.y,disc_2.x,disc_2.y,disc_3.x,disc_3.y,time");
        std::vector<std::vector<double>> rows;
        while (std::getline(text, line))
        {
            std::replace(line.begin(), line.end(), ',', ' ');
            std::istringstream numbers(line);
            rows.emplace_back(std::istream_iterator<double>(numbers), std::istream_iterator<double>());
        }
        ASSERT_EQ(rows.size(), 2u);
        ASSERT_EQ(rows[0].size(), 8u);
        EXPECT_EQ(rows[0][0], 0.0);
        EXPECT_EQ(rows[0][1], 1.0 / 3.0);
        EXPECT_EQ(rows[1][0], path.length());
        EXPECT_EQ(rows[1][2], start[1]);
        EXPECT_EQ(rows[0][7], 0.0);
        EXPECT_DOUBLE_EQ(rows[1][7], 2.5);
    }

    TEST(PathFile, NamesTheCoordinatesOfAllRobots)
    {
        const Scene plane = sceneFromYaml(
            "environment: {min: [0, 0], max: [9, 9]}\n"
            "robots:\n"
            "  - {type: single_integrator_0, name: scout, start: [1, 1], "
            "goal: [2, 2]}\n"
            "  - {type: unicycle_first_order_0, name: 'a, b', start: [3, 3, 0], "
            "goal: [4, 4, 0]}\n"
            "  - {type: car_first_order_with_1_trailers_0, name: truck, "
            "start: [6, 6, 0, 0], goal: [7, 7, 0, 0]}\n",
            "plane");
        const TeamSetupPtr setup = plane.makeSetup();
        const std::vector<std::string> names{"scout.x",     "scout.y",       "a, b.x",
                                             "a, b.y",      "a, b.yaw",      "truck.car.x",
                                             "truck.car.y", "truck.car.yaw", "truck.trailer.yaw"};
        EXPECT_EQ(coordinateNames(*setup->getStateSpace()), names);
        EXPECT_EQ(coordinateNames(*plane.getMembers()[2].robot),
                  (std::vector<std::string>{"car.x", "car.y", "car.yaw", "trailer.yaw"}));
        setup->setup();
        const std::string table = toCsv(ompl::geometric::PathGeometric(setup->getSpaceInformation()));
        EXPECT_EQ(table,
                  "length,scout.x,scout.y,\"a, b.x\",\"a, b.y\",\"a, b.yaw\",truck.car.x,truck.car.y,"
                  "truck.car.yaw,truck.trailer.yaw,time\n");

        using namespace test;
        const Folder folder;
        folder.write("arm.urdf", robot(link("base") + link("a") + link("b") + link("c") +
                                       joint("pan", "continuous", "base", "a", "<axis xyz='0 0 1'/>") +
                                       joint("lift", "revolute", "a", "b", "<axis xyz='0 1 0'/>" + LIMIT) +
                                       joint("wrist", "continuous", "b", "c", "<axis xyz='0 0 1'/>")));
        folder.write("arm.srdf",
                     robot("<virtual_joint name='drive' type='planar' parent_frame='floor' child_link='base'/>"
                           "<group name='all'><joint name='drive'/><joint name='pan'/><joint name='lift'/>"
                           "<joint name='wrist'/></group>"));
        const Scene cell = sceneFromYaml(
            "environment: {min: [-1, -1, 0], max: [1, 1, 2]}\nrobots:\n"
            "  - {type: urdf, name: m, file: arm.urdf, srdf: arm.srdf, group: all, "
            "start: [0, 0, 0, 0, 0, 0], goal: [0, 0, 0, 0, 0, 0]}\n",
            folder / "cell.yaml");
        EXPECT_EQ(coordinateNames(*cell.makeTeam()),
                  (std::vector<std::string>{"m.drive.x", "m.drive.y", "m.drive.yaw", "m.pan", "m.lift", "m.wrist"}));
        EXPECT_EQ(coordinateNames(*cell.getMembers()[0].robot),
                  (std::vector<std::string>{"drive.x", "drive.y", "drive.yaw", "pan", "lift", "wrist"}));

        const TeamSetupPtr drones = sceneOf("drones_3d.yaml").makeSetup();
        drones->setup();
        std::vector<double> reals;
        drones->getStateSpace()->copyToReals(reals, ob::ScopedState<>(drones->getStateSpace()).get());
        const std::vector<std::string> inSpace = coordinateNames(*drones->getStateSpace());
        EXPECT_EQ(inSpace.size(), reals.size());
        for (const std::string name : {"balloon.z", "quadrotor.qx", "quadrotor.qw"})
            EXPECT_NE(std::find(inSpace.begin(), inSpace.end(), name), inSpace.end()) << name;
        // Robots of one kind have coordinates of the same kind, but no name may come twice.
        EXPECT_EQ(std::set<std::string>(inSpace.begin(), inSpace.end()).size(), inSpace.size());
    }

    TEST_F(Output, PicturesAreInUtf8WhateverNamesAre)
    {
        ob::RealVectorBounds bounds(2);
        bounds.setLow(0.0);
        bounds.setHigh(1.0);
        const std::string svg = ScenePicture(Scene("caf\xe9 \xc3\xa9 <1>", "none", bounds)).toSvg();
        EXPECT_NE(svg.find("caf\xef\xbf\xbd \xc3\xa9 &lt;1&gt;"), std::string::npos) << svg;
    }

    TEST_F(Output, PicturesAreWellFormed)
    {
        for (const std::string name : {"paper_five_discs", "warehouse", "drones_3d"})
        {
            SCOPED_TRACE(name);
            const Scene scene = sceneOf(name + ".yaml");
            ScenePicture picture(scene);
            const std::string plain = picture.toSvg();
            EXPECT_TRUE(test::isWellFormed(plain));

            const TeamSetupPtr setup = scene.makeSetup();
            setup->setup();
            const auto &si = setup->getSpaceInformation();
            const auto *start = setup->getProblemDefinition()->getStartState(0);
            const ob::ScopedState<> goal =
                scene.makeGoal(std::dynamic_pointer_cast<TeamStateSpace>(setup->getStateSpace()));
            picture.setPath(ompl::geometric::PathGeometric(si, start, goal.get()));
            ob::PlannerData data(si);
            data.addEdge(ob::PlannerDataVertex(start), ob::PlannerDataVertex(goal.get()));
            picture.setTree(data);
            picture.setCertificates({{{1.0, 1.0, 0.0}, 2.0},
                                     {{1.0, 1.0, 0.0}, -2.0},
                                     {{1.0, 1.0, 0.0}, std::numeric_limits<double>::infinity()}});
            const std::string full = picture.toSvg();
            EXPECT_TRUE(test::isWellFormed(full));
            EXPECT_GT(full.size(), plain.size());
            for (const auto &member : scene.getMembers())
                EXPECT_NE(full.find(">" + member.robot->getName() + "<"), std::string::npos);
            picture.write(file(name + ".svg"));
            EXPECT_EQ(readWholeFile(file(name + ".svg")), full);
        }
    }

    TEST_F(Output, PicturesAreTheSameInAnyLocale)
    {
        const Scene scene = sceneOf("warehouse.yaml");
        const std::string svg = ScenePicture(scene).toSvg();
        const test::DecimalCommas commas;
        EXPECT_EQ(ScenePicture(scene).toSvg(), svg);
    }

    TEST(ScenePicture, EscapesNames)
    {
        const Scene scene = sceneFromYaml(
            "name: <a> & 'b'\nenvironment: {min: [0, 0], max: [5, 5]}\n"
            "robots: [{type: single_integrator, name: '</svg>', start: [1, 1], "
            "goal: [2, 2]}]",
            "names");
        const std::string svg = ScenePicture(scene).toSvg();
        EXPECT_TRUE(test::isWellFormed(svg));
        EXPECT_NE(svg.find("&lt;a&gt; &amp; 'b'"), std::string::npos);
    }

    TEST(ScenePicture, RefusesPathsOfOtherTeams)
    {
        const Scene scene = sceneOf("paper_three_discs.yaml"), other = sceneOf("paper_one_disc.yaml");
        const TeamSetupPtr setup = other.makeSetup();
        ScenePicture picture(scene);
        EXPECT_THROW(picture.setPath(ompl::geometric::PathGeometric(setup->getSpaceInformation())), ompl::Exception);
        EXPECT_THROW(picture.setTree(ob::PlannerData(setup->getSpaceInformation())), ompl::Exception);
    }
}
