#include "ompl_certificates/obstacles/CellObstacles.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "support/Folder.h"
#include "support/Message.h"

#include <gtest/gtest.h>

namespace ompl_certificates
{
    using namespace test;

    namespace
    {
        const std::string MAP = OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/drones_octomap.bt";

        /** Scenes with one octomap, and a robot that is free in it */
        class YamlOctomap : public testing::Test
        {
        protected:
            void SetUp() override
            {
                std::filesystem::copy_file(MAP, folder_ / "map.bt");
                folder_.write("broken.bt", "# Octomap OcTree binary file\n");
            }

            std::string file(unsigned int dimension, const std::string &keys) const
            {
                const bool planar = dimension == 2;
                return folder_.write(
                    "scene.yaml", std::string("environment:\n  min: ") + (planar ? "[0, 0]" : "[0, 0, 0]") +
                                      "\n  max: " + (planar ? "[20, 20]" : "[20, 20, 12]") + "\n  obstacles:\n    - {" +
                                      keys + "}\nrobots:\n  - {type: rigid, space: " + (planar ? "R2" : "R3") +
                                      ", shape: {type: point}, start: " + (planar ? "[1, 1]" : "[1, 1, 1]") +
                                      ", goal: " + (planar ? "[2, 2]" : "[2, 2, 2]") + "}\n");
            }

            Scene read(unsigned int dimension, const std::string &keys) const
            {
                return loadScene(file(dimension, keys));
            }

            const Folder folder_;
        };
    }

    TEST_F(YamlOctomap, IsReadWithItsOptions)
    {
        const Scene scene = read(3, "type: octomap, file: map.bt");
        ASSERT_EQ(scene.getSensedObstacles().size(), 1U);
        const auto clearanceOf = [this](unsigned int dimension, const std::string &keys, const Eigen::Vector3d &point)
        { return read(dimension, "type: octomap, file: map.bt" + keys).makeObstacles()->clearance(point); };
        EXPECT_NO_THROW(scene.validate());
        // A building ends at x = 7 and y = 7, beyond which the map has a row of cells that it touches. It is 8 high.
        EXPECT_NEAR(clearanceOf(3, "", {9.0, 5.0, 3.0}), 1.75, 1e-9);
        EXPECT_NEAR(clearanceOf(3, ", depth: 14", {9.0, 5.0, 3.0}), 1.0, 1e-9);
        EXPECT_NEAR(clearanceOf(2, ", heights: [3, 4]", {9.0, 5.0, 0.0}), 1.75, 1e-9);
        EXPECT_GT(clearanceOf(2, ", heights: [10, 11]", {9.0, 5.0, 0.0}), 1.75);
        EXPECT_NEAR(clearanceOf(3, ", origin: [0.5, 0, 100]", {9.0, 5.0, 103.0}), 1.25, 1e-9);
        EXPECT_NEAR(clearanceOf(2, ", heights: [103, 104], origin: [0.5, 0, 100]", {9.0, 5.0, 0.0}), 1.25, 1e-9);
        EXPECT_GT(clearanceOf(2, ", heights: [3, 4], origin: [0.5, 0, 100]", {9.0, 5.0, 0.0}), 1.75);
        // All cells of the scene are known.
        EXPECT_NEAR(clearanceOf(3, ", unknown: occupied", {9.0, 5.0, 3.0}), 1.75, 1e-9);
        EXPECT_NEAR(clearanceOf(3, ", unknown: free", {9.0, 5.0, 3.0}), 1.75, 1e-9);
    }

    TEST_F(YamlOctomap, IsNamedInMessages)
    {
        std::string text = "type: octomap, file: map.bt, heights: [3, 4]";
        const std::string path = file(2, text);
        std::string scene = folder_.read("scene.yaml");
        scene.replace(scene.find("[1, 1]"), 6, "[5, 5]");
        folder_.write("scene.yaml", scene);
        const std::string message = messageOf([&] { loadScene(path).validate(); });
        EXPECT_NE(message.find("touches environment.obstacles[0]"), std::string::npos) << message;
    }

    TEST_F(YamlOctomap, NamesFileLineAndKeyOfWhatIsWrong)
    {
        struct Broken
        {
            unsigned int dimension;
            const char *keys, *complaint;
        };
        const Broken broken[] = {
            {3, "type: octomap", ".file: missing"},
            {3, "type: octomap, file: none.bt", "none.bt"},
            {3, "type: octomap, file: broken.bt", "broken.bt: ends before its data"},
            {3, "type: octomap, file: map.bt, depth: 17", ".depth: must be a whole number from 1 to 16, not 17"},
            {3, "type: octomap, file: map.bt, depth: 15.5", ".depth: must be a whole number from 1 to 16, not 15.5"},
            {3, "type: octomap, file: map.bt, unknown: maybe", ".unknown: must be free or occupied, not 'maybe'"},
            {3, "type: octomap, file: map.bt, heights: [0, 1]", ".heights: unknown key"},
            {3, "type: octomap, file: map.bt, origin: [0, 0]", ".origin: must"},
            {3, "type: octomap, file: map.bt, center: [0, 0, 0]", ".center: unknown key"},
            {2, "type: octomap, file: map.bt", ".heights: missing"},
            {2, "type: octomap, file: map.bt, heights: [1, 1]", ".heights: its low end must be below its high one"},
            {2, "type: octomap, file: map.bt, heights: [1]", ".heights: must"}};
        for (const auto &[dimension, keys, complaint] : broken)
        {
            SCOPED_TRACE(keys);
            const std::string path = file(dimension, keys), message = messageOf([&] { loadScene(path); }),
                              begin = path + ":5: environment.obstacles[0]";
            EXPECT_EQ(message.compare(0, begin.size(), begin), 0) << message;
            EXPECT_NE(message.find(complaint), std::string::npos) << message;
        }
    }
}
