#include "Plan.h"

#include "Bindings.h"
#include "Gil.h"

#include <ompl_certificates/planning/PassingOrder.h>
#include <ompl_certificates/planning/ProvePath.h>
#include <ompl_certificates/team/PathTimes.h>
#include <ompl_certificates/team/TimedPath.h>

#include <limits>
#include <optional>
#include <sstream>

namespace ompl_certificates_python
{
    namespace ob = ompl::base;
    using namespace ompl_certificates;

    namespace
    {
        /** The cost of the path, infinite without one */
        double costOf(const Plan &plan)
        {
            if (!plan.report.solved)
                return std::numeric_limits<double>::infinity();
            return plan.report.simplifiedCost >= 0.0 ? plan.report.simplifiedCost : plan.report.cost;
        }

        std::string describe(const Plan &plan)
        {
            if (!plan.report.solved)
                return "<Plan: not solved: " + plan.report.reason + ">";
            std::ostringstream text;
            const bool isProved = plan.report.unprovedMotions == 0 && plan.report.unseenMotions == 0;
            text << "<Plan: solved, cost " << costOf(plan) << ", " << plan.path.shape(0) << " states, "
                 << (isProved                             ? "proved free"
                     : plan.report.unprovedMotions >= 0   ? "not proved free"
                     : plan.report.motion == "continuous" ? "motions proved"
                                                          : "motions checked at samples")
                 << ">";
            return text.str();
        }

        void savePath(const Plan &plan, const std::filesystem::path &file, const std::optional<double> &step)
        {
            if (!plan.solution)
                throw ompl::Exception(file, "there is no path to be written");
            if (step)
                writePath(file, *plan.solution, *step);
            else
                writePath(file, *plan.solution);
        }

        /** Where the team is at some times: one row for each */
        Doubles planAt(const Plan &plan, const py::object &times)
        {
            if (!plan.solution)
                throw ompl::Exception("at", "there is no path");
            const TimedPath path(*plan.solution);
            return statesAt(times, plan.solution->getSpaceInformation()->getStateSpace(),
                            [&](double time, ob::State *state) { path.computeState(time, state); });
        }

        PassingOrder passingOrder(const Plan &plan, double step)
        {
            if (!plan.solution)
                throw ompl::Exception("passing_order", "there is no path");
            const GilRelease release;
            return {*plan.solution, plan.checker->getSetup().getTeamChecker(), step};
        }
    }

    Proof prove(Plan &plan)
    {
        return reportProof(plan,
                           findProof(solutionOf(plan), plan.checker->getSetup().getTeamChecker(),
                                     [&](const ob::State *state) { return plan.checker->describeCollision(state); }));
    }

    void setSolution(Plan &plan, const ompl::geometric::PathGeometric &path)
    {
        plan.path = readOnly(toRows(*path.getSpaceInformation()->getStateSpace(),
                                    static_cast<unsigned int>(path.getStateCount()),
                                    [&path](unsigned int i) { return path.getState(i); }));
        plan.times = readOnly(Doubles(static_cast<py::ssize_t>(path.getStateCount()), stateTimes(path).data()));
        plan.solution = std::make_shared<const ompl::geometric::PathGeometric>(path);
    }

    void bindPlan(py::module_ &module)
    {
        py::class_<Plan> plan(module, "Plan", "What came of a plan");
        forbidNew(plan, "plan() makes plans");
        bindOutcome(plan);
        plan.def("__repr__", py::overload_cast<const Plan &>(&describe))
            .def_property_readonly("cost", py::overload_cast<const Plan &>(&costOf),
                                   "The cost of the path, by the objective; infinite without a solution")
            .def_readonly("path", &Plan::path, "The states of the solution, of shape (n, coordinates); n is 0 without")
            .def_readonly("times", &Plan::times,
                          "When the team is at each state if no robot is faster than its speed, of shape (n,)")
            .def("prove", py::overload_cast<Plan &>(&prove),
                 "Prove that no robot touches anything on the path, also between the samples that discrete mode looks "
                 "at, among the checker's obstacles as they are now. Where a motion is not proved, samples a hundred "
                 "times as dense are looked at until one collides. Raises Error if there is no path.")
            .def(
                "passing_order", &passingOrder, py::arg("step"),
                "Which robot passes first wherever the ways of two robots cross, for robots that may be late, in stages "
                "of at most so much time. Raises Error if there is no path, or step is not positive.")
            .def("save", &savePath, py::arg("file"), py::kw_only(), py::arg("step") = py::none(),
                 "Write the path as a table of comma-separated values (docs/plan-team.md). With a step there is a line "
                 "at each multiple of it in time, too, such as the period of a controller.")
            .def(
                "at", &planAt, py::arg("times"),
                "Where the team is at some times, of shape (n, coordinates), or for one time (coordinates,). Between two "
                "states of the path all robots move steadily, as OMPL interpolates; before the first and after the last "
                "they rest.");
    }
}
