// Checks a path that was written before, or by another program: whether it is free between its states, too.
//
//     certificates plan scene.yaml --path plan.csv
//     certificates check scene.yaml plan.csv

#include "commands/Commands.h"
#include "common/CommandLine.h"
#include "common/Interrupt.h"
#include "common/MoveItOptions.h"
#include "common/PlanTeamSummary.h"

#include "ompl_certificates/control/PathSteps.h"
#include "ompl_certificates/control/ProvePath.h"
#include "ompl_certificates/control/TeamControlSetup.h"
#include "ompl_certificates/pictures/PathReader.h"
#include "ompl_certificates/planning/ProvePath.h"
#include "ompl_certificates/team/Coordinates.h"
#include "ompl_certificates/team/PathTimes.h"

#include <cstdio>
#include <memory>
#include <ompl/util/Console.h>

using namespace ompl_certificates;
namespace ob = ompl::base;

namespace
{
    struct CheckOptions
    {
        std::string scene, path;
        demos::MoveItOptions moveIt;
        double goalTolerance{0.5};
        bool dynamics{false};
    };

    /** The first state of a path that is outside the bounds, and why; empty if none is */
    std::string describeOutOfBounds(const TeamStateSpace &team, const std::vector<ob::State *> &states)
    {
        for (std::size_t i = 0; i < states.size(); ++i)
            for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
            {
                const std::string why = ompl_certificates::describeOutOfBounds(
                    team.getRobot(robot), states[i]->as<ob::CompoundState>()->components[robot]);
                if (!why.empty())
                    return "state " + std::to_string(i) + ": robot '" + team.getRobot(robot).getName() + "' " + why;
            }
        return "";
    }

    void printEnds(const ob::ProblemDefinition &problem, const std::vector<ob::State *> &states)
    {
        const ob::SpaceInformation &si = *problem.getSpaceInformation();
        std::printf("  starts        %.6g from the scene's start\n",
                    si.distance(problem.getStartState(0), states.front()));
        double distance = 0.0;
        const bool isGoal = problem.getGoal()->isSatisfied(states.back(), &distance);
        std::printf("  ends          %s, %.6g from it\n", isGoal ? "at the goal" : "not at the goal", distance);
    }

    /** \return whether the path is known to be free */
    bool printFreedom(const Scene &scene, const TeamStateSpacePtr &team, const PathProof &proof, std::size_t count,
                      const char *motions)
    {
        if (proof.isProved())
        {
            std::puts("  free          throughout");
            return true;
        }
        if (proof.collision)
            std::printf("  not free      %s\n", scene.describeCollision(team, proof.collision->get()).c_str());
        else
            std::puts("  not proved    no collision was found");
        std::printf("  not proved    %zu of %zu %s, the first is number %zu", proof.unproved.size(), count, motions,
                    proof.unproved.front());
        if (proof.unseen > 0)
            std::printf("; %zu were not looked at before the interrupt", proof.unseen);
        std::puts("");
        return false;
    }

    /** What all paths have in common
        \param count of its motions, or of its steps, which \e motions calls them */
    template <typename Setup, typename Path>
    int check(const Scene &scene, Setup &setup, Path &path, std::size_t count, const char *motions, double time)
    {
        const auto team = std::static_pointer_cast<TeamStateSpace>(setup.getStateSpace());
        const auto &states = path.getStates();
        std::printf("%s: %zu states, %zu %s, %.6g of time\n", scene.getName().c_str(), states.size(), count, motions,
                    time);
        printEnds(*setup.getProblemDefinition(), states);
        const std::string outside = describeOutOfBounds(*team, states);
        std::printf("  bounds        %s\n", outside.empty() ? "kept" : outside.c_str());
        std::fflush(stdout);
        demos::catchInterrupts();
        const PathProof proof =
            provePath(path, setup.getTeamChecker(), ob::PlannerTerminationCondition(demos::interrupted));
        const bool isFree = printFreedom(scene, team, proof, count, motions);
        return isFree && outside.empty() ? demos::SOLVED : demos::NOT_SOLVED;
    }

    int run(const CheckOptions &options)
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        if (options.dynamics)
        {
            const Scene scene = loadScene(options.scene, true);
            demos::printNotes(scene);
            const TeamControlSetupPtr setup = scene.makeControlSetup(options.goalTolerance);
            setup->getSpaceInformation()->setup();
            ompl::control::PathControl path = loadControlPath(options.path, setup->getSpaceInformation());
            return check(scene, *setup, path, pathSteps(path).getControlCount(), "steps", stateTimes(path).back());
        }
        const Scene scene = demos::readScene(options.scene, options.moveIt).scene;
        demos::printNotes(scene);
        const TeamSetupPtr setup = scene.makeSetup(Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS);
        setup->getSpaceInformation()->setup();
        ompl::geometric::PathGeometric path = loadPath(options.path, setup->getSpaceInformation());
        return check(scene, *setup, path, path.getStateCount() - 1, "motions", stateTimes(path).back());
    }
}

demos::Work demos::declareCheck(CLI::App &app)
{
    const auto options = std::make_shared<CheckOptions>();
    app.add_option("scene", options->scene, "The scene, as for certificates plan")->required();
    app.add_option("path", options->path,
                   "The path: comma-separated values, whose first line names the columns, as certificates plan --path "
                   "writes it. Columns that are no coordinates are passed over.")
        ->required();
    declare(app, options->moveIt);
    auto *dynamics =
        app.add_flag("--dynamics", options->dynamics, "The robots move by the controls of the path, not straight");
    for (const std::string &option : moveItOptionNames())
        dynamics->excludes(app.get_option(option));
    app.add_option("--goal-tolerance", options->goalTolerance,
                   "With --dynamics: how far from the goal the path may end, in the team's distance")
        ->check(positiveNumber())
        ->capture_default_str()
        ->needs(dynamics);
    app.footer("Returns 0 if all of the path is proved free and in the bounds, 1 if not, 2 for bad input.");
    return [options] { return run(*options); };
}
