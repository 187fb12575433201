#include "ConvexSearch.h"

#include <Eigen/Geometry>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** A tetrahedron that is flatter than this has no inside that rounding would not hide. */
        constexpr double FLAT = 1e-10;
    }

    bool ConvexSearch::add(const Eigen::Vector3d &point, double bound, double precision)
    {
        if (count_ > 0 && bound > precision * nearest_.norm())
            return false;
        points_[count_] = point;
        Simplex next;
        switch (count_)
        {
            case 0:
                next = {{point}, 1, point};
                break;
            case 1:
                next = ofSegment(points_[0], point);
                break;
            case 2:
                next = ofTriangle(points_[0], points_[1], point);
                break;
            default:
                next = ofTetrahedron(points_);
        }
        // Rounding may end the search.
        if (count_ > 0 && !(next.nearest.squaredNorm() < nearest_.squaredNorm()))
            return false;
        points_ = next.points;
        count_ = next.count;
        nearest_ = next.nearest;
        return count_ < 4;
    }

    ConvexSearch::Simplex ConvexSearch::ofSegment(const Eigen::Vector3d &a, const Eigen::Vector3d &b)
    {
        const Eigen::Vector3d edge = b - a;
        const double along = -a.dot(edge), squared = edge.squaredNorm();
        if (!(along > 0.0))
            return {{a}, 1, a};
        if (along >= squared)
            return {{b}, 1, b};
        return {{a, b}, 2, a + along / squared * edge};
    }

    ConvexSearch::Simplex ConvexSearch::ofTriangle(const Eigen::Vector3d &a, const Eigen::Vector3d &b,
                                                   const Eigen::Vector3d &c)
    {
        const Eigen::Vector3d normal = (b - a).cross(c - a);
        const double ofA = normal.dot(b.cross(c)), ofB = normal.dot(c.cross(a)), ofC = normal.dot(a.cross(b)),
                     sum = ofA + ofB + ofC;
        // Whatever rounding does to the normal of a sliver, this is a point between the three.
        if (sum > 0.0 && ofA >= 0.0 && ofB >= 0.0 && ofC >= 0.0)
            return {{a, b, c}, 3, (ofA * a + ofB * b + ofC * c) / sum};
        Simplex best = ofSegment(a, b);
        for (const Simplex &other : {ofSegment(b, c), ofSegment(c, a)})
            if (other.nearest.squaredNorm() < best.nearest.squaredNorm())
                best = other;
        return best;
    }

    ConvexSearch::Simplex ConvexSearch::ofTetrahedron(const Points &p)
    {
        Simplex best{p, 4, Eigen::Vector3d::Zero()};
        bool inside = true;
        for (const auto &[a, b, c, d] :
             {std::array<std::size_t, 4>{0, 1, 2, 3}, std::array<std::size_t, 4>{0, 1, 3, 2},
              std::array<std::size_t, 4>{0, 2, 3, 1}, std::array<std::size_t, 4>{1, 2, 3, 0}})
        {
            const Eigen::Vector3d normal = (p[b] - p[a]).cross(p[c] - p[a]);
            // The origin is on the side of the fourth point, unless the four are in one plane, but for rounding.
            const double height = normal.dot(p[d] - p[a]);
            if (normal.dot(p[a]) * height < 0.0 && std::abs(height) > FLAT * normal.norm() * (p[d] - p[a]).norm())
                continue;
            const Simplex face = ofTriangle(p[a], p[b], p[c]);
            if (inside || face.nearest.squaredNorm() < best.nearest.squaredNorm())
                best = face;
            inside = false;
        }
        return best;
    }
}
