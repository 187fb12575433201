#include "MeshInside.h"

#include "TriangleDistance.h"
#include "Weld.h"
#include "Winding.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <numeric>
#include <utility>

namespace ompl_certificates
{
    namespace
    {
        using Corners = TriangleTree::Corners;

        /** About so many points of a piece's box are tried as centers of balls. */
        constexpr double CANDIDATES = 300.0;

        /** A piece smaller than this share of the largest one is left out. */
        constexpr double LEAST_PIECE = 0.1;

        /** A ball is left out whose center lies within this share of a larger one's radius. */
        constexpr double LEAST_SPACING = 0.6;

        /** Balls are made smaller by this share: so two that overlap do so by more than chance and rounding. */
        constexpr double SHRINKING = 1e-3;

        /** Pays for the rounding of centers in single precision, relative to their coordinates */
        constexpr double CENTER_ROUNDING = 2e-6;

        /** A surface, as indices of its triangles' corners */
        using Surface = std::vector<std::array<std::uint32_t, 3>>;

        /** The triangles that hang together by their corners */
        std::vector<Surface> piecesOf(const Surface &triangles, std::size_t vertexCount)
        {
            std::vector<std::uint32_t> parents(vertexCount);
            std::iota(parents.begin(), parents.end(), 0U);
            const auto rootOf = [&parents](std::uint32_t vertex)
            {
                while (parents[vertex] != vertex)
                    vertex = parents[vertex] = parents[parents[vertex]];
                return vertex;
            };
            for (const auto &[a, b, c] : triangles)
            {
                parents[rootOf(b)] = rootOf(a);
                parents[rootOf(c)] = rootOf(a);
            }
            constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
            std::vector<std::size_t> numbers(vertexCount, none);
            std::vector<Surface> pieces;
            for (const auto &triangle : triangles)
            {
                std::size_t &number = numbers[rootOf(triangle[0])];
                if (number == none)
                {
                    number = pieces.size();
                    pieces.emplace_back();
                }
                pieces[number].push_back(triangle);
            }
            return pieces;
        }

        /** Whether each edge is passed as often in one direction as in the other */
        bool isClosed(const Surface &piece)
        {
            struct Edge
            {
                std::pair<std::uint32_t, std::uint32_t> ends;
                int direction;
            };
            std::vector<Edge> edges;
            edges.reserve(3 * piece.size());
            for (const auto &triangle : piece)
                for (std::size_t i = 0; i < 3; ++i)
                {
                    const std::uint32_t from = triangle[i], to = triangle[(i + 1) % 3];
                    edges.push_back({std::minmax(from, to), from < to ? 1 : -1});
                }
            std::sort(edges.begin(), edges.end(), [](const Edge &a, const Edge &b) { return a.ends < b.ends; });
            int sum = 0;
            for (std::size_t i = 0; i < edges.size(); ++i)
            {
                sum += edges[i].direction;
                const bool isLast = i + 1 == edges.size() || edges[i].ends != edges[i + 1].ends;
                if (isLast && sum != 0)
                    return false;
            }
            return true;
        }

        /** Whether a closed surface winds around a point. Not at points so near to it that rounding matters. */
        bool isInside(const TriangleTree &surface, const Eigen::Vector3d &point)
        {
            double sum = 0.0;
            for (std::uint32_t i = 0; i < surface.size(); ++i)
            {
                const auto &[a, b, c] = surface.getTriangle(i).corners;
                sum += halfSolidAngle(a - point, b - point, c - point);
            }
            const double winding = sum / boost::math::constants::two_pi<double>(), whole = std::round(winding);
            return whole != 0.0 && std::abs(winding - whole) < 0.01;
        }

