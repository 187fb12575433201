#include "Plan.h"
#include "Reports.h"
#include "Signals.h"

#include <ompl_certificates/pictures/PathFile.h>
#include <ompl_certificates/pictures/PlanViewer.h>
#include <ompl_certificates/pictures/ScenePicture.h>
#include <ompl_certificates/planning/PathProof.h>
#include <ompl_certificates/team/PathTimes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ompl/base/ScopedState.h>
#include <ompl/util/Exception.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
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
        Doubles statesAt(const Plan &plan, const py::object &object)
        {
            const Doubles times = toDoubles(object, "times");
            if (!plan.solution)
                throw ompl::Exception("at", "there is no path");
            const ob::StateSpacePtr &space = plan.solution->getSpaceInformation()->getStateSpace();
            const std::vector<double> known = stateTimes(*plan.solution);
            const auto columns = static_cast<py::ssize_t>(plan.coordinates.size());
            Doubles result({times.size(), columns});
            ob::ScopedState<> state(space);
            std::vector<double> row;
            for (py::ssize_t i = 0; i < times.size(); ++i)
            {
                const double time = times.data()[i];
                if (std::isnan(time))
                    throw ompl::Exception("times", "must be numbers, not nan");
                // The first state that is later; before the first and after the last the team rests.
                const auto next =
                    static_cast<std::size_t>(std::upper_bound(known.begin(), known.end(), time) - known.begin());
                const std::size_t before = next > 0 ? next - 1 : 0;
                const ob::State *from = plan.solution->getState(static_cast<unsigned int>(before));
                if (next > 0 && next < known.size())
                    space->interpolate(from, plan.solution->getState(static_cast<unsigned int>(next)),
                                       (time - known[before]) / (known[next] - known[before]), state.get());
                else
                    space->copyState(state.get(), from);
                space->copyToReals(row, state.get());
                std::copy(row.begin(), row.end(), result.mutable_data() + i * columns);
            }
            return times.ndim() == 0 ? Doubles(result.squeeze()) : result;
        }

        void savePicture(Plan &plan, const std::filesystem::path &file, bool tree, bool certificates)
        {
            requireSvg(file);
            ScenePicture picture(*plan.scene);
            if (tree)
            {
                takeTree(plan);
                picture.setTree(*plan.tree);
            }
            if (certificates)
                picture.setCertificates(plan.certificates);
            if (plan.solution)
                picture.setPath(*plan.solution);
            picture.write(file.string());
        }

        py::object view(Plan &plan, const py::object &path)
        {
            std::string html;
            takeTree(plan);
            {
                const py::gil_scoped_release release;
                PlanViewer viewer(*plan.scene);
                if (plan.solution)
                    viewer.setPath(*plan.solution);
                viewer.setTree(*plan.tree);
                viewer.setCertificates(plan.certificates);
                viewer.setReport(plan.report);
                html = viewer.toHtml();
            }
            py::object page = py::module_::import("ompl_certificates._view").attr("View")(html);
            if (!path.is_none())
                page.attr("save")(path);
            return page;
        }

        const PlanReport &reportOf(Plan &plan)
        {
            takeTree(plan);
            return plan.report;
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

        void savePath(const Plan &plan, const std::filesystem::path &file)
        {
            if (!plan.solution)
                throw ompl::Exception(file, "there is no path to be written");
            py::cast(file).attr("write_text")(toCsv(*plan.solution), py::arg("encoding") = "utf-8");
        }
    }

    void requireSvg(const std::filesystem::path &file)
    {
        if (file.extension() != ".svg")
            throw ompl::Exception(file, "pictures are SVG: the name must end in .svg");
    }

    void takeTree(Plan &plan)
    {
        if (plan.tree)
            return;
        const auto tree = std::make_shared<ob::PlannerData>(plan.planner->getSpaceInformation());
        plan.planner->getPlannerData(*tree);
        plan.report.setTree(*tree);
        plan.tree = tree;
    }

    void setSolution(Plan &plan, const ompl::geometric::PathGeometric &path)
    {
        const ob::StateSpacePtr &space = path.getSpaceInformation()->getStateSpace();
        std::vector<double> row;
        space->copyToReals(row, path.getState(0));
        const auto count = static_cast<py::ssize_t>(path.getStateCount());
        plan.path = Doubles({count, static_cast<py::ssize_t>(row.size())});
        double *values = plan.path.mutable_data();
        for (unsigned int i = 0; i < path.getStateCount(); ++i)
        {
            space->copyToReals(row, path.getState(i));
            values = std::copy(row.begin(), row.end(), values);
        }
        plan.times = Doubles(count, stateTimes(path).data());
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
        py::class_<Plan>(module, "Plan", "What came of a plan")
            .def_property_readonly(
                "solved", [](const Plan &plan) { return plan.report.solved; }, "Whether a solution was found")
            .def_property_readonly(
                "reason",
                [](const Plan &plan)
                { return plan.report.reason.empty() ? py::object(py::none()) : py::str(plan.report.reason); },
                "Why there is no solution, in a few words; None if there is one")
            .def("__repr__", py::overload_cast<const Plan &>(&describe))
            .def_property_readonly("cost", py::overload_cast<const Plan &>(&costOf),
                                   "The cost of the path, by the objective; infinite without a solution")
            .def_readonly("path", &Plan::path, "The states of the solution, of shape (n, coordinates); n is 0 without")
            .def_readonly("times", &Plan::times,
                          "When the team is at each state if no robot is faster than 1, of shape (n,)")
            .def_readonly("coordinates", &Plan::coordinates, "The names of the columns of path, such as scout.x")
            .def_property_readonly(
                "report", [](Plan &plan) { return toDict(reportOf(plan)); },
                "Costs, counts and times (docs/plan-team.md), as a dict. The first report, page or picture of the tree "
                "copies the planner's tree: some seconds for a hundred thousand states.")
            .def("prove", &prove,
                 "Prove that no robot touches anything on the path, also between the samples that discrete mode looks "
                 "at, among the checker's obstacles as they are now. Where a motion is not proved, samples a hundred "
                 "times as dense are looked at until one collides. Raises Error if there is no path, or for a method "
                 "without certificates.")
            .def("save", &savePath, py::arg("file"),
                 "Write the path as a table of comma-separated values (docs/plan-team.md).")
            .def(
                "save_report", [](Plan &plan, const std::filesystem::path &file) { reportOf(plan).write(file); },
                py::arg("file"), "Write the report as JSON.")
            .def(
                "at", &statesAt, py::arg("times"),
                "Where the team is at some times, of shape (n, coordinates), or for one time (coordinates,). Between two "
                "states of the path all robots move steadily, as OMPL interpolates; before the first and after the last "
                "they rest.")
            .def("save_picture", &savePicture, py::arg("file"), py::kw_only(), py::arg("tree") = false,
                 py::arg("certificates") = false,
                 "Write a picture of the scene and the path, as SVG; with the planner's tree and the certificates if "
                 "asked. The name must end in .svg.")
            .def("view", &view, py::arg("path") = py::none(),
                 "A page in which the plan can be looked at, which a notebook shows. With a path it is written to that "
                 "file, too.")
            .def("__bool__", [](const Plan &plan) { return plan.report.solved; });
    }
}
