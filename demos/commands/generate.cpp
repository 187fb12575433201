// Makes scenes from a seed: the paper's discs among random polygons; carts in a maze, quadrotors in a canyon, or gears
// among knots; drones in a point cloud; and larger teams of six kinds. Meshes and clouds are written next to the
// scene's file.
//
//     certificates generate --robots 3 --seed 7 --output scene.yaml
//     certificates generate --kind canyon --output canyon.yaml
//     certificates generate --kind boxes --robots 16 --output boxes_16.yaml

#include "commands/Commands.h"
#include "common/CommandLine.h"
#include "common/Outputs.h"
#include "generators/CloudScenes.h"
#include "generators/MeshScenes.h"
#include "generators/RandomPolygons.h"
#include "generators/TeamScenes.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <sstream>

namespace
{
    /** A kind of scene, what it is and its defaults, which of the options it takes, and how one of it is made */
    struct Kind
    {
        std::string name, description;
        std::vector<std::string> options;
        std::function<generators::SceneTexts()> make;
    };

    /** What was given; what was not is the kind's own */
    struct Given
    {
        std::optional<unsigned int> robots, obstacles, points;
        std::optional<double> size, radius;
        std::uint64_t seed{1};
    };

    std::vector<Kind> kindsOf(const Given &given)
    {
        std::vector<Kind> kinds;
        const auto polygons = [&given]
        {
            generators::PolygonSettings settings;
            settings.robots = given.robots.value_or(settings.robots);
            settings.obstacles = given.obstacles.value_or(settings.obstacles);
            settings.size = given.size.value_or(settings.size);
            settings.radius = given.radius.value_or(settings.radius);
            settings.seed = given.seed;
            return generators::SceneTexts{generators::randomPolygonsYaml(settings), {}};
        };
        kinds.push_back({"polygons",
                         "5 discs of radius 1 among 25 random convex polygons, size 100",
                         {"--obstacles", "--size", "--radius"},
                         polygons});
        const auto addMeshes = [&](const std::string &name, const std::string &description, const auto &make)
        {
            const auto meshes = [&given, make]
            {
                generators::MeshSettings settings;
                settings.robots = given.robots.value_or(settings.robots);
                settings.seed = given.seed;
                return make(settings);
            };
            kinds.push_back({name, description, {}, meshes});
        };
        addMeshes("maze", "3 carts in a maze, of meshes", generators::mazeOfMeshes);
        addMeshes("canyon", "3 quadrotors in a canyon, of meshes", generators::canyonOfMeshes);
        addMeshes("knots", "3 gears among knots, of meshes", generators::knotsOfMeshes);
        const auto cloud = [&given]
        {
            generators::CloudSettings settings;
            settings.robots = given.robots.value_or(settings.robots);
            settings.points = given.points.value_or(settings.points);
            settings.seed = given.seed;
            return generators::droneCloud(settings);
        };
        kinds.push_back({"cloud", "4 drones in a building, of 6000 points", {"--points"}, cloud});
        for (const generators::TeamKind &team : generators::teamKinds())
        {
            std::ostringstream description;
            description << team.description << ": " << team.defaults.robots << " robots, ";
            if (team.hasObstacles)
                description << team.defaults.obstacles << " obstacles, ";
            description << "size " << team.defaults.size;
            const auto make = [&given, &team]
            {
                return team.make({given.robots.value_or(team.defaults.robots),
                                  given.obstacles.value_or(team.defaults.obstacles),
                                  given.size.value_or(team.defaults.size), given.seed});
            };
            kinds.push_back({team.name, description.str(), {"--size"}, make});
            if (team.hasObstacles)
                kinds.back().options.push_back("--obstacles");
        }
        return kinds;
    }

    /** What the arguments say, and the work itself */
    struct Generator
    {
        int generate() const
        {
            const Kind &kind =
                *std::find_if(kinds.begin(), kinds.end(), [this](const Kind &other) { return other.name == name; });
            for (const CLI::Option *option : ofSomeKinds)
                if (option->count() > 0 &&
                    std::find(kind.options.begin(), kind.options.end(), option->get_name()) == kind.options.end())
                    throw CLI::ValidationError(option->get_name(), "is not for --kind " + kind.name);
            const generators::SceneTexts scene = kind.make();
            if (output != "-")
                generators::writeScene(scene, output);
            else if (scene.meshes.empty())
                demos::writeOutput(output, scene.yaml);
            else
                throw CLI::ValidationError("--output", "must name a file: the meshes are written next to it");
            return demos::SOLVED;
        }

        Given given;
        std::vector<Kind> kinds{kindsOf(given)};
        std::string name{"polygons"}, output{"-"};
        std::vector<const CLI::Option *> ofSomeKinds;
    };
}

demos::Work demos::declareGenerate(CLI::App &app)
{
    const auto generator = std::make_shared<Generator>();
    Given &given = generator->given;
    std::vector<std::string> names;
    std::string footer = "Kinds, and their defaults:\n";
    for (const Kind &kind : generator->kinds)
    {
        names.push_back(kind.name);
        footer += "  " + kind.name + std::string(11 - kind.name.size(), ' ') + kind.description + "\n";
    }
    app.footer(footer);
    app.add_option("--kind", generator->name, "the kind of scene, see below")
        ->check(oneOf(names))
        ->capture_default_str();
    // Kinds have limits of their own.
    constexpr unsigned long long most = 1000000000ull;
    app.add_option("--robots", given.robots, "number of robots")->check(demos::countUpTo(most, 0));
    generator->ofSomeKinds = {
        app.add_option("--obstacles", given.obstacles, "number of random obstacles")->check(demos::countUpTo(most, 0)),
        app.add_option("--size", given.size, "side of the square that the robots are in")
            ->check(demos::positiveNumber()),
        app.add_option("--radius", given.radius, "radius of the discs among polygons")->check(demos::positiveNumber()),
        app.add_option("--points", given.points, "number of points of a cloud")->check(demos::countUpTo(most, 0))};
    app.add_option("--seed", given.seed, "seed; the same settings make the same scene")
        ->check(demos::countUpTo(4294967295ull))
        ->capture_default_str();
    app.add_option("--output", generator->output,
                   "file to write, - for standard output (if the kind has no meshes and no cloud)")
        ->capture_default_str();
    return [generator] { return generator->generate(); };
}
