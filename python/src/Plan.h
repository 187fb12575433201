#ifndef OMPL_CERTIFICATES_PYTHON_PLAN_
#define OMPL_CERTIFICATES_PYTHON_PLAN_

#include "Arrays.h"

#include <ompl_certificates/certificates/Certificate.h>
#include <ompl_certificates/pictures/PlanReport.h>
#include <ompl_certificates/scene/Scene.h>

#include <memory>
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
        std::shared_ptr<const ompl::base::PlannerData> tree;
        std::vector<ompl_certificates::Certificate> certificates;
    };

    /** \brief Fill in the solution, its states and their times. */
    void setSolution(Plan &plan, const ompl::geometric::PathGeometric &solution);

    /** \brief Adds the class to the module. */
    void bindPlan(py::module_ &module);
}

#endif
