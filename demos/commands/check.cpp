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
#include "ompl_certificates/pictures/PathFile.h"
#include "ompl_certificates/pictures/PathReader.h"
#include "ompl_certificates/planning/ProvePath.h"
#include "ompl_certificates/team/Coordinates.h"
#include "ompl_certificates/team/PathTimes.h"

#include <cstdio>
#include <memory>
#include <ompl/control/spaces/RealVectorControlSpace.h>
#include <ompl/util/Console.h>
#include <sstream>

using namespace ompl_certificates;
namespace ob = ompl::base;
namespace oc = ompl::control;

namespace
{
    struct CheckOptions
    {
        std::string scene, path;
        demos::MoveItOptions moveIt;
        bool dynamics{false};
    };

    /** The goal's threshold, which no line of the output depends on */
    constexpr double GOAL_TOLERANCE = 0.5;

    /** What rounding explains, of controls and of distances between states */
    constexpr double ROUNDING = 1e-9;

    /** The first state of a path that is outside the bounds, or beyond a robot's limits, and why; empty if none is */
    std::string describeOutOfBounds(const TeamStateSpace &team, const std::vector<ob::State *> &states)
    {
        for (std::size_t i = 0; i < states.size(); ++i)
            for (unsigned int k = 0; k < team.getRobotCount(); ++k)
            {
                const Robot &robot = team.getRobot(k);
                const ob::State *state = states[i]->as<ob::CompoundState>()->components[k];
                std::string why = ompl_certificates::describeOutOfBounds(robot, state);
                const auto *dynamic = dynamic_cast<const DynamicRobot *>(&robot);
                if (why.empty() && dynamic && !dynamic->isWithinLimits(state))
                    why = "is beyond its limits";
                if (!why.empty())
                    return "state " + std::to_string(i) + ": robot '" + robot.getName() + "' " + why;
            }
        return "";
    }

    /** The first control of a path that is beyond its limits; empty if none is */
    std::string describeOutOfLimits(const oc::PathControl &path)
    {
        const auto &si = static_cast<const oc::SpaceInformation &>(*path.getSpaceInformation());
        const ob::RealVectorBounds &bounds = si.getControlSpace()->as<oc::RealVectorControlSpace>()->getBounds();
        const std::vector<std::string> names = controlNames(*si.getStateSpace());
        for (unsigned int i = 0; i < path.getControlCount(); ++i)
        {
            const double *values = path.getControl(i)->as<oc::RealVectorControlSpace::ControlType>()->values;
            for (std::size_t k = 0; k < names.size(); ++k)
                if (!(values[k] >= bounds.low[k] - ROUNDING && values[k] <= bounds.high[k] + ROUNDING))
                {
                    std::ostringstream text;
                    text << "after state " << i << ": " << names[k] << " is " << values[k] << ", not from "
                         << bounds.low[k] << " to " << bounds.high[k];
                    return text.str();
                }
        }
        return "";
    }

    /** Where controls first lead elsewhere than to the next state of the path; empty if all lead there */
    std::string describeJump(const oc::PathControl &steps)
    {
        const auto si = std::static_pointer_cast<oc::SpaceInformation>(steps.getSpaceInformation());
        const TeamPropagator propagator(si);
        ob::ScopedState<> reached(si->getStateSpace());
        for (unsigned int i = 0; i < steps.getControlCount(); ++i)
        {
            propagator.propagate(steps.getState(i), steps.getControl(i), steps.getControlDuration(i), reached.get());
            const double distance = si->distance(reached.get(), steps.getState(i + 1));
            if (!(distance <= ROUNDING))
            {
                std::ostringstream text;
                text << "step " << i << " ends " << distance << " from the next state, so it cannot be proved";
                return text.str();
            }
        }
        return "";
    }

    /** \return whether it is empty */
    bool print(const char *what, const std::string &complaint, const char *otherwise)
    {
        std::printf("  %-13s %s\n", what, complaint.empty() ? otherwise : complaint.c_str());
        return complaint.empty();
    }