        /** The ball about \e center, or about a point deeper inside, that just reaches the surface */
        Ball ballFrom(const TriangleTree &surface, Eigen::Vector3d center)
        {
            constexpr double inf = std::numeric_limits<double>::infinity();
            std::uint32_t nearest;
            double radius = surface.distance(center, inf, &nearest);
            double step = 0.5;
            for (int i = 0; i < 8 && radius > 0.0; ++i)
            {
                const auto &[a, b, c] = surface.getTriangle(nearest).corners;
                const Eigen::Vector3d away = (center - nearestOfTriangle(center, a, b, c)) / radius;
                const Eigen::Vector3d moved = center + step * radius * away;
                std::uint32_t other;
                if (const double larger = surface.distance(moved, inf, &other); larger > radius)
                {
                    center = moved;
                    radius = larger;
                    nearest = other;
                }
                else
                    step *= 0.5;
            }
            return {center, radius};
        }

        /** Large balls that just reach the surface, inside of it or not, from the largest to the smallest */
        std::vector<Ball> candidatesIn(const TriangleTree &surface, const Eigen::AlignedBox3d &box)
        {
            const double spacing = std::cbrt(box.volume() / CANDIDATES);
            Eigen::Vector3i counts;
            for (int axis = 0; axis < 3; ++axis)
                counts[axis] = static_cast<int>(std::clamp(std::ceil(box.sizes()[axis] / spacing), 1.0, CANDIDATES));
            std::vector<Ball> balls;
            for (int x = 0; x < counts.x(); ++x)
                for (int y = 0; y < counts.y(); ++y)
                    for (int z = 0; z < counts.z(); ++z)
                    {
                        const Eigen::Array3d at = (Eigen::Array3d(x, y, z) + 0.5) / counts.cast<double>().array();
                        const Ball ball = ballFrom(surface, box.min() + (at * box.sizes().array()).matrix());
                        if (box.contains(ball.center))
                            balls.push_back(ball);
                    }
            std::sort(balls.begin(), balls.end(), [](const Ball &a, const Ball &b) { return a.radius > b.radius; });
            return balls;
        }
    }

    MeshInside::MeshInside(const TriangleTree &tree)
    {
        std::vector<Eigen::Vector3d> vertices;
        vertices.reserve(3 * tree.size());
        for (std::uint32_t i = 0; i < tree.size(); ++i)
            for (const Eigen::Vector3d &corner : tree.getTriangle(i).corners)
                vertices.push_back(corner);
        const std::vector<std::uint32_t> welded = weld(vertices);
        Surface triangles;
        for (std::size_t i = 0; i < vertices.size(); i += 3)
            triangles.push_back({welded[i], welded[i + 1], welded[i + 2]});

        struct Closed
        {
            Surface triangles;
            Eigen::AlignedBox3d box;
        };
        std::vector<Closed> closed;
        for (Surface &piece : piecesOf(triangles, vertices.size()))
        {
            Eigen::AlignedBox3d box;
            for (const auto &triangle : piece)
                for (const std::uint32_t corner : triangle)
                    box.extend(vertices[corner]);
            if (box.volume() > 0.0 && isClosed(piece))
                closed.push_back({std::move(piece), box});
        }
        const auto sizeOf = [](const Closed &piece) { return piece.box.diagonal().norm(); };
        std::sort(closed.begin(), closed.end(),
                  [&](const Closed &a, const Closed &b) { return sizeOf(a) > sizeOf(b); });
        while (closed.size() > MOST_PIECES ||
               (!closed.empty() && sizeOf(closed.back()) < LEAST_PIECE * sizeOf(closed[0])))
            closed.pop_back();

        std::vector<std::pair<Ball, std::size_t>> candidates;
        std::vector<TriangleTree> surfaces(closed.size());
        for (std::size_t i = 0; i < closed.size(); ++i)
        {
            Piece piece{closed[i].box, {}};
            for (const auto &[a, b, c] : closed[i].triangles)
            {
                surfaces[i].add({vertices[a], vertices[b], vertices[c]}, 0);
                for (const std::uint32_t corner : {a, b, c})
                    for (std::size_t axis = 0; axis < 3; ++axis)
                    {
                        const auto k = static_cast<Eigen::Index>(axis);
                        if (vertices[corner][k] == piece.box.min()[k])
                            piece.corners[2 * axis] = vertices[corner];
                        if (vertices[corner][k] == piece.box.max()[k])
                            piece.corners[2 * axis + 1] = vertices[corner];
                    }
            }
            surfaces[i].build();
            pieces_.push_back(piece);
            for (const Ball &ball : candidatesIn(surfaces[i], piece.box))
                candidates.emplace_back(ball, i);
        }
        std::stable_sort(candidates.begin(), candidates.end(),
                         [](const auto &a, const auto &b) { return a.first.radius > b.first.radius; });
        for (const auto &[ball, piece] : candidates)
        {
            const auto isNear = [&center = ball.center](const Ball &other)
            { return (other.center - center).norm() < LEAST_SPACING * other.radius; };
            if (balls_.size() == MOST_BALLS || std::any_of(balls_.begin(), balls_.end(), isNear) ||
                !isInside(surfaces[piece], ball.center))
                continue;
            balls_.push_back({ball.center, ball.radius * (1.0 - SHRINKING)});
            pieceOf_.push_back(piece);
            extent_ = std::max(extent_, ball.center.cwiseAbs().maxCoeff());
        }

        Eigen::AlignedBox3d middle;
        for (const Ball &ball : balls_)
            middle.extend(ball.center);
        around_.center = middle.center();
        for (const Ball &ball : balls_)
            around_.radius = std::max(around_.radius, (ball.center - around_.center).norm() + ball.radius);

        fours_.resize((balls_.size() + 3) / 4);
        for (std::size_t i = 0; i < 4 * fours_.size(); ++i)
        {
            FourBalls &four = fours_[i / 4];
            for (int axis = 0; axis < 3; ++axis)
                four.center[axis][i % 4] = i < balls_.size() ? static_cast<float>(balls_[i].center[axis]) : 0.0F;
            four.radius[i % 4] = i < balls_.size() ? static_cast<float>(balls_[i].radius) : -INFINITY;
        }
    }

