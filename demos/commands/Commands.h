#ifndef OMPL_CERTIFICATES_DEMOS_COMMANDS_COMMANDS_
#define OMPL_CERTIFICATES_DEMOS_COMMANDS_COMMANDS_

#include <CLI/CLI.hpp>
#include <functional>

namespace demos
{
    /** \brief The commands of `certificates`. Each function declares the arguments of its command to \e app. It returns
        what the command does once they are parsed, and that returns the program's exit code; see ExitCode. */
    using Work = std::function<int()>;

    Work declareBenchmark(CLI::App &app);
    Work declareCheck(CLI::App &app);
    Work declareCompare(CLI::App &app);
    Work declareExperiment(CLI::App &app);
    Work declareGenerate(CLI::App &app);
    Work declareMovingWorld(CLI::App &app);
    Work declarePlan(CLI::App &app);
}

#endif
