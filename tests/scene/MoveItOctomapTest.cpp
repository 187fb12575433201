// Octomaps in MoveIt's planning scenes

#include "support/MoveItScene.h"
#include "support/RandomStates.h"

#include "files/WholeFile.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "ompl_certificates/validity/TeamValidityChecker.h"

namespace ompl_certificates
{
    namespace
    {
        using namespace test;

        const std::string DRONES_MAP = OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/drones_octomap.bt";

        /** Where a corner of a building of the map is within reach of the arm */
        const std::string MAP_ORIGIN = "[-7.5, -6.0, -4.0]";

        /** The bytes of the map as ROS prints them */
        std::string dataOf(const std::string &map)
        {
            std::string list;
            for (const char byte : map.substr(map.find("data\n") + 5))
                list += (list.empty() ? "" : ", ") + std::to_string(static_cast<int>(static_cast<signed char>(byte)));
            return "[" + list + "]";
        }

        const std::string UNTURNED = "[0, 0, 0, 1]";

        class MoveItOctomap : public MoveItScene
        {
        protected:
            std::string scene(const std::string &data, const std::string &rotation = UNTURNED,
                              const std::string &id = "OcTree") const
            {
                return "world:\n  octomap:\n    header: {frame_id: world}\n    origin: {position: " + MAP_ORIGIN +
                       ", orientation: " + rotation +
                       "}\n    octomap: {header: {frame_id: ''}, binary: true, id: " + id +
                       ", resolution: 0.25, data: " + data + "}\n";
            }

            const std::string data_ = dataOf(readWholeFile(DRONES_MAP));
        };

        /** A matrix in which links next to each other may touch, and two of them the map
            \param base, upper true or false */
        std::string octomapMatrix(const std::string &base, const std::string &upper)
        {
            return "allowed_collision_matrix:\n  entry_names: [base, upper, lower, tip, <octomap>]\n  entry_values:\n"
                   "    - [true, true, false, false, " +
                   base +
                   "]\n"
                   "    - [true, true, true, false, " +
                   upper +
                   "]\n"
                   "    - [false, true, true, true, false]\n"
                   "    - [false, false, true, true, false]\n"
                   "    - [" +
                   base + ", " + upper + ", false, false, true]\n";
        }
    }

    TEST_F(MoveItOctomap, IsAnObstacle)
    {
        const SceneFile file = read(scene(data_));
        ASSERT_EQ(file.scene.getSensedObstacles().size(), 1U);
        // The same map from a file, in a scene of our own
        folder_.write("map.bt", readWholeFile(DRONES_MAP));
        const Scene own = loadScene(folder_.write(
            "own.yaml",
            "environment:\n  min: [-9, -9, -9]\n  max: [9, 9, 9]\n  obstacles:\n    - {type: octomap, file: "
            "map.bt, origin: " +
                MAP_ORIGIN +
                "}\nrobots:\n  - {type: rigid, space: R3, shape: {type: point}, start: [0, 0, 1], "
                "goal: [0, 0, 1]}\n"));
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(file.scene.getMembers().front().robot);
        const auto si = std::make_shared<ompl::base::SpaceInformation>(team);
        const TeamValidityChecker checker(si, file.scene.makeObstacles(), Method::SHARED_PROJECTION),
            expected(si, own.makeObstacles(), Method::STANDARD), alone(si, read(BALL).scene.makeObstacles());
        Random random(1);
        unsigned int free = 0, blockedByIt = 0;
        for (int i = 0; i < 2000; ++i)
        {
            const auto state = randomState(random, team);
            ASSERT_EQ(checker.isValid(state.get()), expected.isValid(state.get())) << i;
            free += checker.isValid(state.get()) ? 1 : 0;
            blockedByIt += alone.isValid(state.get()) && !checker.isValid(state.get()) ? 1 : 0;
        }
        EXPECT_GT(free, 100U);
        EXPECT_GT(blockedByIt, 100U);
        // Pictures show what the arm may reach of it.
        const auto bounds = file.scene.getBounds();
        EXPECT_LT(bounds.high[0], 5.0);
        EXPECT_GT(bounds.low[2], -5.0);
    }

    TEST_F(MoveItOctomap, MayBeTouchedByLinksThatStandStill)
    {
        EXPECT_EQ(messageOf(scene(data_) + octomapMatrix("false", "false")), "");
        // The base is in none of its cells, and needs no check; the links that move may not touch it.
        const SceneFile file = read(scene(data_) + octomapMatrix("true", "false"));
        EXPECT_TRUE(armOf(file).mayTouchObstacles(0));
        EXPECT_FALSE(armOf(file).mayTouchObstacles(1));
        const std::string message = messageOf(scene(data_) + octomapMatrix("false", "true"));
        EXPECT_NE(message.find("world.octomap: link 'upper' may touch it"), std::string::npos) << message;
    }

    TEST_F(MoveItOctomap, IsRefusedIfDamagedOrTurned)
    {
        const std::pair<std::string, std::string> wrong[] = {
            {scene("[1, 2, 3]"), "octomap"},
            {scene("[1, 256]"), "must be a byte, from -128 to 255"},
            {scene("[1, 0.5]"), "must be a byte, from -128 to 255"},
            {scene("[1, x]"), "must be a number"},
            {scene(data_, UNTURNED, "Tree"), "id: must be OcTree"},
            {scene(data_, "[0, 0, 0.1, 1]"), "a map that is turned is not supported"}};
        for (const auto &[text, words] : wrong)
        {
            const std::string message = messageOf(text);
            EXPECT_EQ(message.rfind("scene.yaml", 0), 0U) << message;
            EXPECT_NE(message.find("world.octomap"), std::string::npos) << message;
            EXPECT_NE(message.find(words), std::string::npos) << message;
        }
        // A map without data is none, whatever else it says.
        EXPECT_TRUE(read(scene("[]", "[0, 0, 0.1, 1]")).scene.getSensedObstacles().empty());
    }
}
