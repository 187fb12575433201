#include "ompl_certificates/scene/MeshFile.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "support/Folder.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace fs = std::filesystem;

    namespace
    {
        using test::Folder;

        const char *const BOX = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
        const char *const WORLD = "v 20 20 0\nv 30 20 0\nv 20 40 0\nv 20 20 5\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

        const std::string PLANAR =
            "[problem]\nname = test\nrobot = robot.obj\nworld = world.obj\nstart.x = 1\n"
            "start.y = 2\nstart.theta = 0.5\ngoal.x = 35\ngoal.y = 4\ngoal.theta = 4\n";
        const std::string SPATIAL = PLANAR +
                                    "start.z = 3\nstart.axis.x = 0\nstart.axis.y = 0\nstart.axis.z = 2\n"
                                    "goal.z = 1\ngoal.axis.x = 1\ngoal.axis.y = 0\ngoal.axis.z = 0\n";
        const std::string VOLUME = "volume.min.x = 0\nvolume.min.y = -1\nvolume.max.x = 40\nvolume.max.y = 41\n";

        /** Files that a .cfg file needs, and the .cfg file */
        class OmplApp : public ::testing::Test
        {
        protected:
            OmplApp()
            {
                folder_.write("robot.obj", BOX);
                folder_.write("world.obj", WORLD);
            }

            SceneFile read(const std::string &cfg) const
            {
                return readSceneFile(folder_.write("scene.cfg", cfg));
            }

            /** \e text with what is in a line that begins with \e key replaced by \e line */
            static std::string replaced(std::string text, const std::string &key, const std::string &line)
            {
                const std::size_t at = text.find("\n" + key + " =");
                EXPECT_NE(at, std::string::npos) << key;
                return text.replace(at + 1, text.find('\n', at + 1) - at, line);
            }

            void expectBroken(const std::string &cfg, const std::string &complaint) const
            {
                SCOPED_TRACE(complaint);
                const std::string begin = (folder_ / "scene.cfg") + ": " + complaint;
                try
                {
                    read(cfg);
                    ADD_FAILURE() << "was read";
                }
                catch (const ompl::Exception &exception)
                {
                    const std::string what = exception.what();
                    EXPECT_EQ(what.substr(0, begin.size()), begin);
                    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
                }
            }

            Folder folder_;
        };
    }

    TEST_F(OmplApp, ReadsAPlanarProblem)
    {
        const SceneFile file = read(PLANAR + VOLUME);
        const Scene &scene = file.scene;
        EXPECT_EQ(scene.getName(), "test");
        EXPECT_EQ(scene.getDimension(), 2u);
        EXPECT_EQ(scene.getBounds().low, (std::vector<double>{0, -1}));
        EXPECT_EQ(scene.getBounds().high, (std::vector<double>{40, 41}));
        ASSERT_EQ(scene.getMembers().size(), 1u);
        EXPECT_EQ(scene.getMembers()[0].start, (std::vector<double>{1, 2, 0.5}));
        EXPECT_NEAR(scene.getMembers()[0].goal[2], 4.0 - 2.0 * M_PI, 1e-12);
        EXPECT_FALSE(file.timeLimit || file.memoryLimit || file.runCount);
        EXPECT_TRUE(file.planners.empty());
        EXPECT_TRUE(scene.getNotes().empty());
        scene.validate();
        EXPECT_EQ(loadScene(folder_ / "scene.cfg").getName(), "test");
        // A section may have the beginning of its keys in its name.
        const std::string nested = replaced(PLANAR, "start.x", "") + "[problem.start]\nx = 7 # there\n";
        EXPECT_EQ(read(nested).scene.getMembers()[0].start[0], 7.0);
    }

    TEST_F(OmplApp, ReadsASpatialProblem)
    {
        const Scene scene = read(SPATIAL).scene;
        EXPECT_EQ(scene.getDimension(), 3u);
        const std::vector<double> &start = scene.getMembers()[0].start, &goal = scene.getMembers()[0].goal;
        ASSERT_EQ(start.size(), 7u);
        EXPECT_NEAR(start[5], std::sin(0.25), 1e-12);
        EXPECT_NEAR(start[6], std::cos(0.25), 1e-12);
        EXPECT_NEAR(goal[3], std::sin(2.0), 1e-12);
    }

    TEST_F(OmplApp, BoundsHoldTheEnvironmentTheStartAndTheGoal)
    {
        const Scene without = read(PLANAR).scene;
        EXPECT_EQ(without.getBounds().low, (std::vector<double>{1, 2}));
        EXPECT_EQ(without.getBounds().high, (std::vector<double>{35, 40}));
        const Scene within = read(replaced(PLANAR + VOLUME, "volume.max.x", "volume.max.x = 30\n")).scene;
        EXPECT_EQ(within.getBounds().high, (std::vector<double>{35, 41}));
        EXPECT_EQ(within.getNotes().size(), 1u);
    }

    TEST_F(OmplApp, ReadsBenchmarkAndPlanners)
    {
        const SceneFile file = read(PLANAR +
                                    "objective = max_min_clearance\nlongest_valid_segment_fraction = 0.02\n"
                                    "[benchmark]\r\ntime_limit=2.5\r\nmem_limit = 500\r\nrun_count=7\r\n"
                                    "[planner]\n# a comment\nest.range=3\nrrt=\nrrt.range=50\nrrt=\n"
                                    "RRT.Range=5\nrrt.goal_bias=0.1\nrrt.name = RRT far\nkpiece=\n");
        EXPECT_DOUBLE_EQ(file.timeLimit.value(), 2.5);
        EXPECT_DOUBLE_EQ(file.memoryLimit.value(), 500.0);
        EXPECT_EQ(file.runCount.value(), 7u);
        EXPECT_DOUBLE_EQ(file.scene.getResolution(), 0.02);
        EXPECT_EQ(file.scene.getNotes().size(), 1u);
        using Parameters = std::vector<std::pair<std::string, std::string>>;
        ASSERT_EQ(file.planners.size(), 4u);
        EXPECT_EQ(file.planners[0].type, "est");
        EXPECT_EQ(file.planners[0].parameters, (Parameters{{"range", "3"}}));
        EXPECT_EQ(file.planners[1].type, "rrt");
        EXPECT_EQ(file.planners[1].parameters, (Parameters{{"range", "50"}}));
        EXPECT_EQ(file.planners[2].parameters, (Parameters{{"range", "5"}, {"goal_bias", "0.1"}}));
        EXPECT_EQ(file.planners[2].title, "RRT far");
        EXPECT_EQ(file.planners[3].type, "kpiece");
    }

    TEST_F(OmplApp, NamesFileSectionAndKeyOfWhatIsWrong)
    {
        folder_.write("broken.obj", "v 0 0 0\n");
        folder_.write("flat.obj", "v 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
        expectBroken("", "[problem] start.x: missing");
        expectBroken("hello\n", "not a .cfg file: there is no '=' in 'hello'");
        expectBroken("[a]\nrobot %invalid_line% %invalid_line%\n", "not a .cfg file: ");
        expectBroken("[a] %invalid_line%\n", "not a .cfg file");
        expectBroken("x = 1\n", "'x' is in no section");
        expectBroken(PLANAR + "[planer]\nrrt=\n", "[planer] rrt: unknown section");
        expectBroken(PLANAR + "speed = 4\n", "[problem] speed: unknown key");
        expectBroken(PLANAR + "start.x = 4\n", "[problem] start.x: given twice, now as '4'");
        expectBroken(PLANAR + "control = kinematic_car\n", "[problem] control: not supported");
        expectBroken(PLANAR + "statespace = dubins\n", "[problem] statespace: not supported");
        expectBroken(replaced(PLANAR, "robot", ""), "[problem] robot: missing");
        expectBroken(replaced(PLANAR, "robot", "robot =\n"), "[problem] robot: has no value");
        expectBroken(replaced(PLANAR, "robot", "robot = none.dae\n"),
                     "[problem] robot: " + (folder_ / "none.dae") + ": cannot be read");
        expectBroken(replaced(PLANAR, "world", "world = broken.obj\n"),
                     "[problem] world: " + (folder_ / "broken.obj") + ": ");
        expectBroken(replaced(PLANAR, "goal.theta", ""), "[problem] goal.theta: missing");
        expectBroken(replaced(PLANAR, "start.x", "start.x = here\n"),
                     "[problem] start.x: must be a number, not 'here'");
        expectBroken(replaced(PLANAR, "start.x", "start.x = 1.5m\n"),
                     "[problem] start.x: must be a number, not '1.5m'");
        expectBroken(replaced(PLANAR, "goal.y", "goal.y = nan\n"), "[problem] goal.y: must be a finite number");
        expectBroken(replaced(PLANAR, "goal.y", "goal.y = 1e30\n"), "[problem] goal.y: must be a finite number");
        expectBroken(PLANAR + "goal.z = 3\n", "[problem] start.z: missing");
        expectBroken(replaced(SPATIAL, "goal.axis.y", ""), "[problem] goal.axis.y: missing");
        expectBroken(replaced(SPATIAL, "start.axis.z", "start.axis.z = 0\n"), "[problem] start.axis: must not be zero");
        expectBroken(replaced(PLANAR + VOLUME, "volume.max.y", ""), "[problem] volume.max.y: missing");
        expectBroken(replaced(PLANAR + VOLUME, "volume.max.y", "volume.max.y = -1\n"),
                     "[problem] volume.max.y: must be above volume.min.y, which is -1, not -1");
        expectBroken(PLANAR + "longest_valid_segment_fraction = 2\n",
                     "[problem] longest_valid_segment_fraction: must be at least 1e-6 and below 1, not 2");
        expectBroken(PLANAR + "longest_valid_segment_fraction = 1\n",
                     "[problem] longest_valid_segment_fraction: must be at least 1e-6 and below 1, not 1");
        expectBroken(PLANAR + "longest_valid_segment_fraction = 1e-7\n",
                     "[problem] longest_valid_segment_fraction: must be at least 1e-6");
        expectBroken(PLANAR + "[benchmark]\ntime_limit = 0\n", "[benchmark] time_limit: must be above 0, not '0'");
        expectBroken(PLANAR + "[benchmark]\nmem_limit = much\n", "[benchmark] mem_limit: must be a number, not 'much'");
        expectBroken(PLANAR + "[benchmark]\nrun_count = 2.5\n", "[benchmark] run_count: must be a whole number");
        expectBroken(PLANAR + "[benchmark]\nrun_count = -3\n", "[benchmark] run_count: must be a whole number");
        expectBroken(PLANAR + "[benchmark]\nruns = 3\n", "[benchmark] runs: unknown key");
        expectBroken(PLANAR + "[planner]\nrrt = 5\n", "[planner] rrt: takes no value, not '5'");
        expectBroken(PLANAR + "[planner]\nrrt=\nrrt.range=\n", "[planner] rrt.range: has no value");
        expectBroken(std::string(1000, '\0'), "");
        EXPECT_THROW(readSceneFile(folder_ / "missing.cfg"), ompl::Exception);
        // What the strings above are made of is fine.
        read(SPATIAL + VOLUME + "volume.min.z = 0\nvolume.max.z = 9\n");
    }

    TEST(SharedScenes, OmplAppFilesLoadAndStartsAndGoalsAreFree)
    {
        const fs::path folder = fs::path(OMPL_CERTIFICATES_SHARED_DIR) / "scenes" / "omplapp";
        if (!fs::is_directory(folder))
            GTEST_SKIP() << "there is no " << folder;
        std::size_t count = 0;
        for (const auto &entry : fs::recursive_directory_iterator(folder))
            if (entry.path().extension() == ".cfg")
            {
                SCOPED_TRACE(entry.path());
                const SceneFile file = readSceneFile(entry.path().string());
                const Scene &scene = file.scene;
                scene.validate();
                EXPECT_EQ(scene.getDimension(), entry.path().parent_path().filename() == "2D" ? 2u : 3u);
                EXPECT_FALSE(file.planners.empty());
                EXPECT_TRUE(file.runCount);
                // The robot's reference point is inside the box of its mesh.
                const Body &body = scene.getMembers()[0].robot->getBodies().front();
                const Eigen::AlignedBox3d box = body.getParts().front().shape.getMesh()->getBounds();
                EXPECT_TRUE(scene.getDimension() == 2 || box.contains(Eigen::Vector3d::Zero()));
                EXPECT_TRUE(box.min().x() < 0.0 && box.max().x() > 0.0 && box.min().y() < 0.0 && box.max().y() > 0.0);
                ++count;
            }
        EXPECT_EQ(count, 7u);
    }

    /** What OMPL.app's own problems say of where it has the robots: their starts are where the meshes are. */
    TEST(SharedScenes, ReferencePointsAreThoseOfOmplApp)
    {
        const fs::path folder = fs::path(OMPL_CERTIFICATES_SHARED_DIR) / "scenes" / "omplapp";
        if (!fs::is_directory(folder))
            GTEST_SKIP() << "there is no " << folder;
        const auto meanOf = [&folder](const std::string &name) { return MeshFile((folder / name).string()).getMean(); };
        EXPECT_LT((meanOf("3D/cubicles_robot.dae") - Eigen::Vector3d(-4.96, -40.62, 70.57)).norm(), 0.01);
        EXPECT_LT((meanOf("3D/bugtrap_robot.dae") - Eigen::Vector3d(17.18, 0.89, -4.62)).norm(), 0.01);
        EXPECT_LT((meanOf("3D/Apartment_robot.dae") - Eigen::Vector3d(-31.19, -99.85, 36.46)).norm(), 0.01);
        EXPECT_LT((meanOf("2D/car2_planar_robot.dae") - Eigen::Vector3d(0.01, -0.15, 3.937)).norm(), 0.001);
    }

    TEST(SharedScenes, TeamsCanStandAtTheirStartsAndGoals)
    {
        const fs::path meshes = fs::path(OMPL_CERTIFICATES_SOURCE_DIR) / "../shared/scenes/omplapp";
        if (!fs::is_directory(meshes))
            GTEST_SKIP() << "there is no " << meshes;
        std::size_t count = 0;
        for (const auto &entry : fs::directory_iterator(OMPL_CERTIFICATES_SOURCE_DIR "/benchmarks/scenes-shared"))
            if (entry.path().extension() == ".yaml")
            {
                SCOPED_TRACE(entry.path());
                EXPECT_NO_THROW(loadScene(entry.path().string()).validate());
                ++count;
            }
        EXPECT_EQ(count, 12u);
    }
}
