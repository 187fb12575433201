#ifndef OMPL_CERTIFICATES_OBSTACLES_FCL_TOLERANCE_
#define OMPL_CERTIFICATES_OBSTACLES_FCL_TOLERANCE_

#include "PlacedShape.h"

namespace ompl_certificates
{
    /** \brief How much clearances among \e obstacles must exceed a radius for FCL to agree; see
        Obstacles::getTolerance()
        \param prismHeight the height of primitives when checked against meshes; 0 if they are not */
    double fclTolerance(const PlacedShapes &obstacles, double prismHeight);
}

#endif
