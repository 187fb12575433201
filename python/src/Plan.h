#ifndef OMPL_CERTIFICATES_PYTHON_PLAN_
#define OMPL_CERTIFICATES_PYTHON_PLAN_

#include "Checker.h"

#include <ompl_certificates/certificates/Certificate.h>
#include <ompl_certificates/pictures/PlanReport.h>
#include <ompl_certificates/scene/Scene.h>

#include <filesystem>
#include <memory>
#include <ompl/base/Planner.h>
#include <ompl/base/PlannerData.h>
#include <ompl/geometric/PathGeometric.h>
#include <string>
#include <vector>

namespace ompl_certificates_python
{
    /** \brief What came of a plan */
    struct Plan
    {
        ompl_certificates::PlanReport report;
        std::vector<std::string> coordinates;

        /** \brief The states of the solution, one in each row, and when the team is there */
        Doubles path, times;

        /** \brief What pages and pictures show. They are made when they are asked for: that takes longer than many
            a plan. Without a solution there is none. */
        std::shared_ptr<const ompl_certificates::Scene> scene;
        std::shared_ptr<const ompl::geometric::PathGeometric> solution;
        std::vector<ompl_certificates::Certificate> certificates;

        /** \brief The planner and what it needs to live, and its tree once takeTree() has copied it. The tree's states
            are the planner's. */
        std::shared_ptr<const Checker> checker;
        ompl::base::PlannerPtr planner;
        std::shared_ptr<const ompl::base::PlannerData> tree;
    };

    /** \brief Copy the planner's tree and report it, unless that was done before: it may take longer than the plan.
        With Python's lock. */
    void takeTree(Plan &plan);

    /** \brief Refuse a file that is no picture by its name.
        \throws ompl::Exception if it does not end in .svg */
    void requireSvg(const std::filesystem::path &file);

    /** \brief Fill in the solution, its states and their times. */
    void setSolution(Plan &plan, const ompl::geometric::PathGeometric &solution);

    /** \brief Adds the class to the module. */
    void bindPlan(py::module_ &module);
}

#endif
