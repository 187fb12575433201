#ifndef OMPL_CERTIFICATES_PLANNING_PROVE_PATH_
#define OMPL_CERTIFICATES_PLANNING_PROVE_PATH_

#include "ompl_certificates/validity/PathProof.h"
#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <memory>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/geometric/PathGeometric.h>

namespace ompl_certificates
{
    /** \brief Prove that no robot touches anything on \e path, also between the samples at which discrete mode looks.

        Each motion is checked as in continuous mode. A motion that is not proved may be free all the same: it may pass
        too close to something. There, samples a hundred times as dense as those of discrete mode are looked at until
        one is invalid. A motion of more than 1000 segments has 100 000 samples, and no more than so many are looked at
        on all motions together. A path of one state is proved if that is valid.

        Among the obstacles as they are now. The path need not be valid. What is learned is kept in \e checker, and
        counted in its statistics. For one that makes no certificates, by FCL or STANDARD, another checker is made, and
        forgotten. Cost: that of a motion in continuous mode for each motion, and of the samples.
        \param condition ends the work where it becomes true. Motions that were not looked at are not proved then; their
        number is told.
        \throws ompl::Exception if the space has no continuous mode; see CertificateMotionValidator. Also if the path is
        one of another space, such as that of a robot alone, or has no state. */
    PathProof
    provePath(const ompl::geometric::PathGeometric &path, const std::shared_ptr<const TeamValidityChecker> &checker,
              const ompl::base::PlannerTerminationCondition &condition = ompl::base::plannerNonTerminatingCondition());
}

#endif
