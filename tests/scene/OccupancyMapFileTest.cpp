#include "support/Folder.h"
#include "support/Message.h"
#include "support/Random.h"

#include "ompl_certificates/scene/OccupancyMapFile.h"
#include "ompl_certificates/scene/SceneFile.h"

#include <gtest/gtest.h>

namespace ompl_certificates
{
    using namespace test;

    namespace
    {
        /** A map of 3 x 2 cells: the lower left one is occupied, the one above it unknown */
        const std::string IMAGE = "P2\n# a comment\n3 2\n255\n205 254 254\n0 254 254\n";
        const std::string MAP =
            "image: map.pgm\nresolution: 0.5\norigin: [-10, 20.25, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
            "free_thresh: 0.196\n";

        const std::string SCENE =
            "environment:\n  min: [-20, 0]\n  max: [20, 40]\n  obstacles:\n    - {type: occupancy_map, file: map.yaml}\n"
            "robots:\n  - {name: a, type: rigid, space: R2, shape: {type: disc, radius: 0.1}, start: [0, 0], goal: [1, 1]}\n";

        /** Whether cells are obstacles, by their middles: those of each row, the lowest first */
        std::string drawn(const CellObstacles &map, int width, int height)
        {
            std::string cells;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                {
                    const Eigen::Vector3d middle =
                        map.getOrigin() + map.getCellSize() * Eigen::Vector3d(x + 0.5, y + 0.5, 0.0);
                    cells += map.clearance(middle) < 0.0 ? '#' : '.';
                }
            return cells;
        }

        std::string drawn(const std::string &map, const std::string &image, bool unknownIsOccupied = false,
                          int width = 3, int height = 2)
        {
            Folder folder;
            folder.write("map.pgm", image);
            return drawn(*loadOccupancyMap(folder.write("map.yaml", map), unknownIsOccupied), width, height);
        }

        std::string replaced(std::string text, const std::string &from, const std::string &to)
        {
            return text.replace(text.find(from), from.size(), to);
        }

        std::string errorOf(const std::string &map, const std::string &image)
        {
            Folder folder;
            folder.write("map.pgm", image);
            const std::string file = folder.write("map.yaml", map);
            const std::string message = messageOf([&] { loadOccupancyMap(file); });
            EXPECT_EQ(message.rfind(file + ":", 0), 0U) << message;
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
            return message.empty() ? message : message.substr(file.size());
        }
    }

    TEST(OccupancyMapFile, IsWhatMapServerShows)
    {
        EXPECT_EQ(drawn(MAP, IMAGE), "#.....");
        EXPECT_EQ(drawn(MAP, IMAGE, true), "#..#..");
        EXPECT_EQ(drawn(replaced(MAP, "negate: 0", "negate: 1"), IMAGE), ".#####");
        EXPECT_EQ(drawn(replaced(MAP, "negate: 0", "negate: true"), IMAGE), ".#####");
        // 205 of 255 is 0.196 dark.
        EXPECT_EQ(drawn(replaced(replaced(MAP, "0.65", "0.19"), "0.196", "0.1"), IMAGE), "#..#..");
        EXPECT_EQ(drawn("image: map.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nmode: scale\n", IMAGE), "#.....");
        EXPECT_EQ(drawn(MAP, std::string("P5\n3 2\n255\n\xCD\xFE\xFE\0\xFE\xFE", 17)), "#.....");
        EXPECT_EQ(drawn(MAP, "P1\n3 2\n0 0 1\n1 0 0\n"), "#....#");
        EXPECT_EQ(
            drawn(MAP,
                  std::string("P6\n3 2\n255\n\0\0\0\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF", 29)),
            "...#..");
        EXPECT_EQ(drawn(MAP, "P3\n3 2\n255\n0 0 0 9 9 9 255 255 255\n255 255 255 0 0 0 255 255 255\n"), ".#.##.");
        // Colors count by their mean: green is two thirds dark, and red.
        EXPECT_EQ(drawn(MAP, "P3\n3 2\n255\n0 255 0 255 0 0 255 255 255\n255 255 255 0 0 255 255 255 0\n"), ".#.##.");
    }

