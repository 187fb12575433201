#include "SphereTreeBuilder.h"

#include <algorithm>
#include <array>
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

        /** A convex piece of a shape, enlarged by a rounding radius: the outlines of its faces, its one outline in the
            plane, or the two ends of a segment. For a mesh: the outlines of pieces of its triangles. */
        struct Piece
        {
            template <typename Outline>
            void add(const Outline &outline)
            {
                corners.insert(corners.end(), std::begin(outline), std::end(outline));
                ends.push_back(corners.size());
            }

            /** The corners of all outlines, one outline after the other */
            std::vector<Eigen::Vector3d> corners;

            /** Where each outline ends among the corners */
            std::vector<std::size_t> ends;
            double rounding{0.0};
            bool isSolid{true};
        };

        /** Append to \e kept the part of an outline where sign * (p[axis] - position) <= 0, and the points on the cut to
            \e cut. */
        void clip(const Eigen::Vector3d *outline, std::size_t count, Eigen::Index axis, double position, double sign,
                  std::vector<Eigen::Vector3d> &kept, std::vector<Eigen::Vector3d> &cut)
        {
            for (std::size_t i = 0; i < count; ++i)
            {
                const Eigen::Vector3d &a = outline[i], &b = outline[i + 1 < count ? i + 1 : 0];
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
        }

        /** Sort the corners of a convex polygon, across \e axis, around their mean. */
        void sortAround(std::vector<Eigen::Vector3d> &corners, Eigen::Index axis)
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
            Piece half;
            half.rounding = piece.rounding;
            half.isSolid = piece.isSolid;
            half.corners.reserve(piece.corners.size());
            half.ends.reserve(piece.ends.size());
            std::vector<Eigen::Vector3d> cut;
            std::size_t begin = 0;
            for (const std::size_t end : piece.ends)
            {
                clip(&piece.corners[begin], end - begin, axis, position, sign, half.corners, cut);
                if (half.corners.size() > (half.ends.empty() ? 0 : half.ends.back()))
                    half.ends.push_back(half.corners.size());
                begin = end;
            }
            // The new face closes the piece, so that later cuts also find the edges inside the shape.
            if (piece.isSolid && piece.ends.size() > 1 && cut.size() >= 3)
            {
                sortAround(cut, axis);
                half.add(cut);
            }
            return half;
        }

        /** A prism of 16 sides around a cylinder: 2 % wider at its corners */
        Piece prismAround(double radius, double length)
        {
            constexpr std::size_t sides = 16;
            const double corner = radius / std::cos(M_PI / sides);
            Piece prism;
            std::array<Eigen::Vector3d, sides> bottom, top;
            for (std::size_t i = 0; i < sides; ++i)
            {
                const double angle = 2.0 * M_PI * static_cast<double>(i) / sides;
                bottom[i] = {corner * std::cos(angle), corner * std::sin(angle), -0.5 * length};
                top[i] = {bottom[i].x(), bottom[i].y(), 0.5 * length};
            }
            prism.add(bottom);
            prism.add(top);
            for (std::size_t i = 0; i < sides; ++i)
            {
                const std::size_t next = (i + 1) % sides;
                prism.add(std::array<Eigen::Vector3d, 4>{bottom[i], bottom[next], top[next], top[i]});
            }
            return prism;
        }

        Piece trianglesOf(const TriangleMesh &mesh, unsigned int dimension)
        {
            Piece piece;
            piece.isSolid = false;
            piece.corners.reserve(3 * mesh.getTriangles().size());
            piece.ends.reserve(mesh.getTriangles().size());
            for (std::size_t i = 0; i < mesh.getTriangles().size(); ++i)
            {
                std::array<Eigen::Vector3d, 3> corners = mesh.getCorners(i);
                for (Eigen::Vector3d &corner : corners)
                    if (dimension == 2)
                        corner.z() = 0.0;
                piece.add(corners);
            }
            return piece;
        }

        Piece wholeOf(const Shape &shape)
        {
            using Corners = std::vector<Eigen::Vector3d>;
            Piece piece;
            switch (shape.getKind())
            {
                case Shape::Kind::BALL:
                    piece.rounding = shape.getRadius();
                    piece.add(Corners{Eigen::Vector3d::Zero()});
                    return piece;
                case Shape::Kind::CAPSULE:
                    piece.rounding = shape.getRadius();
                    piece.add(Corners{-0.5 * shape.getSize(), 0.5 * shape.getSize()});
                    return piece;
                case Shape::Kind::CYLINDER:
                    return prismAround(shape.getRadius(), shape.getSize().z());
                case Shape::Kind::MESH:
                    return trianglesOf(*shape.getMesh(), shape.getDimension());
                default:
                    break;
            }
            const ConvexHull &hull = *shape.getHull();
            if (shape.getDimension() == 2)
            {
                piece.add(hull.vertices);
                return piece;
            }
            for (const auto &face : hull.faces)
            {
                Corners outline;
                for (const std::size_t vertex : face.vertices)
                    outline.push_back(hull.vertices[vertex]);
                piece.add(outline);
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
            Ball ball = enclosingBall(piece.corners, piece.rounding);
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
            for (const auto &corner : piece.corners)
                box.extend(corner);
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
            for (const auto &corner : pieces.back().corners)
                extremes.push_back(treePose(part) * corner);
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
