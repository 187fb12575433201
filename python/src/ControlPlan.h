#ifndef OMPL_CERTIFICATES_PYTHON_CONTROL_PLAN_
#define OMPL_CERTIFICATES_PYTHON_CONTROL_PLAN_

#include "Outcome.h"
#include "Proof.h"

#include <ompl_certificates/control/TeamControlSetup.h>

#include <memory>
#include <ompl/control/PathControl.h>

namespace ompl_certificates_python
{
    class Checker;

    /** \brief What came of a plan by controls. Its path has a state for each step. */
    struct ControlPlan : Outcome
    {
        std::vector<std::string> controlNames;

        /** \brief The controls that are held from each state but the last one on, one in each row */
        Doubles controls;

        /** \brief Its states are those of path; null without a solution */
        std::shared_ptr<const ompl::control::PathControl> solution;

        /** \brief What the planner needs to live; without a checker it was planned in the scene alone */
        ompl_certificates::TeamControlSetupPtr setup;
        std::shared_ptr<const Checker> checker;
    };

    /** \brief Prove the solution, with a checker among its obstacles as they are now, and report what is found.
        \throws ompl::Exception if there is no path */
    Proof prove(ControlPlan &plan);

    /** \brief Fill in the solution, step by step, with states, times and controls. */
    void setSolution(ControlPlan &plan, const ompl::control::PathControl &solution);

    /** \brief Adds the class to the module. */
    void bindControlPlan(py::module_ &module);
}

#endif
