#include "Bindings.h"
#include "Checker.h"
#include "Plan.h"
#include "Progress.h"

#include <ompl_certificates/planning/Planners.h>
#include <ompl_certificates/robots/RigidRobot.h>
#include <ompl_certificates/team/TeamObjective.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <ompl/base/goals/GoalState.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <ompl/util/RandomNumbers.h>
#include <optional>
#include <pybind11/stl.h>
#include <set>
#include <sstream>

namespace ompl_certificates_python
{
    namespace ob = ompl::base;
    using namespace ompl_certificates;

    namespace
    {
        struct Options
        {
            std::string planner, objective;
            double seconds;
            std::uint64_t iterations;
            std::uint32_t seed;
            py::object callback;
            bool first, simplify;
            std::map<std::string, py::object> parameters;
        };

        /** OMPL prints only what has this level or a higher one while this lives. The level is one for the process, and
            plans of several threads overlap: the highest level counts, and the last one restores what was before. */
        class Quiet
        {
        public:
            explicit Quiet(ompl::msg::LogLevel level) : level_(level)
            {
                const std::lock_guard<std::mutex> lock(mutex());
                if (levels().empty())
                    before() = ompl::msg::getLogLevel();
                levels().insert(level_);
                setLevel();
            }
            Quiet(const Quiet &) = delete;
            Quiet &operator=(const Quiet &) = delete;
            ~Quiet()
            {
                const std::lock_guard<std::mutex> lock(mutex());
                levels().erase(levels().find(level_));
                setLevel();
            }

        private:
            static void setLevel()
            {
                ompl::msg::setLogLevel(levels().empty() ? before() : *levels().rbegin());
            }

            static std::mutex &mutex()
            {
                static std::mutex theMutex;
                return theMutex;
            }

            /** All levels that are asked for now */
            static std::multiset<ompl::msg::LogLevel> &levels()
            {
                static std::multiset<ompl::msg::LogLevel> theLevels;
                return theLevels;
            }

            /** The level that was there before the first */
            static ompl::msg::LogLevel &before()
            {
                static ompl::msg::LogLevel theLevel{ompl::msg::LOG_INFO};
                return theLevel;
            }

            const ompl::msg::LogLevel level_;
        };

        void seedRandomNumbers(std::uint32_t seed)
        {
            // OMPL warns of a second seed, which is meant for programs that plan once.
            const Quiet quiet(ompl::msg::LOG_NONE);
            ompl::RNG::setSeed(seed);
        }

        ob::PlannerPtr plannerOf(const Options &options, const TeamSetup &setup)
        {
            std::string name = options.planner;
            if (name.empty())
                name = setup.getTeam().getRobotCount() > 1 ? "DRRTstar" : "RRTConnect";
            ob::PlannerPtr planner = makePlanner(name, setup.getSpaceInformation());
            const py::object numpyBool = py::module_::import("numpy").attr("bool_");
            for (const auto &[key, value] : options.parameters)
            {
                const bool isBool = py::isinstance<py::bool_>(value) || py::isinstance(value, numpyBool);
                setParameter(*planner, key, isBool ? (py::bool_(value) ? "1" : "0") : std::string(py::str(value)));
            }
            return planner;
        }

        void setProblem(TeamSetup &setup, const Checker &checker, const Options &options, const py::object &start,
                        const py::object &goal)
        {
            const auto read = [&checker](const py::object &object, const char *what)
            { return checker.toState(toDoubles(object, what), what); };
            ob::ScopedState<> begin(setup.getStateSpace()), end(setup.getStateSpace());
            begin = start.is_none() ? setup.getProblemDefinition()->getStartState(0) : read(start, "start").get();
            end = goal.is_none() ? setup.getGoal()->as<ob::GoalState>()->getState() : read(goal, "goal").get();
            for (const auto &[key, state] :
                 {std::pair<std::string, const ob::State *>{"start", begin.get()}, {"goal", end.get()}})
            {
                for (unsigned int i = 0; i < setup.getTeam().getRobotCount(); ++i)
                {
                    const Robot &robot = setup.getTeam().getRobot(i);
                    if (!robot.getStateSpace()->satisfiesBounds(state->as<ob::CompoundState>()->components[i]))
                        throw ompl::Exception(checker.getSceneName(),
                                              key + ": robot '" + robot.getName() + "' is outside the bounds");
                }
                const std::string collision = checker.describeCollision(state);
                if (!collision.empty())
                    throw ompl::Exception(checker.getSceneName(), key + ": " + collision);
            }
            setup.setStartAndGoalStates(begin, end);
            setup.setOptimizationObjective(options.objective == "length" && !options.first
                                               ? nullptr
                                               : makeObjective(options.objective, setup.getSpaceInformation(), end));
            // Any solution is good enough.
            if (options.first)
                setup.getOptimizationObjective()->setCostThreshold(setup.getOptimizationObjective()->infiniteCost());
        }

