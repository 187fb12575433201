#include "MeshSurface.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** The part of a triangle between two values of z */
        std::vector<Eigen::Vector3d> between(const TriangleTree::Corners &triangle, double low, double high)
        {
            std::vector<Eigen::Vector3d> outline(triangle.begin(), triangle.end());
            for (const double sign : {1.0, -1.0})
            {
                const double bound = sign > 0.0 ? low : -high;
                std::vector<Eigen::Vector3d> kept;
                for (std::size_t i = 0; i < outline.size(); ++i)
                {
                    const Eigen::Vector3d &a = outline[i], &b = outline[(i + 1) % outline.size()];
                    const double za = sign * a.z(), zb = sign * b.z();
                    if (za >= bound)
                        kept.push_back(a);
                    if ((za < bound) != (zb < bound))
                        kept.push_back(a + (bound - za) / (zb - za) * (b - a));
                }
                outline = std::move(kept);
            }
            return outline;
        }

        template <typename Points>
        Eigen::AlignedBox3d boxOf(const Points &points)
        {
            Eigen::AlignedBox3d box;
            for (const Eigen::Vector3d &point : points)
                box.extend(point);
            return box;
        }

        /** The ends of points on a line. Along the shorter side of their box rounding may put inner ones first. */
        std::pair<Eigen::Vector3d, Eigen::Vector3d> endsOf(const std::vector<Eigen::Vector3d> &points)
        {
            Eigen::Index along;
            boxOf(points).sizes().maxCoeff(&along);
            const auto [first, last] = std::minmax_element(points.begin(), points.end(),
                                                           [along](const Eigen::Vector3d &a, const Eigen::Vector3d &b)
                                                           { return a[along] < b[along]; });
            return {*first, *last};
        }

        void addTriangles(const TriangleMesh &mesh, const Pose &pose, TriangleTree &triangles)
        {
            for (std::size_t i = 0; i < mesh.getTriangles().size(); ++i)
            {
                if (mesh.isDegenerate(i))
                    continue;
                const auto [a, b, c] = mesh.getCorners(i);
                triangles.add({pose * a, pose * b, pose * c}, 0);
            }
        }

        std::shared_ptr<const TriangleTree> trianglesOf(const PlacedShapes &obstacles)
        {
            const auto first = std::find_if(obstacles.begin(), obstacles.end(), isMesh);
            if (first != obstacles.end() && std::none_of(first + 1, obstacles.end(), isMesh) &&
                first->pose.matrix() == Pose::Identity().matrix())
            {
                const auto shape = std::make_shared<const Shape>(first->shape);  // keeps the mesh
                return {shape, &shape->getMesh()->getTree()};
            }
            auto triangles = std::make_shared<TriangleTree>();
            for (const auto &[shape, pose] : obstacles)
                if (const TriangleMesh *mesh = shape.getMesh())
                    addTriangles(*mesh, pose, *triangles);
            triangles->build();
            return triangles;
        }
    }

    MeshSurface::MeshSurface(const PlacedShapes &obstacles, unsigned int dimension, const ZInterval &zInterval)
      : isPlanar_(dimension == 2), triangles_(trianglesOf(obstacles))
    {
        if (isPlanar_ && !isEmpty())
            project(zInterval);
    }

    void MeshSurface::project(const ZInterval &robotZInterval)
    {
        const Eigen::AlignedBox3d bounds = triangles_->getBounds();
        const double size = bounds.sizes().maxCoeff();
        // Prisms are slightly higher than what is cut off below.
        const double higher = 2.0 * EXACT_CHECK_TOLERANCE * size;
        zInterval_ = ZInterval{robotZInterval.low - higher, robotZInterval.high + higher}.intersectedWith(
            {bounds.min().z() - 0.05 * size, bounds.max().z() + 0.05 * size});
        const double height = robotZInterval.high - robotZInterval.low;
        for (std::uint32_t i = 0; i < triangles_->size(); ++i)
        {
            const auto &corners = triangles_->getTriangle(i).corners;
            // Slightly more than the robots' z-interval, so that rounding leaves nothing out. How much must not depend
            // on other triangles: certificates of this one would not be true when others come or go.
            const Eigen::AlignedBox3d box = boxOf(corners);
            const double slack =
                EXACT_CHECK_TOLERANCE * std::max(box.sizes().maxCoeff(), std::isfinite(height) ? height : 0.0);
            std::vector<Eigen::Vector3d> outline =
                between(corners, robotZInterval.low - slack, robotZInterval.high + slack);
            for (auto &corner : outline)
                corner.z() = 0.0;
            if (outline.empty())
                continue;
            // Seen from above, an upright triangle is a segment.
            if (triangles_->getTriangle(i).normal.z() == 0.0)
            {
                const auto [first, last] = endsOf(outline);
                outlines_.add({first, last, last}, i);
            }
            else
                for (std::size_t k = 1; k == 1 || k + 1 < outline.size(); ++k)
                    outlines_.add({outline[0], outline[k % outline.size()], outline[(k + 1) % outline.size()]}, i);
        }
        outlines_.build();
    }

    double MeshSurface::findNearest(const Eigen::Vector3d &point, double most, ObstaclePart &part) const
    {
        std::uint32_t nearest;
        const double distance = near().distance(point, most, &nearest);
        part = nearest == TriangleTree::NONE ? NO_PART : isPlanar_ ? outlines_.getName(nearest) : nearest;
        return distance;
    }
}
