#include "files/WholeFile.h"
#include "generators/MeshScenes.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "support/Folder.h"
#include "support/Random.h"

#include <gtest/gtest.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        using generators::MeshSettings;
        using Make = generators::SceneTexts (*)(const MeshSettings &);

        struct Kind
        {
            const char *name;
            Make make;
            std::vector<const char *> meshes;
        };

        const Kind KINDS[] = {{"maze", generators::mazeOfMeshes, {"walls", "cart"}},
                              {"canyon", generators::canyonOfMeshes, {"terrain", "quadrotor"}},
                              {"knots", generators::knotsOfMeshes, {"knot", "gear"}}};

        std::size_t countTriangles(const Scene &scene)
        {
            std::size_t count = 0;
            for (const PlacedBody &obstacle : scene.getObstacles())
                for (const Body::Part &part : obstacle.body.getParts())
                    count += part.shape.getMesh()->getTriangles().size();
            return count;
        }
    }

    /** Large meshes are not shipped but made when the demos are built; each one that is there is as it is made. */
    TEST(MeshScenes, MadeTheScenesOfTheDemos)
    {
        const test::Folder folder;
        for (const Kind &kind : KINDS)
        {
            SCOPED_TRACE(kind.name);
            const std::string name = kind.name, shipped = OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/";
            writeScene(kind.make({}), folder / (name + ".yaml"));
            EXPECT_EQ(readWholeFile(folder / (name + ".yaml")), readWholeFile(shipped + name + ".yaml"));
            for (const std::string mesh : kind.meshes)
            {
                const std::string file = name + "_" + mesh + ".obj";
                if (mesh == "terrain" && !std::filesystem::exists(shipped + file))
                    continue;
                EXPECT_TRUE(readWholeFile(folder / file) == readWholeFile(shipped + file)) << file;
            }
        }
        EXPECT_GE(countTriangles(loadScene(folder / "canyon.yaml")), 100000u);
    }

    TEST(MeshScenes, CanBeSolved)
    {
        const test::Folder folder;
        for (const Kind &kind : KINDS)
        {
            SCOPED_TRACE(kind.name);
            MeshSettings settings;
            settings.robots = 2;
            writeScene(kind.make(settings), folder / "scene.yaml");
            const TeamSetupPtr setup = loadScene(folder / "scene.yaml").makeSetup();
            setup->setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup->getSpaceInformation()));
            EXPECT_EQ(setup->solve(60.0), ompl::base::PlannerStatus::EXACT_SOLUTION);
        }
    }

    TEST(MeshScenes, StartsAndGoalsAreFreeForEachSeed)
    {
        const test::Folder folder;
        for (const Kind &kind : KINDS)
            for (std::uint64_t seed = 2; seed < 2 + test::scaled(kind.make == generators::canyonOfMeshes ? 1 : 4);
                 ++seed)
            {
                SCOPED_TRACE(kind.name + std::string(", seed ") + std::to_string(seed));
                MeshSettings settings;
                settings.seed = seed;
                settings.robots = 2 * static_cast<unsigned int>(seed);
                writeScene(kind.make(settings), folder / "scene.yaml");
                const Scene scene = loadScene(folder / "scene.yaml");
                EXPECT_NO_THROW(scene.validate());
                EXPECT_EQ(scene.getMembers().size(), settings.robots);
                EXPECT_GT(countTriangles(scene), 500u);
            }
    }

    TEST(MeshScenes, RefusesSettingsThatMakeNoSense)
    {
        MeshSettings settings;
        for (const unsigned int robots : {0u, 13u})
            for (const Kind &kind : KINDS)
            {
                settings.robots = robots;
                EXPECT_THROW(kind.make(settings), ompl::Exception);
            }
        EXPECT_THROW(writeScene(generators::mazeOfMeshes({}), "/nowhere/at/all/scene.yaml"), ompl::Exception);
    }
}
