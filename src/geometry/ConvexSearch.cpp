#include "ConvexSearch.h"

namespace ompl_certificates
{
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
        const double squared = normal.squaredNorm();
        if (squared > 0.0 && normal.dot(a.cross(b)) >= 0.0 && normal.dot(b.cross(c)) >= 0.0 &&
            normal.dot(c.cross(a)) >= 0.0)
            return {{a, b, c}, 3, normal.dot(a) / squared * normal};
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
            // The origin is on the other side of this face than the fourth point.
            if (normal.dot(p[a]) * normal.dot(p[d] - p[a]) < 0.0)
                continue;
            const Simplex face = ofTriangle(p[a], p[b], p[c]);
            if (inside || face.nearest.squaredNorm() < best.nearest.squaredNorm())
                best = face;
            inside = false;
        }
        return best;
    }
}
