#include "Bindings.h"
#include "Checker.h"
#include "Gil.h"
#include "Goals.h"
#include "Mappings.h"
#include "Plan.h"
#include "PlanOptions.h"
#include "Progress.h"
#include "Quiet.h"

#include <ompl_certificates/control/DynamicRobot.h>
#include <ompl_certificates/files/Suggestion.h>
#include <ompl_certificates/planning/Planners.h>
#include <ompl_certificates/planning/TeamGoalRegion.h>
#include <ompl_certificates/robots/RigidRobot.h>
#include <ompl_certificates/team/Coordinates.h>
#include <ompl_certificates/team/TeamObjective.h>

#include <ompl/base/goals/GoalState.h>
#include <ompl/util/Exception.h>
#include <pybind11/stl.h>

namespace ompl_certificates_python
{
    namespace ob = ompl::base;
    using namespace ompl_certificates;

    namespace
    {
        struct Options : PlanOptions
        {
            std::string objective;
            bool first, simplify;
        };

        ob::PlannerPtr plannerOf(const Options &options, const TeamSetup &setup)
        {
            std::string name = options.planner;
            if (name.empty())
                name = setup.getTeam().getRobotCount() > 1 ? "DRRTstar" : "RRTConnect";
            ob::PlannerPtr planner = makePlanner(name, setup.getSpaceInformation());
            setParameters(*planner, options);
            return planner;
        }

        /** The goal of a plan: a state, or one of many */
        ob::ScopedState<> goalOf(const TeamSetup &setup)
        {
            ob::ScopedState<> goal(setup.getStateSpace());
            if (const auto *region = dynamic_cast<const TeamGoalRegion *>(setup.getGoal().get()))
                goal = region->getState().get();
            else
                goal = setup.getGoal()->as<ob::GoalState>()->getState();
            return goal;
        }

        /** What the goal of each robot is, as \e goal tells in a dict, or for the only robot; none where it does not */
        std::vector<py::object> partsOf(const TeamSetup &setup, const py::object &goal)
        {
            std::vector<py::object> parts(setup.getTeam().getRobotCount(), py::none());
            if (isGoal(goal))
            {
                if (parts.size() > 1)
                    throw ompl::Exception("goal", "of several robots must be a dict from their names to their goals");
                parts.front() = goal;
            }
            if (!isMapping(goal))
                return parts;
            std::vector<std::string> names;
            for (unsigned int robot = 0; robot < parts.size(); ++robot)
                names.push_back(setup.getTeam().getRobot(robot).getName());
            for (const auto &[key, value] : dictOf(goal))
            {
                const std::string name = py::str(key);
                const auto robot = std::find(names.begin(), names.end(), name);
                if (robot == names.end())
                    throw ompl::Exception("goal", "there is no robot '" + name + "'" + didYouMean(name, names));
                if (value.is_none())
                    throw ompl::Exception("goal of robot '" + name + "'",
                                          "must not be None: leave out robots that keep their goals");
                parts[static_cast<std::size_t>(robot - names.begin())] = py::reinterpret_borrow<py::object>(value);
            }
            return parts;
        }

        /** \e state, but with the coordinates of those robots to which \e parts gives some */
        ob::ScopedState<> withParts(const Checker &checker, const ob::ScopedState<> &state,
                                    const std::vector<py::object> &parts)
        {
            const auto &members = checker.getOriginalScene().getMembers();
            std::vector<double> all = state.reals();
            auto begin = all.begin();
            for (std::size_t i = 0; i < parts.size(); ++i)
            {
                const std::size_t size = members[i].start.size();
                if (!parts[i].is_none() && !isGoal(parts[i]))
                {
                    const std::string what = "goal of robot '" + members[i].robot->getName() + "'";
                    const Doubles own = toDoubles(parts[i], what);
                    requireOneState(own, size, what);
                    std::copy_n(own.data(), size, begin);
                }
                begin += static_cast<std::ptrdiff_t>(size);
            }
            return checker.toState(Doubles(static_cast<py::ssize_t>(all.size()), all.data()), "goal");
        }

        /** A scene of the robots alone, which go from \e start to \e goal. Goals not given are the last ones. */
        Scene problemOf(const TeamSetup &setup, const Checker &checker, const ob::State *start, const py::object &goal)
        {
            const std::vector<py::object> parts = partsOf(setup, goal);
            const bool isState = !goal.is_none() && !isGoal(goal) && !isMapping(goal);
            const ob::ScopedState<> end =
                isState ? checker.toState(toDoubles(goal, "goal"), "goal") : withParts(checker, goalOf(setup), parts);
            const auto *region = dynamic_cast<const TeamGoalRegion *>(setup.getGoal().get());
            const Scene &original = checker.getOriginalScene();
            Scene problem(original.getName(), original.getSource(), original.getBounds());
            for (unsigned int i = 0; i < parts.size(); ++i)
            {
                Scene::Member member = original.getMembers()[i];
                const ob::StateSpacePtr &space = member.robot->getStateSpace();
                space->copyToReals(member.start, start->as<ob::CompoundState>()->components[i]);
                space->copyToReals(member.goal, end.get()->as<ob::CompoundState>()->components[i]);
                member.region = nullptr;
                if (isGoal(parts[i]))
                {
                    member.region = toRobotGoal(member.robot, parts[i]);
                    member.goal.clear();
                }
                else if (!isState && parts[i].is_none() && region)
                    member.region = region->getGoals()[i];
                problem.addMember(member);
            }
            return problem;
        }

