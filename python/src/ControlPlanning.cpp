#include "Bindings.h"
#include "Checker.h"
#include "ControlPlan.h"
#include "Gil.h"
#include "Goals.h"
#include "Mappings.h"
#include "PlanOptions.h"
#include "Progress.h"
#include "Quiet.h"

#include <ompl_certificates/control/ControlPlanners.h>
#include <ompl_certificates/control/Integrator.h>
#include <ompl_certificates/neighbors/PlannerNeighbors.h>
#include <ompl_certificates/robots/RigidRobot.h>
#include <ompl_certificates/team/PathTimes.h>
#include <ompl_certificates/team/Rotations.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ompl/util/Exception.h>
#include <pybind11/stl.h>

namespace ompl_certificates_python
{
    namespace ob = ompl::base;
    using namespace ompl_certificates;

    namespace
    {
        struct ControlOptions : PlanOptions
        {
            std::string method, motion, nearest;
            double goalTolerance, step;
            unsigned int minSteps, maxSteps;
            bool simplify;
        };

        /** Refuse what no plan can be made of */
        void requireSense(const Scene &scene, const ControlOptions &options)
        {
            requirePositive(options.seconds, "time");
            requirePositive(options.goalTolerance, "goal_tolerance", true);
            requirePositive(options.step, "step", true);
            // OMPL takes a shorter one for none, and chooses another.
            if (options.step < std::numeric_limits<double>::epsilon())
                throw ompl::Exception("step", "must be at least 2.3e-16, not " +
                                                  py::str(py::float_(options.step)).cast<std::string>());
            if (modeOf(options.motion) == CertificateMotionValidator::CONTINUOUS &&
                !makesCertificates(methodOf(options.method)))
                throw ompl::Exception("motion", "continuous needs certificates, which method " + options.method +
                                                    " does not make");
            std::string without;
            for (const Scene::Member &member : scene.getMembers())
                if (!dynamic_cast<const DynamicRobot *>(member.robot.get()))
                    without += (without.empty() ? "'" : ", '") + member.robot->getName() + "'";
            if (!without.empty())
                throw ompl::Exception(scene.getName(),
                                      "these robots have no controls: " + without +
                                          ". Robot.unicycle() and the like do, and load_scene(file, dynamics=True) "
                                          "reads those of db-CBS");
        }