    bool MeshInside::reachesOutOf(const Piece &piece, const Pose &pose, const Eigen::AlignedBox3d &box, double margin)
    {
        return std::any_of(piece.corners.begin(), piece.corners.end(),
                           [&](const Eigen::Vector3d &corner)
                           { return box.squaredExteriorDistance(pose * corner) > margin * margin; });
    }

    bool MeshInside::touches(const MeshInside &other, const Pose &pose, double margin) const
    {
        const double slack =
            margin + CENTER_ROUNDING * (extent_ + other.extent_ + pose.translation().cwiseAbs().maxCoeff());
        for (std::size_t k = 0; k < other.balls_.size(); ++k)
        {
            const Eigen::Vector3d place = pose * other.balls_[k].center;
            const double reachOfAll = around_.radius + other.balls_[k].radius;
            if (!((place - around_.center).squaredNorm() < reachOfAll * reachOfAll))
                continue;
            const Eigen::Vector3f center = place.cast<float>();
            const auto radius = static_cast<float>(other.balls_[k].radius - slack);
            for (std::size_t four = 0; four < fours_.size(); ++four)
            {
                const FourFloats x = fours_[four].center[0] - center.x(), y = fours_[four].center[1] - center.y(),
                                 z = fours_[four].center[2] - center.z(), reach = fours_[four].radius + radius;
                const FourFloats squared = x * x + y * y + z * z;
                const FourInts overlaps = (reach > 0.0F) & (squared < reach * reach);
                if ((overlaps[0] | overlaps[1] | overlaps[2] | overlaps[3]) == 0)
                    continue;
                for (std::size_t i = 0; i < 4; ++i)
                {
                    if (overlaps[static_cast<int>(i)] == 0)
                        continue;
                    const Piece &here = pieces_[pieceOf_[4 * four + i]], &there = other.pieces_[other.pieceOf_[k]];
                    if (reachesOutOf(there, pose, here.box, slack) &&
                        reachesOutOf(here, pose.inverse(), there.box, slack))
                        return true;
                }
            }
        }
        return false;
    }
}
