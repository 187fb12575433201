#ifndef OMPL_CERTIFICATES_VALIDITY_REPAIR_IN_STEPS_
#define OMPL_CERTIFICATES_VALIDITY_REPAIR_IN_STEPS_

#include "CheckMethod.h"

#include "ompl_certificates/obstacles/ObstacleChange.h"
#include "ompl_certificates/validity/WorldLock.h"

#include <functional>

namespace ompl_certificates
{
    /** \brief Bring the certificates of \e method up to date with \e change, in short steps between which others check
        \param world which is open; in the end it is so again
        \param exchange makes the new obstacles those of all checks, in a moment when there are none */
    void repairInSteps(WorldLock::Change &world, CheckMethod &method, const ObstacleChange &change,
                       const std::function<void()> &exchange);
}

#endif