        double costOf(TeamSetup &setup, const Options &options)
        {
            ob::ScopedState<> goal(setup.getStateSpace());
            goal = setup.getGoal()->as<ob::GoalState>()->getState();
            return setup.getSolutionPath()
                .cost(makeObjective(options.objective, setup.getSpaceInformation(), goal))
                .value();
        }

        /** Plan, and fill in the report. */
        void solve(TeamSetup &setup, const Options &options, PlanReport &report)
        {
            Progress progress(options.seconds, options.iterations, options.callback, *setup.getPlanner());
            progress.run(
                [&]
                {
                    setup.setup();
                    setup.getProblemDefinition()->setIntermediateSolutionCallback(
                        [&](const ob::Planner *, const std::vector<const ob::State *> &, ob::Cost)
                        {
                            if (report.firstSolutionSeconds < 0.0)
                                report.firstSolutionSeconds = progress.getSeconds();
                        });
                    const ob::PlannerStatus status = setup.solve(progress.condition());
                    setup.getProblemDefinition()->setIntermediateSolutionCallback(nullptr);
                    report.solved = status == ob::PlannerStatus::EXACT_SOLUTION && setup.haveExactSolutionPath();
                    if (!report.solved)
                        report.reason = reasonOf(status, *setup.getPlanner());
                });
            report.approximate = !report.solved && setup.haveSolutionPath();
            report.totalSeconds = setup.getLastPlanComputationTime();
            report.checkingSeconds = setup.getStatistics().getCheckingSeconds();
            report.checks = setup.getStatistics().getCounts();
            report.iterations = progress.getEvaluations();
            report.certificates = setup.getTeamChecker()->getCertificateCount();
            if (report.solved)
                report.cost = costOf(setup, options);
        }

        /** Shorten the solution, for as long as it was planned for at most. */
        void simplify(TeamSetup &setup, const Options &options, PlanReport &report)
        {
            Progress progress(options.seconds, 0, py::none(), *setup.getPlanner());
            progress.run([&] { setup.simplifySolution(progress.condition()); });
            report.simplifiedCost = costOf(setup, options);
            report.simplifyingSeconds = setup.getLastSimplificationTime();
        }

        /** Keep what a page shows of all this. */
        void keepAll(Plan &plan, const std::shared_ptr<Checker> &checker)
        {
            const TeamSetup &setup = checker->getSetup();
            plan.checker = checker;
            plan.planner = setup.getPlanner();
            plan.scene =
                std::make_shared<const Scene>(checker->getScene(setup.getGoal()->as<ob::GoalState>()->getState()));
            plan.certificates = setup.getTeamChecker()->getCertificates();
        }

        Plan planWith(const std::shared_ptr<Checker> &owner, const Options &options, const py::object &start,
                      const py::object &goal)
        {
            Checker &checker = *owner;
            const auto planning = checker.beginPlanning();
            if (!(options.seconds > 0.0))
                throw ompl::Exception("time", "must be positive, not " + std::to_string(options.seconds));
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
            plan.coordinates = coordinateNames(*setup.getStateSpace());
            plan.path = Doubles(std::vector<py::ssize_t>{0, static_cast<py::ssize_t>(checker.getCoordinateCount())});
            plan.times = Doubles(0);
            solve(setup, options, plan.report);
            // An approximate path would be taken for a solution.
            if (plan.report.solved && options.simplify)
                simplify(setup, options, plan.report);
            if (plan.report.solved)
                setSolution(plan, setup.getSolutionPath());
            keepAll(plan, owner);
            return plan;
        }

        /** The parameters of a planner, with their values and the ranges that OMPL suggests, in a team of two discs */
        py::dict parametersOf(const std::string &name)
        {
            const Quiet quiet(ompl::msg::LOG_ERROR);
            const ob::RealVectorBounds bounds = toBounds({0.0, 0.0}, {1.0, 1.0});
            Scene scene(name, name, bounds);
            for (const char *robot : {"first", "second"})
                scene.addMember({RigidRobot::inR2(robot, Body::disc(0.1), bounds), {0.0, 0.0}, {1.0, 1.0}});
            py::dict parameters;
            const ob::PlannerPtr planner = makePlanner(name, scene.makeSetup()->getSpaceInformation());
            for (const auto &[key, parameter] : planner->params().getParams())
                parameters[py::str(key)] = py::make_tuple(parameter->getValue(), parameter->getRangeSuggestion());
            return parameters;
        }
    }

    void bindPlanning(py::module_ &module)
    {
        bindPlan(module);
        module.def("planner_names", &plannerNames, "The names of all planners: OMPL's classes, and DRRTstar");
        module.def(
            "planner_parameters", &parametersOf, py::arg("planner"),
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
                                {planner, objective, time, iterations, seed, callback, first, simplified, parameters},
                                start, goal);
            },
            py::arg("checker"), py::arg("planner"), py::arg("time"), py::arg("iterations"), py::arg("seed"),
            py::arg("callback"), py::arg("objective"), py::arg("first"), py::arg("simplify"), py::arg("parameters"),
            py::arg("start"), py::arg("goal"));
    }
}
