#ifndef OMPL_CERTIFICATES_GEOMETRY_TRIANGLE_DISTANCE_
#define OMPL_CERTIFICATES_GEOMETRY_TRIANGLE_DISTANCE_

#include <Eigen/Geometry>
#include <algorithm>

namespace ompl_certificates
{
    /** \brief Squared distance of the point \e p, given as its difference from the segment's first end, to a segment; also to
        one of no length */
    inline double squaredDistanceToSegment(const Eigen::Vector3d &p, const Eigen::Vector3d &segment)
    {
        const double along = p.dot(segment), length = segment.squaredNorm();
        if (along <= 0.0 || length == 0.0)
            return p.squaredNorm();
        if (along >= length)
            return (p - segment).squaredNorm();
        return (p - along / length * segment).squaredNorm();
    }

    /** \brief Squared distance of \e point to a triangle; also to one without area */
    inline double squaredDistanceToTriangle(const Eigen::Vector3d &point, const Eigen::Vector3d &a,
                                            const Eigen::Vector3d &b, const Eigen::Vector3d &c)
    {
        const Eigen::Vector3d ab = b - a, bc = c - b, ca = a - c;
        const Eigen::Vector3d ap = point - a, bp = point - b, cp = point - c;
        const Eigen::Vector3d normal = ca.cross(ab);
        const double squaredArea = normal.squaredNorm();
        if (squaredArea > 0.0 && normal.dot(ab.cross(ap)) >= 0.0 && normal.dot(bc.cross(bp)) >= 0.0 &&
            normal.dot(ca.cross(cp)) >= 0.0)
        {
            const double height = normal.dot(ap);
            return height * height / squaredArea;
        }
        return std::min(
            {squaredDistanceToSegment(ap, ab), squaredDistanceToSegment(bp, bc), squaredDistanceToSegment(cp, ca)});
    }
}

#endif