    void printEnds(const ob::ProblemDefinition &problem, const std::vector<ob::State *> &states)
    {
        const ob::SpaceInformation &si = *problem.getSpaceInformation();
        std::printf("  starts        %.6g from the scene's start\n",
                    si.distance(problem.getStartState(0), states.front()));
        double distance = 0.0;
        problem.getGoal()->isSatisfied(states.back(), &distance);
        std::printf("  ends          %.6g from the goal\n", distance);
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
        if (count == 0)
            return false;
        // Those that were not looked at are the last ones, and not proved, too.
        const std::size_t failed = proof.unproved.size() - proof.unseen;
        std::printf("  not proved    %zu of %zu %s", failed, count, motions);
        if (failed > 0)
            std::printf(", the first is number %zu", proof.unproved.front());
        if (proof.unseen > 0)
            std::printf("; %zu were not looked at before the interrupt", proof.unseen);
        else if (!proof.collision)
            std::printf("; no collision was found");
        std::puts("");
        return false;
    }

    int checkGeometric(const CheckOptions &options)
    {
        const Scene scene = demos::readScene(options.scene, options.moveIt).scene;
        demos::printNotes(scene);
        const TeamSetupPtr setup = scene.makeSetup(Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS);
        setup->getSpaceInformation()->setup();
        ompl::geometric::PathGeometric path = loadPath(options.path, setup->getSpaceInformation());
        const auto team = std::static_pointer_cast<TeamStateSpace>(setup->getStateSpace());
        const std::size_t count = path.getStateCount() - 1;
        std::printf("%s: %zu states, %.6g of time at the robots' speeds\n", scene.getName().c_str(),
                    path.getStateCount(), stateTimes(path).back());
        printEnds(*setup->getProblemDefinition(), path.getStates());
        const bool isWithin = print("bounds", describeOutOfBounds(*team, path.getStates()), "kept by all states");
        demos::catchInterrupts();
        const PathProof proof =
            provePath(path, setup->getTeamChecker(), ob::PlannerTerminationCondition(demos::interrupted));
        const bool isFree = printFreedom(scene, team, proof, count, "motions");
        return isFree && isWithin ? demos::SOLVED : demos::NOT_SOLVED;
    }

    int checkDynamic(const CheckOptions &options)
    {
        const Scene scene = loadScene(options.scene, true);
        demos::printNotes(scene);
        const TeamControlSetupPtr setup = scene.makeControlSetup(GOAL_TOLERANCE);
        setup->getSpaceInformation()->setup();
        oc::PathControl path = loadControlPath(options.path, setup->getSpaceInformation());
        oc::PathControl steps = pathSteps(path);
        const auto team = std::static_pointer_cast<TeamStateSpace>(setup->getStateSpace());
        std::printf("%s: %zu states, %zu steps, %.6g of time\n", scene.getName().c_str(), path.getStateCount(),
                    steps.getControlCount(), stateTimes(path).back());
        printEnds(*setup->getProblemDefinition(), path.getStates());
        bool isWithin = print("bounds", describeOutOfBounds(*team, steps.getStates()), "kept at the ends of all steps");
        isWithin = print("controls", describeOutOfLimits(path), "within their limits") && isWithin;
        isWithin = print("steps", describeJump(steps), "lead from state to state") && isWithin;
        demos::catchInterrupts();
        const PathProof proof =
            provePath(path, setup->getTeamChecker(), ob::PlannerTerminationCondition(demos::interrupted));
        const bool isFree = printFreedom(scene, team, proof, steps.getControlCount(), "steps");
        return isFree && isWithin ? demos::SOLVED : demos::NOT_SOLVED;
    }

    int run(const CheckOptions &options)
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        return options.dynamics ? checkDynamic(options) : checkGeometric(options);
    }
}

demos::Work demos::declareCheck(CLI::App &app)
{
    const auto options = std::make_shared<CheckOptions>();
    app.add_option("SCENE", options->scene, "The scene, as for certificates plan")->required();
    app.add_option("PATH", options->path,
                   "The path: comma-separated values, whose first line names the columns, as certificates plan --path "
                   "writes it. Columns that are no coordinates are passed over.")
        ->required();
    declare(app, options->moveIt);
    auto *dynamics =
        app.add_flag("--dynamics", options->dynamics, "The robots move by the controls of the path, not straight");
    for (const std::string &option : moveItOptionNames())
        dynamics->excludes(app.get_option(option));
    app.footer("Returns 0 if all of the path is proved free and keeps bounds and limits, 1 if not, 2 for bad input.");
    return [options] { return run(*options); };
}
