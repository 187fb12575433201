#ifndef OMPL_CERTIFICATES_VALIDITY_BODY_PREPARATION_
#define OMPL_CERTIFICATES_VALIDITY_BODY_PREPARATION_

#include "ompl_certificates/team/Team.h"

namespace ompl_certificates
{
    /** \brief Make what the checks of all methods but FCL need of a team's bodies, as they would when first asked:
        balls, convex covers, and of meshes their trees and the balls inside them. What takes long is shared among
        threads. */
    void prepareBodies(const Team &team);
}

#endif
