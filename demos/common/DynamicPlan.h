#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_DYNAMIC_PLAN_
#define OMPL_CERTIFICATES_DEMOS_COMMON_DYNAMIC_PLAN_

#include "common/PlanTeamOptions.h"

namespace demos
{
    /** \brief Plan for a team that moves by controls, print and write: certificates plan --dynamics
        \return the program's exit code
        \throws ompl::Exception for bad input */
    int runDynamics(PlanTeamOptions options);
}

#endif
