#include "SphereTreeBuilder.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <limits>

namespace ompl_certificates
{
    namespace
    {
        /** A leaf's ball is at most this fraction of its shape's own ball, ... */
        constexpr double LEAF_RADIUS = 0.125;

        /** ... or no more than this much larger than the rounding of its piece, as a capsule's. */
        constexpr double TIGHT = 1.05;

        constexpr unsigned int MAX_DEPTH = SphereTree::MOST_LEVELS - 2;

        constexpr std::size_t INNER_SPHERES = 8;

        /** The corners of a polygon; most are triangles and their parts */
        using Outline = boost::container::small_vector<Eigen::Vector3d, 6>;

        /** A convex piece of a shape, enlarged by a rounding radius: the outlines of its faces, its one outline in the
            plane, or the two ends of a segment. For a mesh: the outlines of pieces of its triangles. */
        struct Piece
        {
            std::vector<Outline> outlines;
            double rounding;
            bool isSolid{true};

            std::vector<Eigen::Vector3d> vertices() const
            {
                std::vector<Eigen::Vector3d> all;
                all.reserve(4 * outlines.size());
                for (const auto &outline : outlines)
                    all.insert(all.end(), outline.begin(), outline.end());
                return all;
            }
        };

        /** The part of an outline where sign * (p[axis] - position) <= 0; the points on the cut are added to \e cut. */
        Outline clip(const Outline &outline, Eigen::Index axis, double position, double sign, Outline &cut)
        {
            Outline kept;
            for (std::size_t i = 0; i < outline.size(); ++i)
            {
                const Eigen::Vector3d &a = outline[i], &b = outline[(i + 1) % outline.size()];
                const double da = sign * (a[axis] - position), db = sign * (b[axis] - position);
                if (da <= 0.0)
                    kept.push_back(a);
                if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0))
                {
                    Eigen::Vector3d crossing = a + da / (da - db) * (b - a);
                    crossing[axis] = position;
                    kept.push_back(crossing);
                    cut.push_back(crossing);
                }
                else if (da == 0.0)
                    cut.push_back(a);
            }
            return kept;
        }

        /** Sort the corners of a convex polygon, across \e axis, around their mean. */
        void sortAround(Outline &corners, Eigen::Index axis)
        {
            Eigen::Vector3d mean = Eigen::Vector3d::Zero();
            for (const auto &corner : corners)
                mean += corner / static_cast<double>(corners.size());
            const Eigen::Index u = (axis + 1) % 3, v = (axis + 2) % 3;
            const auto angle = [&](const Eigen::Vector3d &p) { return std::atan2(p[v] - mean[v], p[u] - mean[u]); };
            std::sort(corners.begin(), corners.end(),
                      [&](const Eigen::Vector3d &a, const Eigen::Vector3d &b) { return angle(a) < angle(b); });
        }

        Piece halfOf(const Piece &piece, Eigen::Index axis, double position, double sign)
        {
            Piece half{{}, piece.rounding, piece.isSolid};
            half.outlines.reserve(piece.outlines.size());
            Outline cut;
            for (const auto &outline : piece.outlines)
                if (auto kept = clip(outline, axis, position, sign, cut); !kept.empty())
                    half.outlines.push_back(std::move(kept));
            // The new face closes the piece, so that later cuts also find the edges inside the shape.
            if (piece.isSolid && piece.outlines.size() > 1 && cut.size() >= 3)
            {
                sortAround(cut, axis);
                half.outlines.push_back(std::move(cut));
            }
            return half;
        }

        /** A prism of 16 sides around a cylinder: 2 % wider at its corners */
        Piece prismAround(double radius, double length)
        {
            constexpr std::size_t sides = 16;
            const double corner = radius / std::cos(M_PI / sides);
            Piece prism{{{}, {}}, 0.0};
            const auto at = [&](std::size_t i, double z)
            {
                const double angle = 2.0 * M_PI * static_cast<double>(i) / sides;
                return Eigen::Vector3d(corner * std::cos(angle), corner * std::sin(angle), z);
            };
            for (std::size_t i = 0; i < sides; ++i)
            {
                prism.outlines[0].push_back(at(i, -0.5 * length));
                prism.outlines[1].push_back(at(i, 0.5 * length));
            }
            for (std::size_t i = 0; i < sides; ++i)
                prism.outlines.push_back(
                    {at(i, -0.5 * length), at(i + 1, -0.5 * length), at(i + 1, 0.5 * length), at(i, 0.5 * length)});
            return prism;
        }

        Piece trianglesOf(const TriangleMesh &mesh, unsigned int dimension)
        {
            Piece piece{{}, 0.0, false};
            for (std::size_t i = 0; i < mesh.getTriangles().size(); ++i)
            {
                auto [a, b, c] = mesh.getCorners(i);
                if (dimension == 2)
                    a.z() = b.z() = c.z() = 0.0;
                piece.outlines.push_back({a, b, c});
            }
            return piece;
        }

        Piece wholeOf(const Shape &shape)
        {
            switch (shape.getKind())
            {
                case Shape::Kind::BALL:
                    return {{{Eigen::Vector3d::Zero()}}, shape.getRadius()};
                case Shape::Kind::CAPSULE:
                    return {{{-0.5 * shape.getSize(), 0.5 * shape.getSize()}}, shape.getRadius()};
                case Shape::Kind::CYLINDER:
                    return prismAround(shape.getRadius(), shape.getSize().z());
                case Shape::Kind::MESH:
                    return trianglesOf(*shape.getMesh(), shape.getDimension());
                default:
                    break;
            }
            const ConvexHull &hull = *shape.getHull();
            if (shape.getDimension() == 2)
                return {{Outline(hull.vertices.begin(), hull.vertices.end())}, 0.0};
            Piece piece{{}, 0.0};
            for (const auto &face : hull.faces)
            {
                piece.outlines.emplace_back();
                for (const std::size_t vertex : face.vertices)
                    piece.outlines.back().push_back(hull.vertices[vertex]);
            }
            return piece;
        }

        /** The part's pose; without the z of a planar mesh, which its sphere tree ignores */
        Pose treePose(const Body::Part &part)
        {
            Pose pose = part.pose;
            if (part.shape.getDimension() == 2)
                pose.translation().z() = 0.0;
            return pose;
        }

        Ball ballAround(const Piece &piece)
        {
            Ball ball = enclosingBall(piece.vertices(), piece.rounding);
            // Pays for the rounding of the clipping, so that no sliver of the shape is left outside.
            ball.radius *= 1.0 + 1e-12;
            return ball;
        }

        void addChildren(std::vector<SphereTree::Node> &nodes, std::size_t parent, const Piece &piece, double smallest,
                         unsigned int depth)
        {
            const double radius = nodes[parent].ball.radius;
            if (depth == MAX_DEPTH || radius <= smallest || radius <= TIGHT * piece.rounding)
                return;
            Eigen::AlignedBox3d box;
            for (const auto &outline : piece.outlines)
                for (const auto &vertex : outline)
                    box.extend(vertex);
            Eigen::Index axis;
            if (box.sizes().maxCoeff(&axis) <= 0.0)
                return;
            const double middle = box.center()[axis];
            const Piece halves[] = {halfOf(piece, axis, middle, 1.0), halfOf(piece, axis, middle, -1.0)};
            const auto first = static_cast<std::uint32_t>(nodes.size());
            nodes[parent].firstChild = first;
            nodes[parent].childCount = 2;
            for (const Piece &half : halves)
                nodes.push_back({ballAround(half), 0, 0});
            for (std::size_t i = 0; i < 2; ++i)
                addChildren(nodes, first + i, halves[i], smallest, depth + 1);
        }

        /** The tree of one shape, in its own frame */
        std::vector<SphereTree::Node> treeOf(const Piece &piece)
        {
            std::vector<SphereTree::Node> nodes{{ballAround(piece), 0, 0}};
            addChildren(nodes, 0, piece, LEAF_RADIUS * nodes[0].ball.radius, 0);
            return nodes;
        }

        Ball placed(Ball ball, const Pose &pose, bool isSolid)
        {
            ball.center = pose * ball.center;
            if (!isSolid)  // its ball may be a point, far from the origin
                ball.radius += 1e-13 * ball.center.norm();
            return ball;
        }

        /** Put the tree of a part below a node. */
        void addTree(std::vector<SphereTree::Node> &nodes, std::size_t root, const std::vector<SphereTree::Node> &tree,
                     const Pose &pose, bool isSolid)
        {
            const auto shift = static_cast<std::uint32_t>(nodes.size()) - 1;
            for (std::size_t i = 0; i < tree.size(); ++i)
            {
                SphereTree::Node node = tree[i];
                node.ball = placed(node.ball, pose, isSolid);
                if (node.childCount > 0)
                    node.firstChild += shift;
                if (i == 0)
                    nodes[root] = node;
                else
                    nodes.push_back(node);
            }
        }
    }

    SphereTree buildSphereTree(const std::vector<Body::Part> &parts)
    {
        std::vector<Piece> pieces;
        std::vector<std::vector<SphereTree::Node>> trees;
        std::vector<Eigen::Vector3d> extremes;
        double rounding = 0.0;
        for (const auto &part : parts)
        {
            pieces.push_back(wholeOf(part.shape));
            // Many a body has several equal parts, such as wheels and rotors.
            const auto equal = std::find_if(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(trees.size()),
                                            [&](const Body::Part &other) { return other.shape == part.shape; });
            const auto known = static_cast<std::size_t>(equal - parts.begin());
            trees.push_back(known < trees.size() ? trees[known] : treeOf(pieces.back()));
            for (const auto &vertex : pieces.back().vertices())
                extremes.push_back(treePose(part) * vertex);
            rounding = std::max(rounding, pieces.back().rounding);
        }
        std::vector<SphereTree::Node> nodes(1);
        if (parts.size() == 1)
        {
            addTree(nodes, 0, trees[0], treePose(parts[0]), pieces[0].isSolid);
            return SphereTree(std::move(nodes));
        }
        nodes[0].ball = enclosingBall(extremes, rounding);
        nodes[0].firstChild = 1;
        nodes[0].childCount = static_cast<std::uint32_t>(parts.size());
        nodes.resize(1 + parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i)
            addTree(nodes, 1 + i, trees[i], treePose(parts[i]), pieces[i].isSolid);
        return SphereTree(std::move(nodes));
    }

    double signedDistance(const std::vector<Body::Part> &parts, const Eigen::Vector3d &point)
    {
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto &part : parts)
            nearest = std::min(nearest, part.shape.signedDistance(part.pose.inverse() * point));
        return nearest;
    }

    std::vector<Ball> buildInnerSpheres(const std::vector<Body::Part> &parts, const SphereTree &sphereTree)
    {
        std::vector<Ball> candidates;
        const auto addBallAbout = [&](const Eigen::Vector3d &center)
        {
            // Shrunk as the outer balls are enlarged: rounding never makes an inner sphere stick out.
            if (const double depth = -signedDistance(parts, center); depth > 0.0)
                candidates.push_back({center, depth * (1.0 - 1e-12)});
        };
        for (const auto &part : parts)
            if (part.shape.getKind() == Shape::Kind::BALL)
                candidates.push_back({part.pose.translation(), part.shape.getRadius()});
            else if (const ConvexHull *hull = part.shape.getHull())
            {
                // The sphere tree's centers may all lie on the edges of a sliver; the mean of the corners lies inside.
                Eigen::Vector3d mean = Eigen::Vector3d::Zero();
                for (const auto &vertex : hull->vertices)
                    mean += vertex / static_cast<double>(hull->vertices.size());
                addBallAbout(part.pose * mean);
            }
        for (const auto &node : sphereTree.getNodes())
            addBallAbout(node.ball.center);
        std::stable_sort(candidates.begin(), candidates.end(),
                         [](const Ball &a, const Ball &b) { return a.radius > b.radius; });
        std::vector<Ball> innerSpheres;
        for (const Ball &ball : candidates)
        {
            // A ball adds little if an earlier, larger one contains its center.
            const auto holds = [&ball](const Ball &other)
            { return (other.center - ball.center).norm() < 0.5 * other.radius || other.center == ball.center; };
            if (innerSpheres.size() < INNER_SPHERES && std::none_of(innerSpheres.begin(), innerSpheres.end(), holds))
                innerSpheres.push_back(ball);
        }
        return innerSpheres;
    }
}