    /** A pixel at a threshold is beyond neither. */
    TEST(OccupancyMapFile, HasPixelsAtItsThresholds)
    {
        const std::string image = "P2\n3 1\n255\n0 127 255\n";
        const auto drawnWith = [&](const std::string &occupied, const std::string &free, bool unknownIsOccupied)
        { return drawn(replaced(replaced(MAP, "0.65", occupied), "0.196", free), image, unknownIsOccupied, 3, 1); };
        EXPECT_EQ(drawnWith("0.65", "0.196", true), "##.");
        EXPECT_EQ(drawnWith("1.0", "0.196", false), "...");
        EXPECT_EQ(drawnWith("0.65", "0", true), "###");
    }

    TEST(OccupancyMapFile, ReadsBitsTextsAndSixteenBits)
    {
        const std::string map = "image: map.pgm\nresolution: 0.5\norigin: [0, 0, 6.283185307179586]\n";
        // Rows are drawn from below, and 1 is black.
        const auto bytes = [](const std::string &header, const std::vector<int> &values)
        {
            std::string image = header;
            for (const int value : values)
                image += static_cast<char>(value);
            return image;
        };
        EXPECT_EQ(drawn(map, bytes("P4\n3 2\n", {0x80, 0x60})), ".###..");
        EXPECT_EQ(drawn(map, bytes("P4 # wide\n8 1\n", {0x81}), false, 8, 1), "#......#");
        EXPECT_EQ(drawn(map, bytes("P4\n9 2\n", {0x01, 0x80, 0x00, 0x80}), false, 9, 2), "........#.......##");
        EXPECT_EQ(drawn(map, "P1\n3 2\n# more\n1 0 0 0 1 1\n"), ".###..");
        EXPECT_EQ(drawn(map, "P1\n3 2\n100\n011"), ".###..");
        EXPECT_EQ(drawn(map, "P2\n3 2\n255\n0 255 255\n# a row\n255 0 0"), ".###..");
        EXPECT_EQ(drawn(map, "P2\n3 2\n100\n0 100 100 100 0 0\n"), ".###..");
        const std::vector<int> sixteen{0, 255, 255, 0, 255, 255, 255, 255, 0, 255, 0, 255};
        EXPECT_EQ(drawn(map, bytes("P5\n3 2\n65535\n", sixteen)), ".###..");
    }

    TEST(OccupancyMapFile, HasEachPixelWhereItIs)
    {
        for (unsigned int seed = 1; seed <= scaled(100); ++seed)
        {
            SCOPED_TRACE("seed " + std::to_string(seed));
            Random random(seed);
            const int width = 1 + static_cast<int>(random.below(40)), height = 1 + static_cast<int>(random.below(40));
            std::string pixels, expected;
            for (int y = height - 1; y >= 0; --y)
                for (int x = 0; x < width; ++x)
                    pixels += random.chance(0.3) ? '\0' : random.chance(0.1) ? '\xCD' : '\xFE';
            for (int y = height - 1; y >= 0; --y)
                for (int x = 0; x < width; ++x)
                    expected += pixels[static_cast<std::size_t>(y * width + x)] == '\0' ? '#' : '.';
            Folder folder;
            folder.write("map.pgm", "P5 " + std::to_string(width) + ' ' + std::to_string(height) + "\n255\n" + pixels);
            const auto map = loadOccupancyMap(folder.write("map.yaml", MAP));
            ASSERT_EQ(map->getOrigin(), Eigen::Vector3d(-10.0, 20.25, 0.0));
            ASSERT_EQ(map->getCellSize(), 0.5);
            ASSERT_EQ(map->getDimension(), 2U);
            ASSERT_EQ(drawn(*map, width, height), expected);
        }
    }

