#ifndef OMPL_CERTIFICATES_PYTHON_PLAN_
#define OMPL_CERTIFICATES_PYTHON_PLAN_

#include "Checker.h"
#include "Outcome.h"
#include "Proof.h"

#include <memory>
#include <ompl/geometric/PathGeometric.h>

namespace ompl_certificates_python
{
    /** \brief What came of a plan */
    struct Plan : Outcome
    {
        /** \brief Null without a solution */
        std::shared_ptr<const ompl::geometric::PathGeometric> solution;

        /** \brief What the planner needs to live */
        std::shared_ptr<const Checker> checker;
    };

    /** \brief Prove the solution among the checker's obstacles as they are now, and report what is found.
        \throws ompl::Exception if there is no path */
    Proof prove(Plan &plan);

    /** \brief Fill in the solution, its states and their times. */
    void setSolution(Plan &plan, const ompl::geometric::PathGeometric &solution);

    /** \brief Adds the class to the module. */
    void bindPlan(py::module_ &module);
}

#endif