        /** Require that the team can be in \e state; \e what begins the message if not. */
        void requireFree(const TeamSetup &setup, const Checker &checker, const std::string &what,
                         const ob::State *state)
        {
            for (unsigned int i = 0; i < setup.getTeam().getRobotCount(); ++i)
            {
                const Robot &robot = setup.getTeam().getRobot(i);
                const std::string why = describeOutOfBounds(robot, state->as<ob::CompoundState>()->components[i]);
                if (!why.empty())
                    throw ompl::Exception(checker.getSceneName(), what + " robot '" + robot.getName() + "' " + why);
            }
            const std::string collision = [&]
            {
                const GilRelease release;
                // To describe one takes FCL's copies of all meshes, which may take a second.
                return setup.getTeamChecker()->isValid(state) ? std::string() : checker.describeCollision(state);
            }();
            if (!collision.empty())
                throw ompl::Exception(checker.getSceneName(), what + " " + collision);
        }

        void setProblem(TeamSetup &setup, const Checker &checker, const Options &options, const py::object &start,
                        const py::object &goal)
        {
            ob::ScopedState<> begin(setup.getStateSpace());
            begin = start.is_none() ? setup.getProblemDefinition()->getStartState(0)
                                    : checker.toState(toDoubles(start, "start"), "start").get();
            const ob::GoalPtr lastGoal = setup.getGoal();
            ob::ScopedState<> lastStart(setup.getStateSpace());
            lastStart = setup.getProblemDefinition()->getStartState(0);
            Scene problem = problemOf(setup, checker, begin.get(), goal);
            if (options.objective == "arrival" && problem.hasRegions())
                throw ompl::Exception("objective", "arrival needs one state as the goal of each robot");
            requireFree(setup, checker, "start:", begin.get());
            // What was chosen for the last plan still serves, if the world has not changed there.
            {
                const bool isLast = start.is_none() && goal.is_none();
                const GilRelease release;
                if (isLast && setup.getStateValidityChecker()->isValid(goalOf(setup).get()))
                    problem.setProblem(setup);
                else
                    problem.chooseGoals(setup);
            }
            const ob::ScopedState<> end = goalOf(setup);
            ob::OptimizationObjectivePtr objective;
            try
            {
                requireFree(setup, checker,
                            problem.hasRegions() ? "goal, where no free state was found:" : "goal:", end.get());
                if (options.objective != "length" || options.first)
                    objective = makeObjective(options.objective, setup.getSpaceInformation(), end);
            }
            catch (const ompl::Exception &)
            {
                // A problem that is refused is not remembered.
                setup.setStartState(lastStart);
                setup.setGoal(lastGoal);
                throw;
            }
            // Any solution is good enough.
            if (options.first)
                objective->setCostThreshold(objective->infiniteCost());
            setup.setOptimizationObjective(objective);
        }

        double costOf(TeamSetup &setup, const Options &options)
        {
            return setup.getSolutionPath()
                .cost(makeObjective(options.objective, setup.getSpaceInformation(), goalOf(setup)))
                .value();
        }

        /** Plan, and fill in the report and for how many seconds the callback was called; returns what Python threw
            meanwhile. */
        std::exception_ptr solve(TeamSetup &setup, const Options &options, PlanReport &report, double &seconds)
        {
            Progress progress(options.seconds, options.iterations, options.callback, *setup.getPlanner());
            const std::exception_ptr interrupt = progress.run(
                [&]
                {
                    setup.setup();
                    const double begin = progress.getSeconds();
                    setup.getProblemDefinition()->setIntermediateSolutionCallback(
                        [&](const ob::Planner *, const std::vector<const ob::State *> &, ob::Cost)
                        {
                            if (report.firstSolutionSeconds < 0.0)
                                report.firstSolutionSeconds = progress.getSeconds() - begin;
                        });
                    const ob::PlannerStatus status = setup.solve(progress.condition());
                    setup.getProblemDefinition()->setIntermediateSolutionCallback(nullptr);
                    report.solved = status == ob::PlannerStatus::EXACT_SOLUTION && setup.haveExactSolutionPath();
                    if (!report.solved)
                        report.reason = reasonOf(status, *setup.getPlanner());
                });
            seconds = progress.getSeconds();
            setCounts(report, setup, progress.getEvaluations());
            // A planner that ends before its time, and told of no solution until then, is taken to end with its first one.
            if (report.solved && report.firstSolutionSeconds < 0.0 && !progress.wasOver())
                report.firstSolutionSeconds = report.totalSeconds;
            if (report.solved)
                report.cost = costOf(setup, options);
            return interrupt;
        }

