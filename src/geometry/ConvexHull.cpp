#include "ompl_certificates/geometry/ConvexHull.h"

#include "TriangleDistance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <libqhullcpp/Qhull.h>
#include <libqhullcpp/QhullError.h>
#include <libqhullcpp/QhullFacetList.h>
#include <libqhullcpp/QhullVertexSet.h>
#include <limits>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        constexpr const char *NO_VOLUME =
            "The points of a polytope span no volume, or it is thinner than 3e-7 of its extent";

        /** Thinner hulls could lack a face: it takes neighbors for points of its plane. Relative to the extent */
        constexpr double THINNEST = 3e-7;

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

        /** The corners of the hull of points of the plane, counter-clockwise, by Andrew's monotone chain, with some
            that are straight up to rounding */
        std::vector<Eigen::Vector3d> monotoneChain(std::vector<Eigen::Vector3d> points)
        {
            std::sort(points.begin(), points.end(),
                      [](const Eigen::Vector3d &a, const Eigen::Vector3d &b)
                      { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
            std::vector<Eigen::Vector3d> chain;
            const auto append = [&chain](const Eigen::Vector3d &point, std::size_t fixed)
            {
                while (chain.size() > fixed && cross2(chain[chain.size() - 2], chain.back(), point) <= 0.0)
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

        /** The corners of the hull of points of the plane, counter-clockwise. Leaves out those that are straight to
            within \e tolerance (an area). Fewer than three if the points span no area. */
        std::vector<Eigen::Vector3d> outlineOf(const std::vector<Eigen::Vector3d> &points, double tolerance)
        {
            const auto isStraight = [tolerance](const auto &before, const auto &corner, const auto &after)
            { return cross2(before, corner, after) <= tolerance; };
            // The chain itself must not use the tolerance. It sorts points by x, so those of an edge that is vertical
            // up to rounding come in any order. The edge's end may then come between two others, and would be left out
            // as straight.
            std::vector<Eigen::Vector3d> corners;
            for (const Eigen::Vector3d &point : monotoneChain(points))
            {
                while (corners.size() > 1 && isStraight(corners[corners.size() - 2], corners.back(), point))
                    corners.pop_back();
                corners.push_back(point);
            }
            while (corners.size() > 2 && isStraight(corners[corners.size() - 2], corners.back(), corners.front()))
                corners.pop_back();
            while (corners.size() > 2 && isStraight(corners.back(), corners[0], corners[1]))
                corners.erase(corners.begin());
            return corners;
        }

        ConvexHull planarHull(std::vector<Eigen::Vector3d> points, double tolerance)
        {
            for (auto &point : points)
                point.z() = 0.0;
            ConvexHull hull;
            hull.vertices = outlineOf(points, tolerance);
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

        using Triple = std::array<std::size_t, 3>;

        /** A triangle of the hull by the numbers of its corners, in order, with Qhull's normal */
        struct HullTriangle
        {
            Triple corners;
            Eigen::Vector3d normal;
        };

        /** The triangles of the hull, in the order of their corners */
        std::vector<HullTriangle> hullTriangles(const std::vector<Eigen::Vector3d> &points)
        {
            // Its precision is that of the largest coordinate.
            std::vector<Eigen::Vector3d> moved;
            moved.reserve(points.size());
            for (const Eigen::Vector3d &point : points)
                moved.push_back(point - points.front());
            std::vector<HullTriangle> triangles;
            orgQhull::Qhull qhull;  // Its other constructor leaks when it throws.
            try
            {
                // Cut into triangles, without warnings
                qhull.runQhull("", 3, static_cast<int>(moved.size()), moved.front().data(), "Qt Pp");
                for (const orgQhull::QhullFacet &facet : qhull.facetList())
                {
                    std::vector<std::size_t> corners;
                    for (const orgQhull::QhullVertex &vertex : facet.vertices())
                        corners.push_back(static_cast<std::size_t>(vertex.point().id()));
                    std::sort(corners.begin(), corners.end());
                    triangles.push_back({{corners.at(0), corners.at(1), corners.at(2)},
                                         Eigen::Map<const Eigen::Vector3d>(facet.hyperplane().coordinates())});
                }
            }
            catch (const orgQhull::QhullError &)
            {
                qhull.clearQhullMessage();  // Its destructor would print it.
                throw ompl::Exception(NO_VOLUME);
            }
            std::sort(triangles.begin(), triangles.end(),
                      [](const HullTriangle &a, const HullTriangle &b) { return a.corners < b.corners; });
            return triangles;
        }

        /** Makes faces of Qhull's triangles. However Qhull cuts a face into triangles, the face comes out the same to
            the last bit: the first three of its points that can tell its normal. */
        class FaceSearch
        {
        public:
            FaceSearch(const std::vector<Eigen::Vector3d> &points, double tolerance)
              : points_(points), tolerance_(tolerance)
            {
                for (const Eigen::Vector3d &point : points)
                    inside_ += point / static_cast<double>(points.size());
            }

            std::vector<ConvexHull::Face> run()
            {
                std::vector<Plane> planes;
                // Triangles that are nearly in one plane are one face.
                const auto isHeld = [&planes](const Triple &triangle) {
                    return std::any_of(planes.begin(), planes.end(),
                                       [&](const Plane &plane) { return holds(plane, triangle); });
                };
                const std::vector<HullTriangle> triangles = hullTriangles(points_);
                for (const auto &[triangle, normal] : triangles)
                    if (const Plane plane = planeOf(triangle); !plane.points.empty() && !isHeld(triangle))
                        planes.push_back(byFirstPoints(plane.points, triangle));
                // Without one at its tip, a wedge would go on beyond it.
                for (const auto &[triangle, normal] : triangles)
                    if (!isHeld(triangle))
                        planes.push_back(supporting(triangle, normal));
                std::sort(planes.begin(), planes.end(),
                          [](const Plane &a, const Plane &b) { return a.points < b.points; });
                std::vector<ConvexHull::Face> faces;
                for (const Plane &plane : planes)
                    if (auto corners = cornersOf(plane); corners.size() >= 3)
                        faces.push_back({plane.normal, plane.offset, std::move(corners)});
                    else if (plane.points.size() == 3)
                        faces.push_back({plane.normal, plane.offset, plane.points});
                return faces;
            }

        private:
            /** A plane with none of the points beyond it, and the numbers of those in it, in order */
            struct Plane
            {
                Eigen::Vector3d normal;
                double offset;
                std::vector<std::size_t> points;
            };

            static bool holds(const Plane &plane, const Triple &three)
            {
                return std::includes(plane.points.begin(), plane.points.end(), three.begin(), three.end());
            }

            /** \return a plane without points if the three are on a line, or points are on both of its sides */
            Plane planeThrough(const Triple &three) const
            {
                const Eigen::Vector3d &from = points_[three[0]], a = points_[three[1]] - from,
                                      b = points_[three[2]] - from;
                const Eigen::Vector3d normal = a.cross(b);
                if (normal.norm() <= tolerance_ * (a.norm() + b.norm()))
                    return {};
                const Eigen::Vector3d outward = (normal.dot(inside_ - from) > 0.0 ? -1.0 : 1.0) * normal.normalized();
                Plane plane{outward, outward.dot(from), {}};
                for (std::size_t v = 0; v < points_.size(); ++v)
                {
                    const double height = outward.dot(points_[v] - from);
                    if (height > tolerance_)
                        return {};
                    if (height >= -tolerance_)
                        plane.points.push_back(v);
                }
                return plane;
            }

            /** The same; of a sliver not all three corners tell its normal. */
            Plane planeOf(const Triple &three) const
            {
                for (const Triple &turned :
                     {three, Triple{three[1], three[2], three[0]}, Triple{three[2], three[0], three[1]}})
                    if (Plane plane = planeThrough(turned); !plane.points.empty())
                        return plane;
                return {};
            }

            /** The plane of a given normal that touches the hull from outside, as the face of a triangle of the hull */
            Plane supporting(const Triple &triangle, const Eigen::Vector3d &normal) const
            {
                double offset = -std::numeric_limits<double>::infinity();
                for (const Eigen::Vector3d &point : points_)
                    offset = std::max(offset, normal.dot(point));
                return {normal, offset, {triangle.begin(), triangle.end()}};
            }

            /** The plane through the first three of \e points that holds \e triangle, which is of them */
            Plane byFirstPoints(const std::vector<std::size_t> &points, const Triple &triangle) const
            {
                for (std::size_t i = 0; i < points.size(); ++i)
                    for (std::size_t j = i + 1; j < points.size(); ++j)
                        for (std::size_t k = j + 1; k < points.size(); ++k)
                            if (Plane plane = planeThrough({points[i], points[j], points[k]}); holds(plane, triangle))
                                return plane;
                return planeOf(triangle);
            }

            /** Converts to the plane's own coordinates and lets the planar hull order the points. */
            std::vector<std::size_t> cornersOf(const Plane &plane) const
            {
                const Eigen::Vector3d &from = points_[plane.points.front()], x = plane.normal.unitOrthogonal(),
                                      y = plane.normal.cross(x);
                std::vector<Eigen::Vector3d> flat;
                for (const std::size_t v : plane.points)
                    flat.emplace_back(x.dot(points_[v] - from), y.dot(points_[v] - from), 0.0);
                std::vector<std::size_t> corners;
                for (const Eigen::Vector3d &corner : outlineOf(flat, tolerance_ * tolerance_))
                    corners.push_back(plane.points[static_cast<std::size_t>(
                        std::find(flat.begin(), flat.end(), corner) - flat.begin())]);
                return corners;
            }

            const std::vector<Eigen::Vector3d> &points_;
            double tolerance_;
            Eigen::Vector3d inside_{Eigen::Vector3d::Zero()};
        };

        ConvexHull spatialHull(const std::vector<Eigen::Vector3d> &given, double extent)
        {
            const double tolerance = 1e-10 * extent;
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
            const auto isThin = [&](const ConvexHull::Face &face)
            {
                return std::all_of(points.begin(), points.end(),
                                   [&](const Eigen::Vector3d &point)
                                   { return face.normal.dot(point) - face.offset > -THINNEST * extent; });
            };
            if (hull.faces.size() < 4 || std::any_of(hull.faces.begin(), hull.faces.end(), isThin))
                throw ompl::Exception(NO_VOLUME);
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
        return spatialHull(points, box.diagonal().norm());
    }
}
