// Makes scenes from a seed: the paper's discs among random polygons, carts in a maze, quadrotors in a canyon, or gears
// among knots. The last three write their meshes next to the scene.
//
//     generate_scene --robots 3 --seed 7 --output scene.yaml
//     generate_scene --kind canyon --output canyon.yaml

#include "ompl_certificates/scene/MeshScene.h"
#include "ompl_certificates/scene/RandomPolygonScene.h"
#include "ompl_certificates/scene/TextFile.h"

#include <CLI/CLI.hpp>
#include <iostream>

int main(int argc, char **argv)
{
    using ompl_certificates::MeshScene;
    using ompl_certificates::RandomPolygonScene;
    RandomPolygonScene::Settings settings;
    std::string kind = "polygons", output = "-";

    CLI::App app("Make a scene");
    app.add_option("--kind", kind, "polygons: discs among random convex polygons; maze, canyon, knots: meshes")
        ->check(CLI::IsMember({"polygons", "maze", "canyon", "knots"}))
        ->capture_default_str();
    auto *robots =
        app.add_option("--robots", settings.robots, "number of robots")->default_str("5 of polygons, else 3");
    const std::vector<CLI::Option *> ofPolygons{
        app.add_option("--obstacles", settings.obstacles, "number of polygons")->capture_default_str(),
        app.add_option("--size", settings.size, "side of the polygons' square")->capture_default_str(),
        app.add_option("--radius", settings.radius, "radius of the discs")->capture_default_str()};
    app.add_option("--seed", settings.seed, "seed; the same settings make the same scene")->capture_default_str();
    app.add_option("--output", output, "file to write, - for the terminal (polygons only)")->capture_default_str();
    try
    {
        app.parse(argc, argv);
        if (kind != "polygons")
        {
            for (const CLI::Option *option : ofPolygons)
                if (option->count() > 0)
                    throw CLI::ValidationError(option->get_name(), "is for --kind polygons");
            if (output == "-")
                throw CLI::ValidationError("--output", "must name a file: the meshes are written next to it");
            MeshScene::Settings ofMeshes;
            ofMeshes.robots = robots->count() > 0 ? settings.robots : ofMeshes.robots;
            ofMeshes.seed = settings.seed;
            const auto make = kind == "maze"     ? MeshScene::maze
                              : kind == "canyon" ? MeshScene::canyon
                                                 : MeshScene::knots;
            make(ofMeshes).write(output);
            return 0;
        }
        const std::string yaml = RandomPolygonScene(settings).toYaml();
        if (output == "-")
            std::cout << yaml << std::flush;
        else
            ompl_certificates::writeTextFile(output, yaml);
        return std::cout ? 0 : 2;
    }
    catch (const CLI::ParseError &error)
    {
        return app.exit(error) == 0 ? 0 : 2;
    }
    catch (const std::exception &error)
    {
        std::cerr << "generate_scene: " << error.what() << "\n";
        return 2;
    }
}
