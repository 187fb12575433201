#include "YamlSensed.h"
#include "YamlRobots.h"
#include "YamlShapes.h"
#include "YamlText.h"
#include "ompl_certificates/scene/SceneFile.h"

#include <filesystem>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t MAX_OBSTACLES = 100000, MAX_ROBOTS = 1000;
    }

    Scene sceneFromYaml(const std::string &text, const std::string &source, bool dynamics)
    {
        const YamlNode root = parseYaml(text, source);
        root.allow({"name", "resolution", "environment", "robots"});
        const YamlNode environment = root.at("environment");
        environment.allow({"dimension", "min", "max", "obstacles"});

        unsigned int dimension = 0;
        if (environment.has("dimension"))
        {
            const double value = environment.at("dimension").number();
            dimension = value == 2.0 ? 2 : value == 3.0 ? 3 : 0;
            if (dimension == 0)
                environment.at("dimension").fail("must be 2 or 3, not " + environment.at("dimension").describe());
        }
        else
            dimension = static_cast<unsigned int>(environment.at("min").items(2, 3).size());

        const std::string name =
            root.has("name") ? root.at("name").text() : std::filesystem::path(source).stem().string();
        Scene scene(name, source, readBounds(environment, dimension));
        if (root.has("resolution"))
        {
            const double resolution = root.at("resolution").positive();
            if (resolution < Scene::FINEST_RESOLUTION || resolution >= 1.0)
                root.at("resolution")
                    .fail("must be at least 1e-6 and below 1, not " + root.at("resolution").describe());
            scene.setResolution(resolution);
        }
        YamlMeshes meshes;
        if (environment.has("obstacles"))
            for (const YamlNode &obstacle : environment.at("obstacles").items(0, MAX_OBSTACLES))
            {
                const std::string type = obstacle.at("type").text();
                const std::string title =
                    obstacle.has("name") ? "'" + obstacle.at("name").text() + "'" : obstacle.getKey();
                if (type == "cloud")
                    scene.addSensedObstacles(readCloud(obstacle, dimension), title);
                else if (type == "octomap")
                    scene.addSensedObstacles(readOctomap(obstacle, dimension), title);
                else if (type == "occupancy_map")
                    scene.addSensedObstacles(readOccupancyMap(obstacle, dimension), title);
                else
                    scene.addObstacle(readObstacle(obstacle, dimension, meshes), title);
            }
        const std::vector<YamlNode> robots = root.at("robots").items(1, MAX_ROBOTS);
        YamlArms arms(robots);
        for (const YamlNode &robot : robots)
            readRobot(robot, dynamics, scene, meshes, arms);
        for (const std::string &note : root.getNotes())
            scene.addNote(note);
        for (const std::string &path : root.getPaths())
            scene.addFile(path);
        scene.chooseGoals();
        return scene;
    }
}
