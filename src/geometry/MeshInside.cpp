#include "MeshInside.h"

#include "ClosedPieces.h"
#include "TriangleDistance.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** Larger meshes have no balls: they would take seconds. */
        constexpr std::size_t LARGEST_MESH = 100000;

        /** About so many points of a piece's box are tried as centers of balls. */
        constexpr double CANDIDATES = 300.0;

        /** How many triangles of a piece are looked at, to tell which candidates are inside: some 0.4 s */
        constexpr std::size_t MOST_WINDINGS = 10000000;

        /** A piece smaller than this share of the largest one is left out. */
        constexpr double LEAST_PIECE = 0.1;

        /** A ball is left out whose center lies within this share of a larger one's radius. */
        constexpr double LEAST_SPACING = 0.6;

        /** Balls are made smaller by this share: so two that overlap do so by more than chance and rounding. */
        constexpr double SHRINKING = 1e-3;

        /** Pays for the rounding of centers in single precision, relative to their coordinates */
        constexpr double CENTER_ROUNDING = 2e-6;

        /** A ball and the number of its piece */
        struct Candidate
        {
            Ball ball;
            std::size_t piece;
        };

        /** Positive if the triangles of a closed surface look outwards, negative if inwards */
        double orientationOf(const TriangleTree &surface, const Eigen::Vector3d &middle)
        {
            double volume = 0.0;
            for (std::uint32_t i = 0; i < surface.size(); ++i)
            {
                const auto &[a, b, c] = surface.getTriangle(i).corners;
                volume += (a - middle).dot((b - middle).cross(c - middle));
            }
            return volume;
        }

        Eigen::Vector3d nearestOf(const TriangleTree &surface, std::uint32_t triangle, const Eigen::Vector3d &point)
        {
            const auto &[a, b, c] = surface.getTriangle(triangle).corners;
            return nearestOfTriangle(point, a, b, c);
        }

        /** The distance from \e point to the surface
            \param nearest a triangle that is probably near, which bounds the search; set to the nearest one */
        double distanceTo(const TriangleTree &surface, const Eigen::Vector3d &point, std::uint32_t &nearest)
        {
            const double known = (point - nearestOf(surface, nearest, point)).norm();
            std::uint32_t other;
            const double distance = surface.distance(point, known, &other);
            if (distance >= known)
                return known;
            nearest = other;
            return distance;
        }

        /** Whether the nearest triangle looks away from \e point: then the point is mostly inside. */
        bool isBehind(const TriangleTree &surface, std::uint32_t nearest, const Eigen::Vector3d &point,
                      double orientation)
        {
            const auto &[a, b, c] = surface.getTriangle(nearest).corners;
            return orientation * (b - a).cross(c - a).dot(point - a) < 0.0;
        }

        /** The ball about \e center, or about a point deeper inside, that just reaches the surface
            \param nearest a triangle that is probably near; set to one that the ball reaches */
        Ball ballFrom(const TriangleTree &surface, Eigen::Vector3d center, std::uint32_t &nearest)
        {
            double radius = distanceTo(surface, center, nearest);
            double step = 0.5;
            for (int i = 0; i < 8 && radius > 0.0; ++i)
            {
                const Eigen::Vector3d away = (center - nearestOf(surface, nearest, center)) / radius;
                const Eigen::Vector3d moved = center + step * radius * away;
                std::uint32_t other = nearest;
                if (const double larger = distanceTo(surface, moved, other); larger > radius)
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

        /** How many candidates there are along each axis of a box: some CANDIDATES in all, about evenly apart */
        Eigen::Array3i countsIn(const Eigen::Array3d &sizes)
        {
            Eigen::Array3d counts = (sizes / std::cbrt(sizes.prod() / CANDIDATES)).ceil().max(1.0).min(CANDIDATES);
            // In a flat box there is one layer of them, which would have many more.
            while (counts.prod() > 3.0 * CANDIDATES)
            {
                Eigen::Index largest = 0;
                counts.maxCoeff(&largest);
                counts[largest] = std::ceil(0.5 * counts[largest]);
            }
            return counts.cast<int>();
        }

        /** Large balls that just reach the surface, mostly from inside, from the largest to the smallest */
        std::vector<Ball> candidatesIn(const TriangleTree &surface, const Eigen::AlignedBox3d &box)
        {
            const double orientation = orientationOf(surface, box.center());
            const Eigen::Array3i counts = countsIn(box.sizes());
            std::vector<Ball> balls;
            std::uint32_t nearest = 0;  // kept from one candidate to the next, which is beside it
            for (int x = 0; x < counts.x(); ++x)
                for (int y = 0; y < counts.y(); ++y)
                    for (int z = 0; z < counts.z(); ++z)
                    {
                        const Eigen::Array3d at = (Eigen::Array3d(x, y, z) + 0.5) / counts.cast<double>();
                        const Eigen::Vector3d start = box.min() + (at * box.sizes().array()).matrix();
                        distanceTo(surface, start, nearest);
                        if (!isBehind(surface, nearest, start, orientation))
                            continue;
                        // The largest ones may fill holes. Their nearest triangle looks at them.
                        const Ball ball = ballFrom(surface, start, nearest);
                        if (box.contains(ball.center) && isBehind(surface, nearest, ball.center, orientation))
                            balls.push_back(ball);
                    }
            std::sort(balls.begin(), balls.end(), [](const Ball &a, const Ball &b) { return a.radius > b.radius; });
            return balls;
        }
    }

    MeshInside::MeshInside(const TriangleTree &tree)
    {
        if (tree.size() > LARGEST_MESH)
            return;
        std::vector<ClosedPiece> closed = closedPiecesOf(tree);
        const auto isSmall = [&](const ClosedPiece &piece)
        { return piece.box.diagonal().norm() < LEAST_PIECE * closed.front().box.diagonal().norm(); };
        while (closed.size() > MOST_PIECES || (!closed.empty() && isSmall(closed.back())))
            closed.pop_back();
        std::vector<Candidate> candidates;
        for (ClosedPiece &piece : closed)
        {
            piece.surface.build();
            for (const Ball &ball : candidatesIn(piece.surface, piece.box))
                candidates.push_back({ball, pieces_.size()});
            pieces_.push_back({piece.box, piece.corners});
        }
        std::stable_sort(candidates.begin(), candidates.end(),
                         [](const Candidate &a, const Candidate &b) { return a.ball.radius > b.ball.radius; });
        std::vector<std::size_t> windings(closed.size(), 0);
        for (const auto &[ball, piece] : candidates)
        {
            const TriangleTree &surface = closed[piece].surface;
            const auto isNear = [&center = ball.center](const Ball &other)
            { return (other.center - center).norm() < LEAST_SPACING * other.radius; };
            if (balls_.size() >= MOST_BALLS || windings[piece] > MOST_WINDINGS ||
                std::any_of(balls_.begin(), balls_.end(), isNear))
                continue;
            windings[piece] += surface.size();
            if (isInside(surface, ball.center))
            {
                balls_.push_back({ball.center, ball.radius * (1.0 - SHRINKING)});
                pieceOf_.push_back(piece);
            }
        }
        arrangeBalls();
    }

    void MeshInside::arrangeBalls()
    {
        Eigen::AlignedBox3d middle;
        for (const Ball &ball : balls_)
        {
            middle.extend(ball.center);
            extent_ = std::max(extent_, ball.center.cwiseAbs().maxCoeff());
        }
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
