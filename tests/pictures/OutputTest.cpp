#include "ompl_certificates/pictures/ScenePicture.h"
#include "ompl_certificates/pictures/PathFile.h"
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
#include <ompl/base/spaces/RealVectorBounds.h>
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

        Scene sceneOf(const std::string &name)
        {
            return loadScene((fs::path(OMPL_CERTIFICATES_SOURCE_DIR) / "demos" / "scenes" / name).string());
        }
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