    TEST(OccupancyMapFile, RefusesWhatIsNoMap)
    {
        const auto without = [](const std::string &line) { return replaced(MAP, line, "#" + line); };
        EXPECT_NE(errorOf(without("image"), IMAGE).find("image"), std::string::npos);
        EXPECT_NE(errorOf(without("resolution"), IMAGE).find("resolution"), std::string::npos);
        EXPECT_NE(errorOf(without("origin"), IMAGE).find("origin"), std::string::npos);
        EXPECT_NE(errorOf(replaced(MAP, "0.5", "0"), IMAGE).find(":2: resolution: must be"), std::string::npos);
        EXPECT_NE(errorOf(replaced(MAP, "20.25, 0", "20.25, 0.1"), IMAGE).find(":3: origin: its angle must be 0"),
                  std::string::npos);
        EXPECT_NE(errorOf(replaced(MAP, "0.65", "1.65"), IMAGE).find(":5: occupied_thresh: must be from 0 to 1"),
                  std::string::npos);
        EXPECT_NE(errorOf(replaced(MAP, "0.196", "0.7"), IMAGE).find(":6: free_thresh: must not be above"),
                  std::string::npos);
        EXPECT_NE(errorOf("image: map.pgm\nresolution: 1\norigin: [0, 0, 0]\noccupied_thresh: 0.1\n", IMAGE)
                      .find(":4: occupied_thresh: is below free_thresh"),
                  std::string::npos);
        EXPECT_NE(errorOf(replaced(MAP, "negate: 0", "negate: 2"), IMAGE).find(":4: negate: must be true or false"),
                  std::string::npos);
        EXPECT_NE(errorOf(MAP + "negate: 0\nnegate: 1\n", IMAGE).find("given twice"), std::string::npos);
        EXPECT_NE(errorOf(MAP + "mode: raw\n", IMAGE).find(":7: mode: must be trinary or scale, not 'raw'"),
                  std::string::npos);
        EXPECT_NE(errorOf(replaced(MAP, "map.pgm", "other.pgm"), IMAGE).find(":1: image: "), std::string::npos);
        for (const std::string &image :
             {std::string(), std::string("P5"), std::string("P5\n3 2\n255\n\xFE"), IMAGE.substr(0, 30),
              std::string("P7\n3 2\n255\n"), std::string("\x89PNG\r\n\x1A\n"), std::string("P5\n0 2\n255\n"),
              std::string("P5\n-3 2\n255\n"), std::string("P5\n99999 1\n255\n"), std::string("P5\n30000 30000\n255\n"),
              std::string("P2\n3 2\n0\n0 0 0 0 0 0\n"), std::string("P2\n3 2\n70000\n0 0 0 0 0 0\n"),
              std::string("P2\n3 2\n255\n0 abc 255\n255 0 0\n"), std::string("P2\n3 2\n255\n0 -255 255\n255 0 0\n"),
              std::string("P2\n3 2\n100\n0 101 0\n0 0 0\n"), std::string("P1\n3 2\n1 0 2\n0 0 0\n"),
              std::string("P1\n3 2\n10001\n"), std::string("P4\n9 2\n\x01\x80\x01"), std::string("P5\n3 2\n255")})
        {
            EXPECT_NE(errorOf(MAP, image).find(":1: image: "), std::string::npos) << image;
            EXPECT_NE(errorOf(MAP, image).find("/map.pgm: it"), std::string::npos) << image;
        }
    }

    TEST(OccupancyMapFile, IsAnObstacleOfScenes)
    {
        Folder folder;
        folder.write("map.pgm", IMAGE);
        folder.write("map.yaml", MAP);
        const auto obstaclesOf = [&](const std::string &scene)
        { return loadScene(folder.write("scene.yaml", scene)).getSensedObstacles(); };
        ASSERT_EQ(obstaclesOf(SCENE).size(), 1U);
        const auto drawing = [&](const std::string &scene)
        { return drawn(dynamic_cast<const CellObstacles &>(*obstaclesOf(scene)[0]), 3, 2); };
        EXPECT_EQ(drawing(SCENE), "#.....");
        EXPECT_EQ(drawing(replaced(SCENE, "map.yaml}", "map.yaml, unknown: occupied}")), "#..#..");
        const auto errorOfScene = [&](const std::string &scene) { return messageOf([&] { obstaclesOf(scene); }); };
        const std::string error = errorOfScene(replaced(SCENE, "map.yaml}", "map.yaml, unknown: maybe}")),
                          expected = "environment.obstacles[0].unknown: must be free or occupied, not 'maybe'";
        EXPECT_NE(error.find(expected), std::string::npos) << error;
        EXPECT_EQ(error.find(".file: "), std::string::npos) << error;
        EXPECT_NE(errorOfScene(replaced(SCENE, "map.yaml}", "none.yaml}")).find("environment.obstacles[0].file: "),
                  std::string::npos);
        EXPECT_NE(errorOfScene("environment: {min: [0, 0, 0], max: [1, 1, 1], obstacles: [{type: occupancy_map, file: "
                               "map.yaml}]}\nrobots: []\n")
                      .find("an occupancy_map is for the plane"),
                  std::string::npos);
    }
}
