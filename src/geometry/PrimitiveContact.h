#ifndef OMPL_CERTIFICATES_GEOMETRY_PRIMITIVE_CONTACT_
#define OMPL_CERTIFICATES_GEOMETRY_PRIMITIVE_CONTACT_

#include "ompl_certificates/geometry/Pose.h"
#include "ompl_certificates/geometry/Shape.h"
#include "ompl_certificates/geometry/Touching.h"

#include <array>

namespace ompl_certificates
{
    /** \brief Whether a triangle touches a primitive, both in space. YES and NO stay true if one of them moves by less
        than \e margin. UNKNOWN where they just touch, and for some polytopes of more than 25 faces. Allocates nothing.
        \param triangle its corners in the primitive's frame; it may have no area */
    Touching touching(const Shape &primitive, const std::array<Eigen::Vector3d, 3> &triangle, double margin);

    /** \brief Whether two primitives touch, both of the plane or both of space. YES and NO stay true if one of them
        moves by less than \e margin. UNKNOWN where they just touch, for some cylinders that are near each other, and
        for polytopes of more than about 30 faces. Takes up to some 50 ns for each pair of faces. Allocates nothing.
        \param pose from the frame of \e a to the frame of \e b */
    Touching touching(const Shape &a, const Shape &b, const Pose &pose, double margin);
}

#endif
