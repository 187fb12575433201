#include "ompl_certificates/scene/RandomPolygonScene.h"
#include "certificates/WholeFile.h"

#include <gtest/gtest.h>
#include <limits>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    TEST(RandomPolygonScene, SameSeedSameText)
    {
        RandomPolygonScene::Settings settings;
        settings.seed = 7;
        const std::string text = RandomPolygonScene(settings).toYaml();
        EXPECT_EQ(RandomPolygonScene(settings).toYaml(), text);
        settings.seed = 8;
        EXPECT_NE(RandomPolygonScene(settings).toYaml(), text);
    }

    TEST(RandomPolygonScene, MadeTheScenesOfThePaper)
    {
        for (const auto &[robots, name] : {std::pair(1u, "one_disc"), {3u, "three_discs"}, {5u, "five_discs"}})
        {
            RandomPolygonScene::Settings settings;
            settings.robots = robots;
            settings.seed = 1;
            EXPECT_EQ(RandomPolygonScene(settings).toYaml(),
                      readWholeFile(OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/paper_" + std::string(name) + ".yaml"));
        }
    }

    TEST(RandomPolygonScene, IsValidInAllSizes)
    {
        for (const double size : {0.01, 1.0, 100.0, 1e6})
            for (std::uint64_t seed = 0; seed < 10; ++seed)
            {
                RandomPolygonScene::Settings settings;
                settings.size = size;
                settings.radius = 0.01 * size;
                settings.seed = seed;
                SCOPED_TRACE(std::to_string(size) + " " + std::to_string(seed));
                const YamlScene scene = RandomPolygonScene(settings).make();
                EXPECT_EQ(scene.getObstacles().size(), settings.obstacles);
                EXPECT_EQ(scene.getMembers().size(), 5u);
                EXPECT_NO_THROW(scene.validate());
            }
    }

    TEST(RandomPolygonScene, RefusesNonsense)
    {
        const auto refuses = [](auto change)
        {
            RandomPolygonScene::Settings settings;
            change(settings);
            EXPECT_THROW(RandomPolygonScene(settings).toYaml(), ompl::Exception);
        };
        refuses([](auto &settings) { settings.robots = 0; });
        refuses([](auto &settings) { settings.robots = 1000; });
        refuses([](auto &settings) { settings.obstacles = 1000000; });
        refuses([](auto &settings) { settings.size = -1.0; });
        refuses([](auto &settings) { settings.size = std::numeric_limits<double>::quiet_NaN(); });
        refuses([](auto &settings) { settings.radius = 0.0; });
        refuses([](auto &settings) { settings.radius = 50.0; });
        refuses([](auto &settings) { settings.obstacles = 10000; });  // no place left
    }
}
