#ifndef OMPL_CERTIFICATES_PYTHON_PROOF_
#define OMPL_CERTIFICATES_PYTHON_PROOF_

#include "Gil.h"
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

    /** \brief A PathProof, and what collides, in words; empty if nothing was found */
    struct FoundProof
    {
        ompl_certificates::PathProof proof;
        std::string collision;
    };

    /** \brief The same for Python. With its lock. */
    Proof toProof(const FoundProof &found);

    /** \brief Add what is found to the report of a plan, and return it for Python. With its lock. */
    Proof reportProof(Outcome &plan, const FoundProof &found);

    /** \brief The proof of a path by \e checker, which Ctrl-C ends. Python's lock is released meanwhile.
        \param describe tells what collides in a state, without Python's lock */
    template <typename Path>
    FoundProof findProof(const Path &path, const std::shared_ptr<ompl_certificates::TeamValidityChecker> &checker,
                         const std::function<std::string(const ompl::base::State *)> &describe)
    {
        const GilRelease release;
        Signals signals;
        FoundProof found{provePath(path, checker,
                                   ompl::base::PlannerTerminationCondition(
                                       [&signals]
                                       {
                                           signals.handle();
                                           return false;
                                       })),
                         ""};
        if (found.proof.collision)
            found.collision = describe(found.proof.collision->get());
        return found;
    }

    /** \brief The solution of a plan
        \throws ompl::Exception if there is none */
    template <typename Kind>
    const auto &solutionOf(const Kind &plan)
    {
        if (!plan.solution)
            throw ompl::Exception("prove", "there is no path");
        return *plan.solution;
    }
}

#endif
