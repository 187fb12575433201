#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "support/FclVerdicts.h"

#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        const std::string LINKS =
            "links: [{length: 2, width: 0.2, limits: [-2, 2]}, {length: 1, radius: 0.1}, {length: 1, shape: {type: "
            "disc, radius: 0.3, center: [0.5, 0]}}]";
        const std::string STATES = "start: [0.5, 0, 0], goal: [1, 1, 1]";

        Scene sceneWithPlanarArm(const std::string &robot, const std::string &bounds = "min: [-5, -5], max: [5, 5]")
        {
            return sceneFromYaml(
                "environment: {" + bounds + ", obstacles: []}\nrobots:\n  - {type: arm, " + robot + "}\n", "f.yaml");
        }

        const Arm &planarArmOf(const Scene &scene)
        {
            return dynamic_cast<const Arm &>(*scene.getMembers().front().robot);
        }

        std::string messageAboutPlanarArm(const std::string &robot,
                                          const std::string &bounds = "min: [-5, -5], max: [5, 5]")
        {
            try
            {
                sceneWithPlanarArm(robot, bounds).validate();
            }
            catch (const ompl::Exception &exception)
            {
                return exception.what();
            }
            return "";
        }

        TEST(PlanarArm, LinksHangTogether)
        {
            const Scene scene = sceneWithPlanarArm(LINKS + ", base: {center: [1, 2], angle: 0.25}, " + STATES);
            const Arm &arm = planarArmOf(scene);
            EXPECT_EQ(arm.getWorkspaceDimension(), 2u);
            EXPECT_EQ(arm.getGroup(), (std::vector<std::string>{"joint_1", "joint_2", "joint_3"}));
            ASSERT_EQ(arm.getBodies().size(), 3u);
            EXPECT_EQ(arm.getBodyPairs().size(), 1u) << "neighbors may touch";
            ompl::base::ScopedState<> state(arm.getStateSpace());
            state = std::vector<double>{0.5, -0.3, 0.2};
            const double first = 0.75, second = 0.45, third = 0.65;
            Eigen::Vector3d joint(1, 2, 0);
            joint += 2.0 * Eigen::Vector3d(std::cos(first), std::sin(first), 0);
            EXPECT_LT((arm.getLinkPose(state.get(), "link_2").translation() - joint).norm(), 1e-12);
            joint += Eigen::Vector3d(std::cos(second), std::sin(second), 0);
            EXPECT_LT((arm.getLinkPose(state.get(), "link_3").translation() - joint).norm(), 1e-12);
            // Bodies reach from joint to joint: each one's middle is between them.
            std::vector<Pose> poses(3);
            arm.computePoses(state.get(), poses.data());
            EXPECT_LT(
                (poses[2].translation() - joint - 0.5 * Eigen::Vector3d(std::cos(third), std::sin(third), 0)).norm(),
                1e-9);
            EXPECT_NEAR(arm.getBodies()[0].getBoundingRadius(), std::hypot(1.0, 0.1), 1e-9);
            EXPECT_NEAR(arm.getBodies()[1].getBoundingRadius(), 0.6, 1e-9);
        }

        TEST(PlanarArm, AnglesWithoutLimitsAreWrapped)
        {
            const Scene scene = sceneWithPlanarArm(LINKS + ", start: [2, 7, -7], goal: [0, 0, 0]");
            const auto &start = scene.getMembers().front().start;
            EXPECT_EQ(start[0], 2.0);
            EXPECT_NEAR(start[1], 7.0 - 2.0 * M_PI, 1e-12);
            EXPECT_NEAR(start[2], 2.0 * M_PI - 7.0, 1e-12);
        }

        TEST(PlanarArm, LinksThatAreNotNeighborsCollideUnlessTheyMay)
        {
            const std::string folded = "start: [0, 2.9, 2.9], goal: [0, 0, 0]";
            EXPECT_NE(messageAboutPlanarArm(LINKS + ", " + folded).find("of 'robot_0' touches itself"),
                      std::string::npos);
            EXPECT_EQ(messageAboutPlanarArm(LINKS + ", self_collision: false, " + folded), "");
        }

        TEST(PlanarArm, NamesWhatIsWrong)
        {
            const std::string place = "f.yaml:3: robots[0]";
            const std::vector<std::pair<std::string, std::string>> all{
                {STATES, place + ".links: missing"},
                {"links: [], " + STATES, place + ".links: must have from 1 to 128 items, not 0"},
                {"links: [{width: 1}], " + STATES, place + ".links[0].length: missing"},
                {"links: [{length: 1}], " + STATES,
                 place + ".links[0]: give the link's width, radius, shape or shapes"},
                {"links: [{length: 1, width: 1, radius: 1}], " + STATES,
                 place + ".links[0].radius: give either width or radius"},
                {"links: [{length: 1, width: -1}], " + STATES, place + ".links[0].width: must be positive, not -1"},
                {"links: [{length: 0, width: 1}], " + STATES, place + ".links[0].length: must be positive, not 0"},
                {"links: [{length: 1, width: 1, limits: [1, 1]}], " + STATES,
                 place + ".links[0].limits: the lower one must be below the upper one"},
                {"links: [{length: 1, width: 1, mass: 1}], " + STATES, place + ".links[0].mass: unknown key"},
                {LINKS + ", start: [0, 0], goal: [0, 0, 0]", place + ".start: must be a list of 3 numbers, not of 2"},
                {LINKS + ", start: [0, 0, 0], goal: [2.5, 0, 0]", place + ".goal[0]: joint 'joint_1' must be from"},
                {LINKS + ", base: {center: [0, 0, 0]}, " + STATES, place + ".base.center: must be a list of 2 numbers"},
                {LINKS + ", bounds: {}, " + STATES, place + ".bounds: unknown key"},
                {LINKS + ", self_collision: 1, " + STATES, place + ".self_collision: must be true or false, not 1"},
            };
            for (const auto &[robot, message] : all)
                EXPECT_EQ(messageAboutPlanarArm(robot).substr(0, message.size()), message);
            EXPECT_EQ(messageAboutPlanarArm(LINKS + ", " + STATES, "min: [-5, -5, 0], max: [5, 5, 1]"),
                      place + ".type: 'arm' moves in the plane; the scene has 3 dimensions");
        }

        TEST(PlanarArm, TeamsAreJudgedAsFclJudgesThem)
        {
            const Scene scene = loadScene(OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/arms/planar.yaml");
            EXPECT_NO_THROW(scene.validate());
            test::expectFclsVerdicts(scene, 10000);
        }
    }
}
