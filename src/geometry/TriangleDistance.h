#ifndef OMPL_CERTIFICATES_GEOMETRY_TRIANGLE_DISTANCE_
#define OMPL_CERTIFICATES_GEOMETRY_TRIANGLE_DISTANCE_

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace ompl_certificates
{
    /** \brief Squared distance of a point to a segment, which may have length zero. \e p is the point minus the
        segment's first end. */
    inline double squaredDistanceToSegment(const Eigen::Vector3d &p, const Eigen::Vector3d &segment)
    {
        const double along = p.dot(segment), length = segment.squaredNorm();
        if (along <= 0.0 || length == 0.0)
            return p.squaredNorm();
        if (along >= length)
            return (p - segment).squaredNorm();
        return (p - along / length * segment).squaredNorm();
    }

    /** \brief Whether a triangle is so thin that rounding decides on which side of its edges a point is: its corners are
        on one line. Then its edges are all of it.
        \param squaredArea the squared length of the cross product of two of its edges */
    inline bool isThin(double squaredArea, const Eigen::Vector3d &ab, const Eigen::Vector3d &bc,
                       const Eigen::Vector3d &ca)
    {
        const double longest = std::max({ab.squaredNorm(), bc.squaredNorm(), ca.squaredNorm()});
        return !(squaredArea > 1e-24 * longest * longest);
    }

    /** \brief The point of a triangle that is nearest to \e point, or one about as near */
    inline Eigen::Vector3d nearestOfTriangle(const Eigen::Vector3d &point, const Eigen::Vector3d &a,
                                             const Eigen::Vector3d &b, const Eigen::Vector3d &c)
    {
        const Eigen::Vector3d normal = (b - a).cross(c - a);
        const double squaredArea = normal.squaredNorm();
        if (!isThin(squaredArea, b - a, c - b, a - c))
        {
            Eigen::Vector3d foot = point - normal.dot(point - a) / squaredArea * normal;
            if (normal.dot((b - a).cross(foot - a)) >= 0.0 && normal.dot((c - b).cross(foot - b)) >= 0.0 &&
                normal.dot((a - c).cross(foot - c)) >= 0.0)
                return foot;
        }
        Eigen::Vector3d nearest = a;
        for (const auto &[from, to] : {std::make_pair(&a, &b), std::make_pair(&b, &c), std::make_pair(&c, &a)})
        {
            const Eigen::Vector3d edge = *to - *from;
            const double length = edge.squaredNorm();
            const double along = length > 0.0 ? std::clamp(edge.dot(point - *from) / length, 0.0, 1.0) : 0.0;
            const Eigen::Vector3d candidate = *from + along * edge;
            if ((candidate - point).squaredNorm() < (nearest - point).squaredNorm())
                nearest = candidate;
        }
        return nearest;
    }

    /** \brief Squared distance of \e point to a triangle; also to one without area */
    inline double squaredDistanceToTriangle(const Eigen::Vector3d &point, const Eigen::Vector3d &a,
                                            const Eigen::Vector3d &b, const Eigen::Vector3d &c)
    {
        const Eigen::Vector3d ab = b - a, bc = c - b, ca = a - c;
        const Eigen::Vector3d ap = point - a, bp = point - b, cp = point - c;
        const Eigen::Vector3d normal = ca.cross(ab);
        const double squaredArea = normal.squaredNorm();
        if (normal.dot(ab.cross(ap)) >= 0.0 && normal.dot(bc.cross(bp)) >= 0.0 && normal.dot(ca.cross(cp)) >= 0.0 &&
            !isThin(squaredArea, ab, bc, ca))
        {
            const double height = normal.dot(ap);
            return height * height / squaredArea;
        }
        return std::min(
            {squaredDistanceToSegment(ap, ab), squaredDistanceToSegment(bp, bc), squaredDistanceToSegment(cp, ca)});
    }
}

#endif
