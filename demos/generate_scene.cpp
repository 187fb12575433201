// Makes a scene like those of the paper's experiments: discs among random convex polygons in a square.
//
//     generate_scene --robots 3 --seed 7 --output scene.yaml

#include "ompl_certificates/scene/RandomPolygonScene.h"
#include "ompl_certificates/scene/TextFile.h"

#include <CLI/CLI.hpp>
#include <iostream>

int main(int argc, char **argv)
{
    using ompl_certificates::RandomPolygonScene;
    RandomPolygonScene::Settings settings;
    std::string output = "-";

    CLI::App app("Make a scene of discs among random convex polygons in a square");
    app.add_option("--robots", settings.robots, "number of discs")->capture_default_str();
    app.add_option("--obstacles", settings.obstacles, "number of polygons")->capture_default_str();
    app.add_option("--size", settings.size, "side of the square")->capture_default_str();
    app.add_option("--radius", settings.radius, "radius of the discs")->capture_default_str();
    app.add_option("--seed", settings.seed, "seed; the same settings make the same scene")->capture_default_str();
    app.add_option("--output", output, "file to write, - for the terminal")->capture_default_str();
    try
    {
        app.parse(argc, argv);
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