        /** Shorten the solution, for as long as it was planned for at most; returns what Python threw meanwhile. */
        std::exception_ptr simplify(TeamSetup &setup, const Options &options, PlanReport &report, double seconds)
        {
            Progress progress(options.seconds, 0, options.callback, *setup.getPlanner(), seconds, report.cost);
            const std::exception_ptr interrupt = progress.run([&] { setup.simplifySolution(progress.condition()); });
            report.simplifiedCost = costOf(setup, options);
            report.simplifyingSeconds = setup.getLastSimplificationTime();
            return interrupt;
        }

        /** Keep what a page shows of all this. */
        void keepAll(Plan &plan, const std::shared_ptr<Checker> &checker)
        {
            const TeamSetup &setup = checker->getSetup();
            plan.checker = checker;
            plan.planner = setup.getPlanner();
            // It shows the goal that the path ends at.
            const ob::ScopedState<> goal = goalOf(setup);
            // Another thread may be changing the obstacles.
            const GilRelease release;
            plan.scene = std::make_shared<const Scene>(
                checker->getScene(setup.getProblemDefinition()->getStartState(0),
                                  plan.report.solved ? setup.getSolutionPath().getStates().back() : goal.get()));
            plan.certificates = setup.getTeamChecker()->getCertificates();
        }

        Plan planWith(const std::shared_ptr<Checker> &owner, const Options &options, const py::object &start,
                      const py::object &goal)
        {
            Checker &checker = *owner;
            const auto planning = checker.beginPlanning();
            requirePositive(options.seconds, "time");
            requireCallable(options.callback);
            for (const RobotPtr &robot : checker.getSetup().getTeam().getRobots())
                if (dynamic_cast<const DynamicRobot *>(robot.get()))
                    throw ompl::Exception(checker.getSceneName(), "robot '" + robot->getName() +
                                                                      "' moves by controls: plan_controls() plans for "
                                                                      "such robots");
            const Quiet quiet(ompl::msg::LOG_ERROR);
            seedRandomNumbers(options.seed);
            TeamSetup &setup = checker.getSetup();
            // Planners such as KPIECE have cells whose sizes OMPL infers from random states.
            setup.getSpaceInformation()->setup();
            // The last planner is dropped as it is: OMPL's LazyLBTRRT frees memory twice if it is cleared before.
            setup.setPlanner(nullptr);
            setup.getProblemDefinition()->clearSolutionPaths();
            setup.setPlanner(plannerOf(options, setup));
            setProblem(setup, checker, options, start, goal);
            setup.getStatistics().reset();

            Plan plan;
            plan.report.scene = checker.getSceneName();
            plan.report.planner = setup.getPlanner()->getName();
            plan.report.method = nameOf(setup.getTeamChecker()->getMethod());
            plan.report.motion = checker.getMotion();
            plan.report.objective = options.objective;
            plan.report.seed = options.seed;
            setNames(plan, *setup.getStateSpace());
            double seconds = 0.0;
            std::exception_ptr interrupt = solve(setup, options, plan.report, seconds);
            // An approximate path would be taken for a solution.
            if (plan.report.solved && options.simplify && !interrupt)
                interrupt = simplify(setup, options, plan.report, seconds);
            if (plan.report.solved)
                setSolution(plan, setup.getSolutionPath());
            keepAll(plan, owner);
            rethrowWith(interrupt, [&plan] { return py::cast(std::move(plan)); });
            return plan;
        }

        /** The parameters of a planner, in a team of two discs */
        py::dict parametersOfPlanner(const std::string &name)
        {
            const Quiet quiet(ompl::msg::LOG_ERROR);
            const ob::RealVectorBounds bounds = toBounds({0.0, 0.0}, {1.0, 1.0});
            Scene scene(name, name, bounds);
            for (const char *robot : {"first", "second"})
                scene.addMember({RigidRobot::inR2(robot, Body::disc(0.1), bounds), {0.0, 0.0}, {1.0, 1.0}});
            return parametersOf(*makePlanner(name, scene.makeSetup()->getSpaceInformation()));
        }
    }

    void bindPlanning(py::module_ &module)
    {
        bindPlan(module);
        module.def("planner_names", &plannerNames, "The names of all planners: OMPL's classes, and DRRTstar");
        module.def(
            "planner_parameters", &parametersOfPlanner, py::arg("planner"),
            "The parameters of a planner: a dict from their names to their values and the ranges that OMPL suggests, "
            "as texts such as 0.:1.:10000., which is from 0 in steps of 1 to 10000");
        module.def(
            "_plan",
            [](const std::shared_ptr<Checker> &checker, const std::string &planner, double time,
               std::uint64_t iterations, std::uint32_t seed, const py::object &callback, const std::string &objective,
               bool first, bool simplified, const std::map<std::string, py::object> &parameters,
               const py::object &start, const py::object &goal)
            {
                return planWith(checker,
                                {{planner, time, iterations, seed, callback, parameters}, objective, first, simplified},
                                start, goal);
            },
            py::arg("checker"), py::arg("planner"), py::arg("time"), py::arg("iterations"), py::arg("seed"),
            py::arg("callback"), py::arg("objective"), py::arg("first"), py::arg("simplify"), py::arg("parameters"),
            py::arg("start"), py::arg("goal"));
    }
}
