#include "SceneView.h"

#include "CellOutline.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** The number of points of a circle; a whole outline has at most two circles */
        constexpr int CIRCLE_POINTS = 64;

        /** The least width, in pixels, at which cells are drawn one by one */
        constexpr double FINEST_CELL = 1.5;

        /** The radius of a round shape; a point would be invisible */
        double radiusOf(const Shape &shape, double scale)
        {
            return std::max(shape.getRadius(), shape.getKind() == Shape::Kind::BALL ? 1.5 / scale : 0.0);
        }

        /** Points of a circle about \e center in the plane of \e x and \e y, whose length is its radius */
        void addCircle(const Eigen::Vector3d &center, const Eigen::Vector3d &x, const Eigen::Vector3d &y,
                       std::vector<Eigen::Vector3d> &points)
        {
            for (int i = 0; i < CIRCLE_POINTS; ++i)
            {
                const double angle = i * boost::math::constants::two_pi<double>() / CIRCLE_POINTS;
                points.emplace_back(center + std::cos(angle) * x + std::sin(angle) * y);
            }
        }
    }

    SceneView::SceneView(const ompl::base::RealVectorBounds &bounds, int up, const Eigen::Vector2d &corner,
                         double scale)
      : up_(up)
      , left_(bounds.low[0])
      , top_(bounds.high[static_cast<std::size_t>(up)])
      , corner_(corner)
      , scale_(scale)
      , size_(scale * (bounds.high[0] - bounds.low[0]), scale * (top_ - bounds.low[static_cast<std::size_t>(up)]))
    {
    }

    Eigen::Vector2d SceneView::project(const Eigen::Vector3d &point) const
    {
        return corner_ + scale_ * Eigen::Vector2d(point.x() - left_, top_ - point[up_]);
    }

    SceneView SceneView::aroundOrigin(double radius) const
    {
        ompl::base::RealVectorBounds bounds(3);
        bounds.setLow(-radius);
        bounds.setHigh(radius);
        return SceneView(bounds, up_, Eigen::Vector2d::Constant(-scale_ * radius), scale_);
    }

    std::vector<std::vector<MeshOutline::Loop>> SceneView::outlinesOf(const TriangleMesh &mesh, const Pose &pose,
                                                                      const ZInterval &zInterval, int levels) const
    {
        // From above the higher is nearer, from the side what has the smaller y.
        const int depth = 3 - up_;
        const double sign = depth == 2 ? 1.0 : -1.0;
        std::vector<Eigen::Vector3d> seen;
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d &vertex : mesh.getVertices())
        {
            const Eigen::Vector3d point = pose * vertex;
            seen.emplace_back();
            seen.back() << project(point), sign * point[depth];
        }
        for (const TriangleMesh::Triangle &triangle : mesh.getTriangles())
            for (const std::uint32_t corner : triangle)
                box.extend(seen[corner]);
        // Slightly more than can be seen, so that the edges are not
        const Eigen::Vector2d edge(8.0, 8.0), low = box.min().head<2>().cwiseMax(corner_ - edge) - 0.1 * edge,
                                              high = box.max().head<2>().cwiseMin(corner_ + size_ + edge) + 0.1 * edge;
        if ((high - low).minCoeff() <= 0.0)
            return {};
        MeshOutline outline(low, high, (high - low).maxCoeff() > 150.0 ? 0.5 : 0.25);
        for (const TriangleMesh::Triangle &triangle : mesh.getTriangles())
        {
            const std::array<Eigen::Vector3d, 3> corners{seen[triangle[0]], seen[triangle[1]], seen[triangle[2]]};
            const auto [lowest, highest] =
                std::minmax({mesh.getVertices()[triangle[0]].z(), mesh.getVertices()[triangle[1]].z(),
                             mesh.getVertices()[triangle[2]].z()});
            if (lowest <= zInterval.high && highest >= zInterval.low)
                outline.add(corners);
        }
        std::vector<std::vector<MeshOutline::Loop>> outlines;
        outlines.reserve(static_cast<std::size_t>(levels));
        for (int level = 0; level < levels; ++level)
            outlines.push_back(
                outline.trace(box.min().z() + box.sizes().z() * level / levels - (level == 0 ? 1.0 : 0.0)));
        return outlines;
    }

    MeshOutline::Loop SceneView::outlineOf(const Shape &shape, const Pose &pose) const
    {
        std::vector<Eigen::Vector3d> points;
        const double radius = radiusOf(shape, scale_);
        if (const ConvexHull *hull = shape.getHull())
            for (const Eigen::Vector3d &vertex : hull->vertices)
                points.push_back(pose * vertex);
        else
            for (const double end : {-0.5, 0.5})
            {
                const Eigen::Vector3d center = pose * Eigen::Vector3d(0.0, 0.0, end * shape.getSize().z());
                // The ends of a capsule appear as circles, those of a cylinder as its rims.
                const bool round = shape.getKind() != Shape::Kind::CYLINDER;
                const Eigen::Matrix3d frame = round ? Eigen::Matrix3d::Identity() : Eigen::Matrix3d(pose.linear());
                addCircle(center, radius * frame.col(0), radius * frame.col(round ? up_ : 1), points);
            }
        for (Eigen::Vector3d &point : points)
        {
            const Eigen::Vector2d seen = project(point);
            point = {seen.x(), seen.y(), 0.0};
        }
        MeshOutline::Loop outline;
        for (const Eigen::Vector3d &corner : convexHull(points, 2).vertices)
            outline.emplace_back(corner.x(), corner.y());
        return outline;
    }

    std::vector<MeshOutline::Loop> SceneView::outlineOf(const Body::Part &part, const Pose &pose) const
    {
        const Pose partPose = pose * part.pose;
        if (const TriangleMesh *mesh = part.shape.getMesh())
        {
            const auto outlines = outlinesOf(*mesh, partPose, ZInterval(), 1);
            return outlines.empty() ? std::vector<MeshOutline::Loop>() : outlines.front();
        }
        return {outlineOf(part.shape, partPose)};
    }

    void SceneView::draw(SvgWriter &svg, const Body &body, const Pose &pose, const ZInterval &zInterval,
                         int levels) const
    {
        for (const Body::Part &part : body.getParts())
        {
            const Pose partPose = pose * part.pose;
            if (part.shape.getKind() == Shape::Kind::BALL)
                svg.circle(project(partPose.translation()), scale_ * radiusOf(part.shape, scale_));
            else if (const TriangleMesh *mesh = part.shape.getMesh())
            {
                std::string attributes;
                for (const auto &outline : outlinesOf(*mesh, partPose, zInterval, levels))
                {
                    svg.area(outline, attributes);
                    attributes = "fill-opacity='0.1' stroke-width='0.3'";
                }
            }
            else
                svg.polygon(outlineOf(part.shape, partPose));
        }
    }

    void SceneView::draw(SvgWriter &svg, const CellObstacles &cells, int levels) const
    {
        // Edges of cells, which are smaller than what they are parts of, would hide them.
        std::string attributes = "stroke='none'";
        for (const auto &rectangles : cellOutlines(cells, up_, FINEST_CELL / scale_, levels))
        {
            std::vector<MeshOutline::Loop> loops;
            for (const Eigen::AlignedBox3d &rectangle : rectangles)
            {
                const Eigen::Vector2d a = project(rectangle.min()), b = project(rectangle.max());
                loops.push_back({a, {b.x(), a.y()}, b, {a.x(), b.y()}});
            }
            svg.area(loops, attributes);
            attributes = "stroke='none' fill-opacity='0.15'";
        }
    }
}
