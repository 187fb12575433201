// Makes scenes from a seed: the paper's discs among random polygons, carts in a maze, quadrotors in a canyon, or gears
// among knots. The last three write their meshes next to the scene.
//
//     generate_scene --robots 3 --seed 7 --output scene.yaml
//     generate_scene --kind canyon --output canyon.yaml

#include "common/CommandLine.h"
#include "common/Outputs.h"
#include "generators/MeshScenes.h"
#include "generators/RandomPolygons.h"

int main(int argc, char **argv)
{
    generators::PolygonSettings settings;
    std::string kind = "polygons", output = "-";

    CLI::App app("Make a scene", "generate_scene");
    app.add_option("--kind", kind, "polygons: discs among random convex polygons; maze, canyon, knots: meshes")
        ->check(demos::oneOf({"polygons", "maze", "canyon", "knots"}))
        ->capture_default_str();
    auto *robots =
        app.add_option("--robots", settings.robots, "number of robots")->default_str("5 of polygons, else 3");
    const std::vector<CLI::Option *> ofPolygons{
        app.add_option("--obstacles", settings.obstacles, "number of polygons")->capture_default_str(),
        app.add_option("--size", settings.size, "side of the polygons' square")->capture_default_str(),
        app.add_option("--radius", settings.radius, "radius of the discs")->capture_default_str()};
    app.add_option("--seed", settings.seed, "seed; the same settings make the same scene")->capture_default_str();
    app.add_option("--output", output, "file to write, - for standard output (polygons only)")->capture_default_str();
    const auto generate = [&]
    {
        if (kind == "polygons")
        {
            demos::writeOutput(output, generators::randomPolygonsYaml(settings));
            return 0;
        }
        for (const CLI::Option *option : ofPolygons)
            if (option->count() > 0)
                throw CLI::ValidationError(option->get_name(), "is for --kind polygons");
        if (output == "-")
            throw CLI::ValidationError("--output", "must name a file: the meshes are written next to it");
        generators::MeshSettings ofMeshes;
        ofMeshes.robots = robots->count() > 0 ? settings.robots : ofMeshes.robots;
        ofMeshes.seed = settings.seed;
        const auto make = kind == "maze"     ? generators::mazeOfMeshes
                          : kind == "canyon" ? generators::canyonOfMeshes
                                             : generators::knotsOfMeshes;
        generators::writeScene(make(ofMeshes), output);
        return 0;
    };
    return demos::runProgram(app, argc, argv, generate);
}
