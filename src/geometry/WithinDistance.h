#ifndef OMPL_CERTIFICATES_GEOMETRY_WITHIN_DISTANCE_
#define OMPL_CERTIFICATES_GEOMETRY_WITHIN_DISTANCE_

#include "ompl_certificates/geometry/Body.h"

#include <array>

namespace ompl_certificates
{
    /** \brief Whether two shapes are within a distance of each other, which is above zero: the check of padded bodies.
        It is exact but for a billionth of their sizes. Solid shapes are asked by the search of Gilbert, Johnson and
        Keerthi (1988) until a plane between them proves them farther apart, or two points prove them near enough.

        In the plane, a mesh and a primitive are seen from above, as the primitive stands for an upright prism. Two
        planar meshes are as far apart as in space.
        \param pose from the frame of \e b to the frame of \e a */
    bool areWithin(const Shape &a, const Shape &b, const Pose &pose, double distance);

    /** \brief The same for all shapes of two bodies, whatever their paddings
        \param pose from the frame of \e second to the frame of \e first */
    bool areWithin(const Body &first, const Body &second, const Pose &pose, double distance);

    /** \brief The same for a primitive and a triangle in its frame
        \param up the direction along which a planar primitive is endless; zero for a spatial one */
    bool isWithin(const Shape &primitive, const std::array<Eigen::Vector3d, 3> &triangle, const Eigen::Vector3d &up,
                  double distance);

    /** \brief The same for two triangles */
    bool isWithin(const std::array<Eigen::Vector3d, 3> &a, const std::array<Eigen::Vector3d, 3> &b, double distance);
}

#endif
