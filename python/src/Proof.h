#ifndef OMPL_CERTIFICATES_PYTHON_PROOF_
#define OMPL_CERTIFICATES_PYTHON_PROOF_

#include "Outcome.h"
#include "Signals.h"

#include <ompl_certificates/validity/PathProof.h>

#include <functional>
#include <ompl/base/PlannerTerminationCondition.h>
#include <vector>

namespace ompl_certificates_python
{
    /** \brief A PathProof, in Python's terms */
    struct Proof
    {
        std::vector<std::size_t> unproved;
        py::object collision, reason;
    };

    /** \brief Add what is found to the report of a plan. With Python's lock.
        \param collision what collides, in words; empty if nothing */
    Proof reportProof(Outcome &plan, const ompl_certificates::PathProof &found, const std::string &collision);

    /** \brief The proof of a plan's solution by \e checker, which Ctrl-C ends
        \param describe tells what collides in a state, without Python's lock
        \throws ompl::Exception if there is no path */
    template <typename Kind>
    Proof prove(Kind &plan, const std::shared_ptr<ompl_certificates::TeamValidityChecker> &checker,
                const std::function<std::string(const ompl::base::State *)> &describe)
    {
        if (!plan.solution)
            throw ompl::Exception("prove", "there is no path");
        ompl_certificates::PathProof found;
        std::string collision;
        {
            const py::gil_scoped_release release;
            Signals signals;
            found = provePath(*plan.solution, checker,
                              ompl::base::PlannerTerminationCondition(
                                  [&signals]
                                  {
                                      signals.handle();
                                      return false;
                                  }));
            if (found.collision)
                collision = describe(found.collision->get());
        }
        return reportProof(plan, found, collision);
    }
}

#endif
