#ifndef OMPL_CERTIFICATES_OBSTACLES_FCL_TOLERANCE_
#define OMPL_CERTIFICATES_OBSTACLES_FCL_TOLERANCE_

#include "PlacedShape.h"

namespace ompl_certificates
{
    /** \brief What clearances among \e obstacles must be exceeded by for FCL to agree; see Obstacles::getTolerance()
        \param prismHeight how high primitives are made to be checked against meshes; 0 if they are not */
    double fclTolerance(const PlacedShapes &obstacles, double prismHeight);
}

#endif