        /** The scene with another start and goal, unless these are None */
        Scene withEnds(const Scene &scene, const py::object &start, const py::object &goal)
        {
            const Rotations rotations(*scene.makeTeam());
            const auto read = [&](const py::object &object, const char *what)
            {
                if (object.is_none())
                    return std::vector<double>();
                if (isGoal(object))
                    throw ompl::Exception(
                        what, "must be one state: plans by controls take no Zone, no LinkPose and no AnyOf");
                if (isMapping(object))
                    throw ompl::Exception(what, "must be one state of the team: plans by controls take no dict");
                const Doubles values = toDoubles(object, what);
                requireOneState(values, rotations.count, what);
                std::vector<double> numbers(values.data(), values.data() + values.size());
                if (!std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); }))
                    throw ompl::Exception(what, "all numbers must be finite");
                rotations.wrapAngles(numbers);
                return numbers;
            };
            const std::vector<double> first = read(start, "start"), last = read(goal, "goal");
            Scene result = scene.withFirstRobots(0);
            std::size_t begin = 0;
            for (Scene::Member member : scene.getMembers())
            {
                const std::size_t size = member.start.size();
                if (!first.empty())
                    std::copy_n(first.begin() + static_cast<std::ptrdiff_t>(begin), size, member.start.begin());
                if (!last.empty())
                    std::copy_n(last.begin() + static_cast<std::ptrdiff_t>(begin), size, member.goal.begin());
                begin += size;
                result.addMember(member);
            }
            return result;
        }

        /** A setup with what \e checker knows, for the ends of \e scene, which has its obstacles */
        TeamControlSetupPtr makeSetupWith(const Checker &checker, const Scene &scene, const ControlOptions &options)
        {
            auto setup =
                std::make_shared<TeamControlSetup>(checker.getSetup().getTeamChecker(), modeOf(options.motion));
            const auto team = std::static_pointer_cast<TeamStateSpace>(setup->getStateSpace());
            const ob::ScopedState<> start = scene.makeStart(team), goal = scene.makeGoal(team);
            setup->setStartAndGoalStates(start, goal, options.goalTolerance);
            const ob::SpaceInformation &si = *setup->getSpaceInformation();
            const auto isFree = [&si](const ob::State *state)
            { return si.satisfiesBounds(state) && si.isValid(state); };
            // It says what is wrong, but takes FCL's copies of all meshes.
            if (!isFree(start.get()) || !isFree(goal.get()))
                scene.validate();
            return setup;
        }

        TeamControlSetupPtr makeSetup(const Checker *checker, const Scene &scene, const ControlOptions &options)
        {
            if (!checker)
                scene.validate();
            TeamControlSetupPtr setup =
                checker
                    ? makeSetupWith(*checker, scene, options)
                    : scene.makeControlSetup(options.goalTolerance, methodOf(options.method), modeOf(options.motion));
            setup->getSpaceInformation()->setPropagationStepSize(options.step);
            setup->getSpaceInformation()->setMinMaxControlDuration(options.minSteps, options.maxSteps);
            setup->setPlanner(makeControlPlanner(options.planner, setup->getSpaceInformation()));
            setup->setNearestStructure(nearestStructureOf(options.nearest));
            return setup;
        }

        /** Plan, and fill in the report and for how many seconds the callback was called; returns what Python threw
            meanwhile. */
        std::exception_ptr solve(TeamControlSetup &setup, const ControlOptions &options, PlanReport &report,
                                 double &seconds)
        {
            Progress progress(options.seconds, options.iterations, options.callback, *setup.getPlanner());
            const std::exception_ptr interrupt = progress.run(
                [&]
                {
                    setup.setup();
                    setup.getStatistics().reset();
                    const auto clock = std::make_shared<NearestClock>();
                    const bool timed = timeNearest(*setup.getPlanner(), clock);
                    const ob::PlannerStatus status = setup.solve(progress.condition());
                    report.solved = status == ob::PlannerStatus::EXACT_SOLUTION;
                    if (!report.solved)
                        report.reason = reasonOf(status, *setup.getPlanner());
                    if (timed)
                        report.nearestSeconds = clock->getSeconds();
                });
            seconds = progress.getSeconds();
            setCounts(report, setup, progress.getEvaluations());
            if (report.solved)
                report.cost = stateTimes(setup.getSolutionPath()).back();
            return interrupt;
        }

        /** Shorten the solution, for as long as it was planned for at most; returns what Python threw meanwhile. */
        std::exception_ptr simplify(TeamControlSetup &setup, const ControlOptions &options, PlanReport &report,
                                    double seconds)
        {
            Progress progress(options.seconds, 0, options.callback, *setup.getPlanner(), seconds, report.cost);
            const std::exception_ptr interrupt = progress.run([&] { setup.simplifySolution(progress.condition()); });
            report.simplifiedCost = stateTimes(setup.getSolutionPath()).back();
            report.simplifyingSeconds = setup.getLastSimplificationTime();
            return interrupt;
        }

        /** Plan in \e original, or, if there is a checker, among the obstacles that it has now. */
        ControlPlan planControls(const Scene &original, const std::shared_ptr<Checker> &checker, ControlOptions options,
                                 const py::object &start, const py::object &goal)
        {
            if (checker)
            {
                options.method = nameOf(checker->getSetup().getTeamChecker()->getMethod());
                options.motion = checker->getMotion();
            }
            requireSense(original, options);
            const auto planning = checker ? checker->beginPlanning() : nullptr;
            const Quiet quiet(ompl::msg::LOG_ERROR);
            seedRandomNumbers(options.seed);
            const Scene now = [&]
            {
                // Another thread may be changing the obstacles.
                const GilRelease release;
                return checker ? checker->getScene(nullptr, nullptr) : original;
            }();
            const auto scene = std::make_shared<const Scene>(withEnds(now, start, goal));
            if (options.planner.empty())
                options.planner = defaultControlPlanner(static_cast<unsigned int>(scene->getMembers().size()));

            ControlPlan plan;
            plan.scene = scene;
            plan.checker = checker;
            {
                // Large meshes take time.
                const GilRelease release;
                plan.setup = makeSetup(checker.get(), *scene, options);
            }
            setParameters(*plan.setup->getPlanner(), options);
            plan.planner = plan.setup->getPlanner();
            plan.report.scene = scene->getName();
            plan.report.planner = options.planner;
            plan.report.method = options.method;
            plan.report.motion = options.motion;
            plan.report.objective = "duration";
            plan.report.seed = options.seed;
            setNames(plan, *plan.setup->getStateSpace());
            plan.controlNames = controlNames(*plan.setup->getStateSpace());
            plan.controls = Doubles(std::vector<py::ssize_t>{0, static_cast<py::ssize_t>(plan.controlNames.size())});
            double seconds = 0.0;
            std::exception_ptr interrupt = solve(*plan.setup, options, plan.report, seconds);
            if (plan.report.solved && options.simplify && !interrupt)
                interrupt = simplify(*plan.setup, options, plan.report, seconds);
            if (plan.report.solved)
                setSolution(plan, plan.setup->getSolutionPath());
            plan.certificates = plan.setup->getTeamChecker()->getCertificates();
            rethrowWith(interrupt, [&plan] { return py::cast(std::move(plan)); });
            return plan;
        }

        /** The parameters of a planner, for a disc that is pushed */
        py::dict parametersOfControlPlanner(const std::string &name)
        {
            const Quiet quiet(ompl::msg::LOG_ERROR);
            const ob::RealVectorBounds bounds = toBounds({0.0, 0.0}, {1.0, 1.0});
            Scene scene(name, name, bounds);
            scene.addMember({Integrator::firstOrder(RigidRobot::inR2("disc", Body::disc(0.1), bounds), bounds),
                             {0.0, 0.0},
                             {1.0, 1.0}});
            return parametersOf(*makeControlPlanner(name, scene.makeControlSetup(0.5)->getSpaceInformation()));
        }
    }

    void bindControlPlanning(py::module_ &module)
    {
        bindControlPlan(module);
        module.def("control_planner_names", &controlPlannerNames, "The names of the planners of plan_controls()");
        module.def("control_planner_parameters", &parametersOfControlPlanner, py::arg("planner"),
                   "The parameters of a planner of plan_controls(), as planner_parameters() tells them");
        module.def(
            "_plan_controls",
            [](const Scene *scene, const std::shared_ptr<Checker> &checker, const std::string &planner,
               const std::string &method, double time, std::uint64_t iterations, std::uint32_t seed,
               const py::object &callback, const std::string &motion, double goalTolerance, const std::string &nearest,
               const std::map<std::string, py::object> &parameters, const py::object &start, const py::object &goal,
               double step, unsigned int minSteps, unsigned int maxSteps, bool simplified)
            {
                return planControls(scene ? *scene : checker->getOriginalScene(), checker,
                                    {{planner, time, iterations, seed, callback, parameters},
                                     method,
                                     motion,
                                     nearest,
                                     goalTolerance,
                                     step,
                                     minSteps,
                                     maxSteps,
                                     simplified},
                                    start, goal);
            },
            py::arg("scene"), py::arg("checker"), py::arg("planner"), py::arg("method"), py::arg("time"),
            py::arg("iterations"), py::arg("seed"), py::arg("callback"), py::arg("motion"), py::arg("goal_tolerance"),
            py::arg("nearest"), py::arg("parameters"), py::arg("start"), py::arg("goal"), py::arg("step"),
            py::arg("min_steps"), py::arg("max_steps"), py::arg("simplify"));
    }
}
