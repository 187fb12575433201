#include "ompl_certificates/geometry/ConvexHull.h"

#include "TriangleDistance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        double distanceToFace(const ConvexHull &hull, const ConvexHull::Face &face, const Eigen::Vector3d &point)
        {
            const auto &corners = face.vertices;
            bool beside = false;
            double squared = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < corners.size(); ++i)
            {
                const Eigen::Vector3d &a = hull.vertices[corners[i]];
                const Eigen::Vector3d &b = hull.vertices[corners[(i + 1) % corners.size()]];
                beside = beside || face.normal.cross(b - a).dot(point - a) < 0.0;
                // Over all edges: next to a corner, or between two edges in line, rounding decides which one the point
                // is beside.
                squared = std::min(squared, squaredDistanceToSegment(point - a, b - a));
            }
            // Beside no edge: the foot of the perpendicular lies in the face.
            return beside ? std::sqrt(squared) : std::abs(face.normal.dot(point) - face.offset);
        }

        double cross2(const Eigen::Vector3d &o, const Eigen::Vector3d &a, const Eigen::Vector3d &b)
        {
            return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
        }

        /** The corners of the hull of points of the plane, counter-clockwise, by Andrew's monotone chain. Leaves out
            those that are straight to within \e tolerance (an area). Fewer than three if the points span no area. */
        std::vector<Eigen::Vector3d> outlineOf(std::vector<Eigen::Vector3d> points, double tolerance)
        {
            std::sort(points.begin(), points.end(),
                      [](const Eigen::Vector3d &a, const Eigen::Vector3d &b)
                      { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
            std::vector<Eigen::Vector3d> chain;
            const auto append = [&chain, tolerance](const Eigen::Vector3d &point, std::size_t fixed)
            {
                while (chain.size() > fixed && cross2(chain[chain.size() - 2], chain.back(), point) <= tolerance)
                    chain.pop_back();
                chain.push_back(point);
            };
            for (const auto &point : points)
                append(point, 1);
            const std::size_t lower = chain.size();
            for (auto point = points.rbegin() + 1; point != points.rend(); ++point)
                append(*point, lower);
            chain.pop_back();
            return chain;
        }

        ConvexHull planarHull(std::vector<Eigen::Vector3d> points, double tolerance)
        {
            for (auto &point : points)
                point.z() = 0.0;
            ConvexHull hull;
            hull.vertices = outlineOf(std::move(points), tolerance);
            const auto &chain = hull.vertices;
            if (chain.size() < 3)
                throw ompl::Exception("The points of a polygon span no area");
            for (std::size_t i = 0; i < chain.size(); ++i)
            {
                const std::size_t next = (i + 1) % chain.size();
                const Eigen::Vector3d edge = chain[next] - chain[i];
                const Eigen::Vector3d normal = Eigen::Vector3d(edge.y(), -edge.x(), 0.0).normalized();
                hull.faces.push_back({normal, normal.dot(chain[i]), {i, next}});
            }
            return hull;
        }

        /** The points without those that are within \e tolerance of an earlier one */
        std::vector<Eigen::Vector3d> distinct(const std::vector<Eigen::Vector3d> &points, double tolerance)
        {
            std::vector<Eigen::Vector3d> kept;
            for (const auto &point : points)
                if (std::none_of(kept.begin(), kept.end(),
                                 [&](const Eigen::Vector3d &other) { return (point - other).norm() <= tolerance; }))
                    kept.push_back(point);
            return kept;
        }

        /** Finds the faces of a polytope: every plane through three points that has no point beyond it is one. */
        class FaceSearch
        {
        public:
            FaceSearch(const std::vector<Eigen::Vector3d> &points, double tolerance)
              : points_(points), tolerance_(tolerance)
            {
            }

            std::vector<ConvexHull::Face> run()
            {
                for (std::size_t i = 0; i < points_.size(); ++i)
                    for (std::size_t j = i + 1; j < points_.size(); ++j)
                        for (std::size_t k = j + 1; k < points_.size(); ++k)
                            lookAt({i, j, k});
                return std::move(faces_);
            }

        private:
            void lookAt(const std::array<std::size_t, 3> &three)
            {
                const Eigen::Vector3d &from = points_[three[0]], a = points_[three[1]] - from,
                                      b = points_[three[2]] - from;
                const Eigen::Vector3d normal = a.cross(b);
                if (normal.norm() <= tolerance_ * (a.norm() + b.norm()))
                    return;
                // Three points that are not on a line lie in one plane only. Two faces may share more points than two:
                // all those of their common edge.
                const auto holdsAllThree = [&](const std::vector<std::size_t> &plane)
                {
                    return std::all_of(three.begin(), three.end(),
                                       [&](std::size_t v)
                                       { return std::binary_search(plane.begin(), plane.end(), v); });
                };
                if (std::any_of(planes_.begin(), planes_.end(), holdsAllThree))
                    return;
                for (const double sign : {1.0, -1.0})
                    addFace(sign * normal.normalized(), from);
            }

            /** Add the face in the plane through \e from, if no point is beyond it. */
            void addFace(const Eigen::Vector3d &outward, const Eigen::Vector3d &from)
            {
                const double offset = outward.dot(from);
                std::vector<std::size_t> plane;
                for (std::size_t v = 0; v < points_.size(); ++v)
                {
                    const double height = outward.dot(points_[v]);
                    if (height > offset + tolerance_)
                        return;
                    if (height >= offset - tolerance_)
                        plane.push_back(v);
                }
                // Convert to the plane's own coordinates and let the planar hull order the points.
                const Eigen::Vector3d x = outward.unitOrthogonal(), y = outward.cross(x);
                std::vector<Eigen::Vector3d> flat;
                flat.reserve(plane.size());
                for (const std::size_t v : plane)
                    flat.emplace_back(x.dot(points_[v] - from), y.dot(points_[v] - from), 0.0);
                ConvexHull::Face face{outward, offset, {}};
                for (const Eigen::Vector3d &corner : outlineOf(flat, tolerance_ * tolerance_))
                    face.vertices.push_back(
                        plane[static_cast<std::size_t>(std::find(flat.begin(), flat.end(), corner) - flat.begin())]);
                if (face.vertices.size() >= 3)
                    faces_.push_back(std::move(face));
                planes_.push_back(std::move(plane));
            }

            const std::vector<Eigen::Vector3d> &points_;
            double tolerance_;
            /** The points in the plane of each face, in order */
            std::vector<std::vector<std::size_t>> planes_;
            std::vector<ConvexHull::Face> faces_;
        };

        ConvexHull spatialHull(const std::vector<Eigen::Vector3d> &given, double tolerance)
        {
            const std::vector<Eigen::Vector3d> points = distinct(given, tolerance);
            ConvexHull hull;
            hull.faces = FaceSearch(points, tolerance).run();
            // Keep the points that are corners and renumber them.
            std::vector<std::size_t> newIndex(points.size(), points.size());
            for (auto &face : hull.faces)
                for (auto &vertex : face.vertices)
                {
                    if (newIndex[vertex] == points.size())
                    {
                        newIndex[vertex] = hull.vertices.size();
                        hull.vertices.push_back(points[vertex]);
                    }
                    vertex = newIndex[vertex];
                }
            if (hull.faces.size() < 4)
                throw ompl::Exception("The points of a polytope span no volume");
            return hull;
        }
    }

    double ConvexHull::signedDistance(const Eigen::Vector3d &point) const
    {
        double highest = -std::numeric_limits<double>::infinity();
        // Inlined: clearances among polygons are asked for all the time.
        double squared = std::numeric_limits<double>::infinity();
        for (const Face &face : faces)
        {
            const double height = face.normal.dot(point) - face.offset;
            highest = std::max(highest, height);
            if (height > 0.0 && face.vertices.size() == 2)
            {
                const Eigen::Vector3d &a = vertices[face.vertices[0]], &b = vertices[face.vertices[1]];
                squared = std::min(squared, squaredDistanceToSegment(point - a, b - a));
            }
        }
        if (highest <= 0.0)
            return highest;
        double nearest = std::sqrt(squared);
        for (const Face &face : faces)
            if (face.vertices.size() > 2 && face.normal.dot(point) > face.offset)
                nearest = std::min(nearest, distanceToFace(*this, face, point));
        return nearest;
    }

    ConvexHull convexHull(const std::vector<Eigen::Vector3d> &points, unsigned int dimension)
    {
        if (points.size() < dimension + 1)
            throw ompl::Exception("A convex hull in " + std::to_string(dimension) + " dimensions needs at least " +
                                  std::to_string(dimension + 1) + " points, not " + std::to_string(points.size()));
        if (points.size() > MAX_HULL_POINTS)
            throw ompl::Exception("A convex hull takes at most " + std::to_string(MAX_HULL_POINTS) + " points, not " +
                                  std::to_string(points.size()));
        Eigen::AlignedBox3d box;
        for (const auto &point : points)
        {
            if (!point.allFinite())
                throw ompl::Exception("A convex hull's points must be finite numbers");
            box.extend(point);
        }
        if (dimension == 2)
            return planarHull(points, 1e-12 * box.sizes().head<2>().squaredNorm());
        return spatialHull(points, 1e-10 * box.diagonal().norm());
    }
}
