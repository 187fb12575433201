#ifndef OMPL_CERTIFICATES_GENERATORS_MESHES_
#define OMPL_CERTIFICATES_GENERATORS_MESHES_

#include "generators/MeshBuilder.h"

namespace generators
{
    /** \brief Points on a circle about the origin, counter-clockwise; \e radius may differ from point to point */
    std::vector<Eigen::Vector2d> circleOf(unsigned int corners, const std::function<double(unsigned int)> &radius);

    /** \brief A tube in the shape of a trefoil knot, within 3.3 of the origin */
    MeshBuilder knotMesh();

    /** \brief A flat ring with twelve teeth that end at \e radius; z from -0.2 to 0.2 */
    MeshBuilder gearMesh(double radius);

    /** \brief A cart in the shape of an L; z from 0.1 to 1.2 */
    MeshBuilder cartMesh();
}

#endif
