#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_SOLUTION_PROOF_
#define OMPL_CERTIFICATES_DEMOS_COMMON_SOLUTION_PROOF_

#include "common/Interrupt.h"
#include "common/PlanTeamOptions.h"

#include "ompl_certificates/pictures/PlanReport.h"
#include "ompl_certificates/scene/Scene.h"
#include "ompl_certificates/validity/PathProof.h"

#include <memory>
#include <ompl/base/PlannerTerminationCondition.h>

namespace demos
{
    /** \brief Tell in \e report whether the solution of \e setup, if there is one, is free between its samples or
        within its steps, too. Ends with an interrupt, or after as much time as there was for planning. Whoever calls it
        includes the provePath() of such paths. */
    template <typename Setup>
    void proveSolution(const Setup &setup, const ompl_certificates::Scene &scene, const PlanTeamOptions &options,
                       ompl_certificates::PlanReport &report)
    {
        if (!report.solved)
            return;
        namespace ob = ompl::base;
        const ompl_certificates::PathProof proof =
            provePath(setup.getSolutionPath(), setup.getTeamChecker(),
                      ob::plannerOrTerminationCondition(ob::PlannerTerminationCondition(interrupted),
                                                        ob::timedPlannerTerminationCondition(options.seconds)));
        report.setProof(proof);
        if (proof.collision)
            report.collision = scene.describeCollision(
                std::static_pointer_cast<ompl_certificates::TeamStateSpace>(setup.getStateSpace()),
                proof.collision->get());
    }
}

#endif
