#include "ControlPlan.h"

#include "Bindings.h"
#include "Checker.h"

#include <ompl_certificates/control/PathSteps.h>
#include <ompl_certificates/control/ProvePath.h>
#include <ompl_certificates/team/PathTimes.h>

#include <algorithm>
#include <limits>
#include <ompl/control/spaces/RealVectorControlSpace.h>
#include <sstream>

namespace ompl_certificates_python
{
    namespace ob = ompl::base;
    namespace control = ompl::control;
    using namespace ompl_certificates;

    namespace
    {
        /** The path's duration, infinite without one */
        double durationOf(const ControlPlan &plan)
        {
            if (!plan.solution)
                return std::numeric_limits<double>::infinity();
            return plan.report.simplifiedCost >= 0.0 ? plan.report.simplifiedCost : plan.report.cost;
        }

        std::string describe(const ControlPlan &plan)
        {
            if (!plan.solution)
                return "<ControlPlan: not solved: " + plan.report.reason + ">";
            std::ostringstream text;
            text << "<ControlPlan: solved, " << durationOf(plan) << " s, " << plan.controls.shape(0) << " steps>";
            return text.str();
        }

        void save(const ControlPlan &plan, const std::filesystem::path &file)
        {
            if (!plan.solution)
                throw ompl::Exception(file, "there is no path to be written");
            writePath(file, *plan.solution);
        }

        /** Where the controls bring the team to at some times: one row for each */
        Doubles controlPlanAt(const ControlPlan &plan, const py::object &times)
        {
            if (!plan.solution)
                throw ompl::Exception("at", "there is no path");
            // That of the setup may look for proofs, which parts of a step do not need.
            const TeamPropagator propagator(plan.setup->getSpaceInformation());
            const ob::StateSpacePtr &space = plan.setup->getStateSpace();
            const std::vector<double> known = stateTimes(*plan.solution);
            return statesAt(times, space,
                            [&](double time, ob::State *state)
                            {
                                // The last state that is not later; before the first and after the last the team rests.
                                const auto next = std::upper_bound(known.begin(), known.end(), time);
                                const auto before =
                                    static_cast<unsigned int>(next == known.begin() ? 0 : next - known.begin() - 1);
                                const double since =
                                    next == known.begin() || next == known.end() ? 0.0 : time - known[before];
                                const ob::State *from = plan.solution->getState(before);
                                if (since > 0.0)
                                    propagator.propagate(from, plan.solution->getControl(before), since, state);
                                else
                                    space->copyState(state, from);
                            });
        }
    }

    Proof prove(ControlPlan &plan)
    {
        const auto team = std::static_pointer_cast<TeamStateSpace>(plan.setup->getStateSpace());
        return reportProof(plan, findProof(solutionOf(plan), plan.setup->getTeamChecker(),
                                           [&](const ob::State *state) {
                                               return plan.checker ? plan.checker->describeCollision(state)
                                                                   : plan.scene->describeCollision(team, state);
                                           }));
    }

    namespace
    {
        /** The proof among the obstacles that a checker has now. The report is about those of the plan. */
        Proof proveAmong(const ControlPlan &plan, const Checker &checker)
        {
            const auto team = std::static_pointer_cast<TeamStateSpace>(plan.setup->getStateSpace());
            const auto among =
                std::make_shared<TeamValidityChecker>(plan.setup->getSpaceInformation(), checker.getObstacles());
            return toProof(findProof(solutionOf(plan), among,
                                     [&](const ob::State *state)
                                     { return checker.getScene(nullptr, nullptr).describeCollision(team, state); }));
        }
    }

    void setSolution(ControlPlan &plan, const control::PathControl &solution)
    {
        const auto path = std::make_shared<control::PathControl>(pathSteps(solution));
        plan.path = readOnly(toRows(*plan.setup->getStateSpace(), static_cast<unsigned int>(path->getStateCount()),
                                    [&path](unsigned int i) { return path->getState(i); }));
        plan.times = readOnly(Doubles(static_cast<py::ssize_t>(path->getStateCount()), stateTimes(*path).data()));
        const auto columns = static_cast<py::ssize_t>(plan.controlNames.size());
        plan.controls = Doubles({static_cast<py::ssize_t>(path->getControlCount()), columns});
        double *values = plan.controls.mutable_data();
        for (unsigned int i = 0; i < path->getControlCount(); ++i)
            values = std::copy_n(path->getControl(i)->as<control::RealVectorControlSpace::ControlType>()->values,
                                 columns, values);
        plan.controls = readOnly(std::move(plan.controls));
        plan.solution = path;
    }

    void bindControlPlan(py::module_ &module)
    {
        py::class_<ControlPlan> plan(module, "ControlPlan", "What came of a plan by controls");
        forbidNew(plan, "plan_controls() makes plans by controls");
        bindOutcome(plan);
        plan.def("__repr__", py::overload_cast<const ControlPlan &>(&describe))
            .def_property_readonly("cost", &durationOf,
                                   "The duration of the path, in seconds; infinite without a solution")
            .def_readonly("path", &ControlPlan::path,
                          "The states of the solution, one for each step, of shape (n, coordinates); n is 0 without")
            .def_readonly("times", &ControlPlan::times, "When the team is at each state, in seconds, of shape (n,)")
            .def_readonly("controls", &ControlPlan::controls,
                          "The controls that are held from each state to the next, of shape (n - 1, controls)")
            .def_readonly("control_names", &ControlPlan::controlNames,
                          "The names of the columns of controls, such as cart.linear")
            .def(
                "prove",
                [](ControlPlan &self, const Checker *checker)
                { return checker ? proveAmong(self, *checker) : prove(self); },
                py::arg("checker") = py::none(),
                "Prove that no robot touches anything on the path, also within its steps, at whose ends alone discrete "
                "mode looks: among the obstacles that the scene had when the plan was made, or those that a checker has "
                "now: the one that is passed, such as one of the same scene that is told what a sensor sees, or that the "
                "plan was made with. In a step that is not proved a "
                "hundred states are looked at until one collides. Raises Error if there is no path.")
            .def("save", &save, py::arg("file"),
                 "Write times, states and controls as a table of comma-separated values (docs/controls.md).")
            .def(
                "at", &controlPlanAt, py::arg("times"),
                "Where the team is at some times, in seconds, of shape (n, coordinates), or for one time "
                "(coordinates,). Between two states of the path it moves as the controls move it; before the first and "
                "after the last it rests.");
    }
}
