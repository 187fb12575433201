#ifndef OMPL_CERTIFICATES_VALIDITY_BODY_CLEARANCE_
#define OMPL_CERTIFICATES_VALIDITY_BODY_CLEARANCE_

#include "ompl_certificates/obstacles/Obstacles.h"

namespace ompl_certificates
{
    /** \brief A lower bound of the distance from \e body at \e pose to the obstacles, to within the leaves of its
        sphere tree. Exact for a disc and a sphere. Nearer than these leaves are large, to within a sixteenth of
        the distance, by Obstacles::staysFree(). */
    double bodyClearance(const Obstacles &obstacles, const Body &body, const Pose &pose);
}

#endif
