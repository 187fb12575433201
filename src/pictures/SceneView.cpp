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

        Eigen::Matrix3d axesOf(SceneView::From from)
        {
            // How far the viewer has turned to the side where x is large, and how high above the ground
            const double turn = from == SceneView::From::OBLIQUE ? 0.5 : 0.0,
                         rise = from == SceneView::From::OBLIQUE ? 0.6
                                : from == SceneView::From::SIDE  ? 0.0
                                                                 : boost::math::constants::half_pi<double>();
            Eigen::Matrix3d axes;
            axes.row(0) << std::cos(turn), std::sin(turn), 0.0;
            axes.row(2) << std::cos(rise) * std::sin(turn), -std::cos(rise) * std::cos(turn), std::sin(rise);
            // Exact where the view is along an axis
            if (from == SceneView::From::ABOVE)
                axes.row(2) = Eigen::RowVector3d::UnitZ();
            axes.row(1) = axes.row(2).cross(axes.row(0));
            return axes;
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

    void SceneView::addFaces(const Eigen::AlignedBox3d &box, std::vector<std::array<Eigen::Vector3d, 3>> &seen) const
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            // Of two opposite faces one looks at the viewer.
            Eigen::Vector3d corner = axes_(2, axis) > 0.0 ? box.max() : box.min();
            const int next = (axis + 1) % 3, last = (axis + 2) % 3;
            std::array<Eigen::Vector3d, 4> corners;
            for (std::size_t i = 0; i < corners.size(); ++i)
            {
                corner[next] = i == 0 || i == 3 ? box.min()[next] : box.max()[next];
                corner[last] = i < 2 ? box.min()[last] : box.max()[last];
                corners[i] = see(corner);
            }
            seen.push_back({corners[0], corners[1], corners[2]});
            seen.push_back({corners[0], corners[2], corners[3]});
        }
    }

    SceneView::SceneView(const ompl::base::RealVectorBounds &bounds, From from, const Eigen::Vector2d &corner,
                         double scale)
      : from_(from), bounds_(bounds), axes_(axesOf(from)), corner_(corner), scale_(scale)
    {
        Eigen::AlignedBox2d box;
        for (const Eigen::Vector3d &point : cornersOf(0.0))
            box.extend((axes_ * point).head<2>().eval());
        left_ = box.min().x();
        top_ = box.max().y();
        size_ = scale * box.sizes();
    }

    std::array<Eigen::Vector3d, 8> SceneView::cornersOf(double edge) const
    {
        std::array<Eigen::Vector3d, 8> corners;
        for (std::size_t i = 0; i < corners.size(); ++i)
        {
            corners[i].setZero();
            for (std::size_t axis = 0; axis < bounds_.low.size(); ++axis)
                corners[i][static_cast<Eigen::Index>(axis)] =
                    (i >> axis & 1U) != 0 ? bounds_.high[axis] + edge / scale_ : bounds_.low[axis] - edge / scale_;
        }
        return corners;
    }

    std::vector<Eigen::Vector2d> SceneView::getFrame(double edge) const
    {
        std::vector<Eigen::Vector3d> points;
        for (const Eigen::Vector3d &corner : cornersOf(edge))
        {
            const Eigen::Vector2d seen = project(corner);
            points.emplace_back(seen.x(), seen.y(), 0.0);
        }
        std::vector<Eigen::Vector2d> frame;
        for (const Eigen::Vector3d &corner : convexHull(points, 2).vertices)
            frame.emplace_back(corner.x(), corner.y());
        return frame;
    }

    std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> SceneView::getEdges() const
    {
        const auto corners = cornersOf(0.0);
        std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> edges;
        for (std::size_t axis = 0; axis < bounds_.low.size(); ++axis)
            for (std::size_t i = 0; i < corners.size() >> (3U - bounds_.low.size()); ++i)
                if ((i >> axis & 1U) == 0)
                    edges.emplace_back(project(corners[i]), project(corners[i | std::size_t(1) << axis]));
        return edges;
    }

    Eigen::Vector2d SceneView::project(const Eigen::Vector3d &point) const
    {
        return corner_ + scale_ * Eigen::Vector2d(axes_.row(0).dot(point) - left_, top_ - axes_.row(1).dot(point));
    }

    Eigen::Vector3d SceneView::see(const Eigen::Vector3d &point) const
    {
        const Eigen::Vector2d seen = project(point);
        return {seen.x(), seen.y(), axes_.row(2).dot(point)};
    }

    SceneView SceneView::aroundOrigin(double radius) const
    {
        ompl::base::RealVectorBounds bounds(3);
        bounds.setLow(-radius);
        bounds.setHigh(radius);
        SceneView view(bounds, from_, Eigen::Vector2d::Zero(), scale_);
        view.corner_ = -view.project(Eigen::Vector3d::Zero());
        // What turns is drawn a hundred times.
        view.mostCells_ = 500.0;
        return view;
    }

    std::vector<std::vector<MeshOutline::Loop>> SceneView::outlinesOf(const TriangleMesh &mesh, const Pose &pose,
                                                                      const ZInterval &zInterval, int levels) const
    {
        std::vector<Eigen::Vector3d> vertices;
        for (const Eigen::Vector3d &vertex : mesh.getVertices())
            vertices.push_back(see(pose * vertex));
        std::vector<std::array<Eigen::Vector3d, 3>> seen;
        for (const TriangleMesh::Triangle &triangle : mesh.getTriangles())
        {
            const auto [lowest, highest] =
                std::minmax({mesh.getVertices()[triangle[0]].z(), mesh.getVertices()[triangle[1]].z(),
                             mesh.getVertices()[triangle[2]].z()});
            if (lowest <= zInterval.high && highest >= zInterval.low)
                seen.push_back({vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]});
        }
        return outlinesOf(seen, levels);
    }

    std::vector<std::vector<MeshOutline::Loop>>
    SceneView::outlinesOf(const std::vector<std::array<Eigen::Vector3d, 3>> &seen, int levels) const
    {
        Eigen::AlignedBox3d box;
        for (const auto &triangle : seen)
            for (const Eigen::Vector3d &corner : triangle)
                box.extend(corner);
        // Slightly more than can be seen, so that the edges are not
        const Eigen::Vector2d edge(8.0, 8.0);
        if (seen.empty())
            return {};
        const Eigen::Vector2d low = box.min().head<2>().cwiseMax(corner_ - edge) - 0.1 * edge,
                              high = box.max().head<2>().cwiseMin(corner_ + size_ + edge) + 0.1 * edge;
        if ((high - low).minCoeff() <= 0.0)
            return {};
        const double extent = (high - low).maxCoeff();
        MeshOutline outline(low, high, std::max(extent > 150.0 ? 0.5 : 0.25, extent / mostCells_));
        for (const auto &triangle : seen)
            outline.add(triangle);
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
                if (round)
                    addCircle(center, radius * axes_.row(0), radius * axes_.row(1), points);
                else
                    addCircle(center, radius * pose.linear().col(0), radius * pose.linear().col(1), points);
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
                drawLevels(svg, outlinesOf(*mesh, partPose, zInterval, levels));
            else
                svg.polygon(outlineOf(part.shape, partPose));
        }
    }

    void SceneView::drawLevels(SvgWriter &svg, const std::vector<std::vector<MeshOutline::Loop>> &outlines)
    {
        std::string attributes;
        for (const auto &outline : outlines)
        {
            svg.area(outline, attributes);
            attributes = "fill-opacity='0.1' stroke-width='0.3'";
        }
    }

    void SceneView::draw(SvgWriter &svg, const CellObstacles &cells, int levels) const
    {
        if (from_ == From::OBLIQUE)
        {
            std::vector<std::array<Eigen::Vector3d, 3>> seen;
            for (ObstaclePart part = 0; part < cells.size(); ++part)
                addFaces(cells.getBounds(part), seen);
            return drawLevels(svg, outlinesOf(seen, levels));
        }
        const int up = from_ == From::ABOVE ? 1 : 2;
        // Edges of cells, which are smaller than what they are parts of, would hide them.
        std::string attributes = "stroke='none'";
        for (const auto &rectangles : cellOutlines(cells, up, FINEST_CELL / scale_, levels))
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
