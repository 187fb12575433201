#ifndef OMPL_CERTIFICATES_GEOMETRY_SPHERE_TREE_BUILDER_
#define OMPL_CERTIFICATES_GEOMETRY_SPHERE_TREE_BUILDER_

#include "ompl_certificates/geometry/Body.h"

namespace ompl_certificates
{
    /** \brief The sphere tree of \e parts. Halves the pieces of every shape across their longest extent, until their
        balls are an eighth of the shape's own or fit their piece tightly. Takes well under a millisecond. */
    SphereTree buildSphereTree(const std::vector<Body::Part> &parts);

    /** \brief A few large balls inside \e parts, the largest first. They are the largest ones about the centers of
        \e sphereTree. */
    std::vector<Ball> buildInnerSpheres(const std::vector<Body::Part> &parts, const SphereTree &sphereTree);

    /** \brief Signed distance of \e point to the nearest of \e parts */
    double signedDistance(const std::vector<Body::Part> &parts, const Eigen::Vector3d &point);
}

#endif
