#ifndef OMPL_CERTIFICATES_CONTROL_PROVE_PATH_
#define OMPL_CERTIFICATES_CONTROL_PROVE_PATH_

#include "ompl_certificates/validity/PathProof.h"
#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <memory>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/control/PathControl.h>

namespace ompl_certificates
{
    /** \brief Prove that no robot touches anything on \e path, also within its steps, at whose ends alone discrete mode
        looks. The motions of the proof are these steps: those of PathControl::interpolate(), but the last one of a
        control takes what remains of its duration. A path of one state is proved if that is valid.

        Each step is proved as in continuous mode; see TeamPropagator::isStepFree(). A step that is not proved may be
        free all the same: it may pass too close to something. There, a hundred states are looked at until one is
        invalid, but no more than 100 000 of all steps. Limits are not looked at. Robots move as a TeamPropagator moves
        them; if a control does not lead to the next state of the path, as that of another propagator, its last step is
        not proved.

        Among the obstacles as they are now. What is learned is kept in \e checker, and counted in its statistics. For
        one that makes no certificates, by FCL or STANDARD, another checker is made, and forgotten. Cost: that of a step
        in continuous mode for each step, and of the states.
        \param path one of a TeamControlSetup, or of another space information whose controls a TeamPropagator takes
        \param condition ends the work where it becomes true. Steps that were not looked at are not proved then; their
        number is told.
        \throws ompl::Exception if \e checker is null or of another team, if the space information of \e path was not
        set up, and as TeamPropagator does */
    PathProof
    provePath(const ompl::control::PathControl &path, const std::shared_ptr<const TeamValidityChecker> &checker,
              const ompl::base::PlannerTerminationCondition &condition = ompl::base::plannerNonTerminatingCondition());
}

#endif
