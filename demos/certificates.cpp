// All programs of this library in one. Each is a command:
//
//     certificates plan scene.yaml --time 2 --picture plan.svg
//     certificates --help
//
// Most also have a name of their own, which is a link to this program. plan_team is certificates plan.

#include "commands/Commands.h"
#include "common/CommandLine.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace
{
    struct Command
    {
        std::string name;
        /** The name of the link; empty if there is none */
        std::string ownName;
        std::string about;
        demos::Work (*declare)(CLI::App &app);
    };

    const std::vector<Command> &commands()
    {
        static const std::vector<Command> all{
            {"plan", "plan_team", "Plan for the team of a scene", demos::declarePlan},
            {"check", "", "Check a path that was written before, or by another program", demos::declareCheck},
            {"benchmark", "benchmark_team", "Benchmark planners for the teams of scenes, with each method",
             demos::declareBenchmark},
            {"generate", "generate_scene", "Make a scene", demos::declareGenerate},
            {"experiment", "certificate_experiment", "Run a grid of planners, methods and scenes",
             demos::declareExperiment},
            {"compare", "compare_with_ompl",
             "Plan with OMPL and FCL as they are, and with this library, and compare the two", demos::declareCompare},
            {"moving-world", "moving_world", "Let drones plan anew, frame by frame, among people who walk about",
             demos::declareMovingWorld}};
        return all;
    }

    int runAlone(const Command &command, int argc, char **argv)
    {
        CLI::App app(command.about, command.ownName);
        return demos::runProgram(app, argc, argv, command.declare(app));
    }

    int runCommand(int argc, char **argv)
    {
        CLI::App app("Plan for teams of robots by safety certificates", "certificates");
        app.require_subcommand(1);
        app.get_formatter()->label("SUBCOMMAND", "COMMAND");
        app.footer("certificates COMMAND --help tells of a command.");
        std::map<const CLI::App *, demos::Work> works;
        for (const Command &command : commands())
        {
            CLI::App *declared = app.add_subcommand(command.name, command.about)->group("Commands");
            works[declared] = command.declare(*declared);
        }
        return demos::runProgram(app, argc, argv, [&] { return works.at(app.get_subcommands().front())(); });
    }
}

int main(int argc, char **argv)
{
    const std::string called = argc > 0 ? std::filesystem::path(argv[0]).filename().string() : "";
    for (const Command &command : commands())
        if (!command.ownName.empty() && called == command.ownName)
            return runAlone(command, argc, argv);
    return runCommand(argc, argv);
}
