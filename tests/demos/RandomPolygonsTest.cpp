#include "files/WholeFile.h"
#include "generators/RandomPolygons.h"

#include <gtest/gtest.h>
#include <limits>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    TEST(RandomPolygons, SameSeedSameText)
    {
        generators::PolygonSettings settings;
        settings.seed = 7;
        const std::string text = generators::randomPolygonsYaml(settings);
        EXPECT_EQ(generators::randomPolygonsYaml(settings), text);
        settings.seed = 8;
        EXPECT_NE(generators::randomPolygonsYaml(settings), text);
    }

    TEST(RandomPolygons, MadeTheScenesOfThePaper)
    {
        for (const auto &[robots, name] : {std::pair(1u, "one_disc"), {3u, "three_discs"}, {5u, "five_discs"}})
        {
            generators::PolygonSettings settings;
            settings.robots = robots;
            settings.seed = 1;
            EXPECT_EQ(generators::randomPolygonsYaml(settings),
                      readWholeFile(OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/paper_" + std::string(name) + ".yaml"));
        }
    }

    TEST(RandomPolygons, IsValidInAllSizes)
    {
        for (const double size : {0.01, 1.0, 100.0, 1e6})
            for (std::uint64_t seed = 0; seed < 10; ++seed)
            {
                generators::PolygonSettings settings;
                settings.size = size;
                settings.radius = 0.01 * size;
                settings.seed = seed;
                SCOPED_TRACE(std::to_string(size) + " " + std::to_string(seed));
                const Scene scene = generators::randomPolygons(settings);
                EXPECT_EQ(scene.getObstacles().size(), settings.obstacles);
                EXPECT_EQ(scene.getMembers().size(), 5u);
                EXPECT_NO_THROW(scene.validate());
            }
    }

    TEST(RandomPolygons, RefusesNonsense)
    {
        const auto refuses = [](auto change)
        {
            generators::PolygonSettings settings;
            change(settings);
            EXPECT_THROW(generators::randomPolygonsYaml(settings), ompl::Exception);
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
