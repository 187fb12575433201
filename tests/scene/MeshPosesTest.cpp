#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "support/Random.h"
#include "support/RandomStates.h"

#include <cctype>
#include <filesystem>
#include <gtest/gtest.h>

namespace ompl_certificates
{
    namespace fs = std::filesystem;
    using namespace test;

    namespace
    {
        const std::string OWN = OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/";
        const std::string SHARED = OMPL_CERTIFICATES_SHARED_DIR "/scenes/omplapp/";

        class MeshPoses : public ::testing::TestWithParam<std::string>
        {
        };
    }

    /** No pose is certified against FCL's verdict: certificates that many poses, half of them close together, left
        behind settle the next ones. */
    TEST_P(MeshPoses, VerdictsAreThoseOfFcl)
    {
        if (!fs::exists(GetParam()))
            GTEST_SKIP() << "there is no " << GetParam();
        const Scene scene = loadScene(GetParam());
        const auto team = scene.makeTeam();
        const auto obstacles = scene.makeObstacles();
        const TeamSetup standard(team, obstacles, Method::STANDARD);
        const TeamSetup shared(team, obstacles, Method::SHARED_PROJECTION);
        standard.getSpaceInformation()->setup();
        shared.getSpaceInformation()->setup();
        shared.getTeamChecker()->setCertificatesAfter(0);
        const unsigned int seed = 1, poses = scaled(100000) / team->getRobotCount();
        Random random(seed);
        unsigned int valid = 0;
        auto state = randomState(random, team);
        for (unsigned int i = 0; i < poses; ++i)
        {
            state = random.chance(0.5) ? randomState(random, team) : randomStateNear(random, state, 0.02);
            const bool truth = standard.getTeamChecker()->isValid(state.get());
            valid += truth ? 1 : 0;
            ASSERT_EQ(shared.getTeamChecker()->isValid(state.get()), truth) << "seed " << seed << ", pose " << i;
        }
        const CheckCounts counts = shared.getStatistics().getCounts();
        EXPECT_GT(valid, 0U);
        EXPECT_GT(counts.robotPoses, counts.exactCalls) << "nothing was certified";
    }

    INSTANTIATE_TEST_SUITE_P(Of, MeshPoses,
                             ::testing::Values(OWN + "maze.yaml", OWN + "knots.yaml", SHARED + "2D/Barriers.cfg",
                                               SHARED + "2D/Maze_planar.cfg", SHARED + "2D/RandomPolygons_planar.cfg",
                                               SHARED + "3D/Apartment.cfg", SHARED + "3D/Twistycool.cfg",
                                               SHARED + "3D/bugtrap.cfg", SHARED + "3D/cubicles.cfg"),
                             [](const auto &scene)
                             {
                                 std::string name = fs::path(scene.param).stem().string();
                                 for (char &c : name)
                                     c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
                                 return name;
                             });
}
