#ifndef OMPL_CERTIFICATES_PYTHON_OUTCOME_
#define OMPL_CERTIFICATES_PYTHON_OUTCOME_

#include "Arrays.h"
#include "Gil.h"
#include "Reports.h"

#include <ompl_certificates/certificates/Certificate.h>
#include <ompl_certificates/pictures/PathFile.h>
#include <ompl_certificates/pictures/PlanAnimation.h>
#include <ompl_certificates/pictures/PlanReport.h>
#include <ompl_certificates/pictures/PlanViewer.h>
#include <ompl_certificates/pictures/ScenePicture.h>
#include <ompl_certificates/scene/Scene.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <ompl/base/Planner.h>
#include <ompl/base/PlannerData.h>
#include <ompl/util/Exception.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <vector>

namespace ompl_certificates_python
{
    /** \brief What came of a plan of any kind. A kind of its own adds its \e solution, a path of OMPL. */
    struct Outcome
    {
        ompl_certificates::PlanReport report;
        std::vector<std::string> coordinates;

        /** \brief The states of the solution, one in each row, and when the team is there */
        Doubles path, times;

        /** \brief What pages and pictures show. They are made when they are asked for: that takes longer than many
            a plan. */
        std::shared_ptr<const ompl_certificates::Scene> scene;
        std::vector<ompl_certificates::Certificate> certificates;

        /** \brief The planner, and its tree once takeTree() has copied it. The tree's states are the planner's. */
        ompl::base::PlannerPtr planner;
        std::shared_ptr<const ompl::base::PlannerData> tree;

        /** \brief Whether the report tells what a proof found */
        bool isProofReported{false};
    };

    /** \brief The names of the coordinates, and no rows until there is a solution */
    void setNames(Outcome &outcome, const ompl::base::StateSpace &space);

    /** \brief The states as rows of an array
        \param count how many there are */
    Doubles toRows(const ompl::base::StateSpace &space, unsigned int count,
                   const std::function<const ompl::base::State *(unsigned int)> &stateAt);

    /** \brief The array, but Python must not write to it: a plan hands out the same one again and again. */
    Doubles readOnly(Doubles array);

    /** \brief Copy the planner's tree and report it, unless that was done before: it may take longer than the plan.
        With Python's lock. */
    void takeTree(Outcome &outcome);

    /** \brief Add to the report what is known once somebody asks for it: the tree, and a proof of the solution. With
        Python's lock. */
    template <typename Kind>
    void completeReport(Kind &plan)
    {
        takeTree(plan);
        if (plan.solution && !plan.isProofReported)
            prove(plan);
    }

    /** \brief Refuse a file that is no picture by its name.
        \throws ompl::Exception if it does not end in .svg */
    void requireSvg(const std::filesystem::path &file);

    /** \brief The states of a path at some times: one row for each
        \param object the times, as an array or as one number
        \param write writes the state at a time
        \throws ompl::Exception if a time is no number, or times have more than one dimension */
    Doubles statesAt(const py::object &object, const ompl::base::StateSpacePtr &space,
                     const std::function<void(double, ompl::base::State *)> &write);

    /** \brief The page with \e html, which is written to \e path unless that is None */
    py::object toView(const std::string &html, const py::object &path);

    /** \brief A picture as Python asks for it */
    template <typename Kind>
    void savePicture(Kind &plan, const std::filesystem::path &file, bool tree, bool certificates)
    {
        requireSvg(file);
        ompl_certificates::ScenePicture picture(*plan.scene);
        if (tree)
        {
            takeTree(plan);
            picture.setTree(*plan.tree);
        }
        if (certificates)
            picture.setCertificates(plan.certificates);
        const GilRelease release;
        if (plan.solution)
            picture.setPath(*plan.solution);
        picture.write(file.string());
    }

    /** \brief An animation as Python asks for it */
    template <typename Kind>
    void saveAnimation(const Kind &plan, const std::filesystem::path &file)
    {
        requireSvg(file);
        if (!plan.solution)
            throw ompl::Exception(file, "there is no path to be shown");
        const GilRelease release;
        ompl_certificates::PlanAnimation(*plan.scene, *plan.solution).write(file.string());
    }

    /** \brief A page as Python asks for it */
    template <typename Kind>
    py::object view(Kind &plan, const py::object &path)
    {
        std::string html;
        completeReport(plan);
        {
            // Another thread may prove the plan meanwhile.
            const ompl_certificates::PlanReport report = plan.report;
            const GilRelease release;
            ompl_certificates::PlanViewer viewer(*plan.scene);
            if (plan.solution)
                viewer.setPath(*plan.solution);
            viewer.setTree(*plan.tree);
            viewer.setCertificates(plan.certificates);
            viewer.setReport(report);
            html = viewer.toHtml();
        }
        return toView(html, path);
    }

    /** \brief Adds what plans of all kinds have to the class of one. */
    template <typename Kind>
    void bindOutcome(py::class_<Kind> &plan)
    {
        plan.def_property_readonly(
                "solved", [](const Kind &self) { return self.report.solved; }, "Whether a solution was found")
            .def_property_readonly(
                "reason",
                [](const Kind &self)
                { return self.report.reason.empty() ? py::object(py::none()) : py::str(self.report.reason); },
                "Why there is no solution, in a few words; None if there is one")
            .def_readonly("coordinates", &Kind::coordinates, "The names of the columns of path, such as scout.x")
            .def_property_readonly(
                "report",
                [](Kind &self)
                {
                    completeReport(self);
                    return toDict(self.report);
                },
                "Costs, counts and times (docs/plan-team.md), as a dict. The first report, page or picture of the tree "
                "copies the planner's tree: some seconds for a hundred thousand states. The first report or page of a "
                "solution also calls prove(), unless that was done before.")
            .def(
                "save_report",
                [](Kind &self, const std::filesystem::path &file)
                {
                    completeReport(self);
                    self.report.write(file);
                },
                py::arg("file"), "Write the report as JSON.")
            .def("save_picture", &savePicture<Kind>, py::arg("file"), py::kw_only(), py::arg("tree") = false,
                 py::arg("certificates") = false,
                 "Write a picture of the scene and the path, as SVG; with the planner's tree and the certificates if "
                 "asked. The name must end in .svg.")
            .def(
                "save_animation", &saveAnimation<Kind>, py::arg("file"),
                "Write a picture in which the robots follow the path again and again, as SVG, which browsers play. The "
                "name must end in .svg. Raises Error if there is no path.")
            .def("view", &view<Kind>, py::arg("path") = py::none(),
                 "A page in which the plan can be looked at, which a notebook shows. With a path it is written to that "
                 "file, too.")
            .def("__bool__", [](const Kind &self) { return self.report.solved; });
    }
}

#endif
