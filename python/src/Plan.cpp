#include "Plan.h"
#include "Signals.h"

#include <ompl_certificates/planning/PathProof.h>
#include <ompl_certificates/team/PathTimes.h>

#include <limits>
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
            text << "<Plan: solved, cost " << costOf(plan) << ", " << plan.path.shape(0) << " states>";
            return text.str();
        }

        /** Where the team is at some times: one row for each */
        Doubles planAt(const Plan &plan, const py::object &times)
        {
            if (!plan.solution)
                throw ompl::Exception("at", "there is no path");
            const ob::StateSpacePtr &space = plan.solution->getSpaceInformation()->getStateSpace();
            const std::vector<double> known = stateTimes(*plan.solution);
            return statesAt(times, space, known,
                            [&](unsigned int before, double since, ob::State *state)
                            {
                                const ob::State *from = plan.solution->getState(before);
                                if (since > 0.0)
                                    space->interpolate(from, plan.solution->getState(before + 1),
                                                       since / (known[before + 1] - known[before]), state);
                                else
                                    space->copyState(state, from);
                            });
        }

        /** What provePath() tells, in Python's terms */
        struct Proof
        {
            std::vector<std::size_t> unproved;
            py::object collision, reason;
        };

        Proof prove(Plan &plan)
        {
            if (!plan.solution)
                throw ompl::Exception("prove", "there is no path");
            const auto &checker = plan.checker->getSetup().getTeamChecker();
            PathProof found;
            {
                const py::gil_scoped_release release;
                Signals signals;
                found = provePath(*plan.solution, checker,
                                  ob::PlannerTerminationCondition(
                                      [&signals]
                                      {
                                          signals.handle();
                                          return false;
                                      }));
            }
            plan.report.unprovedMotions = static_cast<std::int64_t>(found.unproved.size());
            plan.report.collision.clear();
            Proof proof{std::move(found.unproved), py::none(), py::none()};
            if (found.collision)
            {
                const std::vector<double> row = found.collision->reals();
                plan.report.collision = plan.checker->describeCollision(found.collision->get());
                proof.collision = Doubles(static_cast<py::ssize_t>(row.size()), row.data());
                proof.reason = py::str(plan.report.collision);
            }
            return proof;
        }

        std::string describe(const Proof &proof)
        {
            if (proof.unproved.empty())
                return "<Proof: free throughout>";
            return "<Proof: " + std::to_string(proof.unproved.size()) + " motions are not proved" +
                   (proof.reason.is_none() ? "" : ", " + proof.reason.cast<std::string>()) + ">";
        }

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
        py::class_<Proof>(module, "Proof", "What is known of a path between the samples at which it was checked")
            .def_property_readonly(
                "proved", [](const Proof &proof) { return proof.unproved.empty(); },
                "Whether all of the path is proved free")
            .def_readonly("unproved", &Proof::unproved,
                          "The motions that are not proved free, each by the row of the path that it starts at")
            .def_readonly("collision", &Proof::collision,
                          "The first invalid state that was found on these motions, of shape (coordinates,); None if "
                          "none was")
            .def_readonly("reason", &Proof::reason, "What collides there, in a few words; None if nothing was found")
            .def("__repr__", py::overload_cast<const Proof &>(&describe))
            .def("__bool__", [](const Proof &proof) { return proof.unproved.empty(); });
        py::class_<Plan> plan(module, "Plan", "What came of a plan");
        bindOutcome(plan);
        plan.def("__repr__", py::overload_cast<const Plan &>(&describe))
            .def_property_readonly("cost", py::overload_cast<const Plan &>(&costOf),
                                   "The cost of the path, by the objective; infinite without a solution")
            .def_readonly("path", &Plan::path, "The states of the solution, of shape (n, coordinates); n is 0 without")
            .def_readonly("times", &Plan::times,
                          "When the team is at each state if no robot is faster than 1, of shape (n,)")
            .def("prove", &prove,
                 "Prove that no robot touches anything on the path, also between the samples that discrete mode looks "
                 "at, among the checker's obstacles as they are now. Where a motion is not proved, samples a hundred "
                 "times as dense are looked at until one collides. Raises Error if there is no path.")
            .def("save", &savePath<Plan>, py::arg("file"),
                 "Write the path as a table of comma-separated values (docs/plan-team.md).")
            .def(
                "at", &planAt, py::arg("times"),
                "Where the team is at some times, of shape (n, coordinates), or for one time (coordinates,). Between two "
                "states of the path all robots move steadily, as OMPL interpolates; before the first and after the last "
                "they rest.");
    }
}
