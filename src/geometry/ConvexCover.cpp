#include "ConvexCover.h"

#include "ConvexSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace ompl_certificates
{
    namespace
    {
        /** How many points a cover has, at most, and the rounding that is good enough, as a fraction of its extent */
        constexpr std::size_t MOST_CORNERS = 48;
        constexpr double SMALL_ROUNDING = 0.005;

        /** Pays for the rounding of coordinates in single precision, relative to the extent */
        constexpr double SINGLE = 1e-6;

        std::vector<Eigen::Vector3d> cornersOf(const Shape &shape)
        {
            switch (shape.getKind())
            {
                case Shape::Kind::BALL:
                    return {Eigen::Vector3d::Zero()};
                case Shape::Kind::CAPSULE:
                    return {-0.5 * shape.getSize(), 0.5 * shape.getSize()};
                case Shape::Kind::CYLINDER:
                {
                    // A prism around it, 1 % wider at its edges
                    constexpr std::size_t sides = 24;
                    std::vector<Eigen::Vector3d> corners;
                    for (std::size_t i = 0; i < sides; ++i)
                    {
                        const double angle = 2.0 * M_PI * static_cast<double>(i) / sides;
                        const double radius = shape.getRadius() / std::cos(M_PI / sides);
                        for (const double z : {-0.5, 0.5})
                            corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                                 z * shape.getSize().z());
                    }
                    return corners;
                }
                case Shape::Kind::MESH:
                    return shape.getMesh()->getVertices();
                default:
                    return shape.getHull()->vertices;
            }
        }
    }

    ConvexCover::ConvexCover(const Shape &shape, const Pose &pose)
    {
        std::vector<Eigen::Vector3d> points = cornersOf(shape);
        Eigen::AlignedBox3d box;
        for (auto &point : points)
        {
            point = pose * point;
            // A planar mesh keeps its z, where it does not count.
            if (shape.getDimension() == 2 && shape.getMesh())
                point.z() = 0.0;
            box.extend(point);
        }
        center_ = box.center();
        for (auto &point : points)
        {
            point -= center_;
            extent_ = std::max(extent_, point.norm());
        }
        if (points.size() <= MOST_CORNERS)
            setPoints(points);
        else
            coverAll(points);
        rounding_ += shape.getRadius() * (shape.getKind() == Shape::Kind::CYLINDER ? 0.0 : 1.0) + SINGLE * extent_;
    }

    void ConvexCover::setPoints(const std::vector<Eigen::Vector3d> &points)
    {
        points_.clear();
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const Eigen::Vector3f point = points[i].cast<float>();
            // The last group is filled up with its first point.
            if (i % 4 == 0)
                points_.push_back({Four{} + point.x(), Four{} + point.y(), Four{} + point.z()});
            points_.back().x[i % 4] = point.x();
            points_.back().y[i % 4] = point.y();
            points_.back().z[i % 4] = point.z();
        }
    }

    Eigen::Vector3d ConvexCover::farthest(const Eigen::Vector3d &direction) const
    {
        using Numbers = int __attribute__((vector_size(16)));
        const Eigen::Vector3f along = direction.cast<float>();
        Four most = points_[0].x * along.x() + points_[0].y * along.y() + points_[0].z * along.z();
        Numbers where{};
        for (int i = 1; i < static_cast<int>(points_.size()); ++i)
        {
            const FourPoints &four = points_[static_cast<std::size_t>(i)];
            const Four sums = four.x * along.x() + four.y * along.y() + four.z * along.z();
            const auto more = sums > most;
            most = more ? sums : most;
            where = more ? Numbers{} + i : where;
        }
        int lane = 0;
        for (int k = 1; k < 4; ++k)
            if (most[k] > most[lane])
                lane = k;
        const FourPoints &four = points_[static_cast<std::size_t>(where[lane])];
        return Eigen::Vector3f(four.x[lane], four.y[lane], four.z[lane]).cast<double>();
    }

    void ConvexCover::coverAll(const std::vector<Eigen::Vector3d> &points)
    {
        std::vector<Eigen::Vector3d> chosen;
        const auto choose = [&](const Eigen::Vector3d &point)
        {
            if (std::find(chosen.begin(), chosen.end(), point) == chosen.end())
                chosen.push_back(point);
        };
        for (const double x : {-1.0, 0.0, 1.0})
            for (const double y : {-1.0, 0.0, 1.0})
                for (const double z : {-1.0, 0.0, 1.0})
                    if (const Eigen::Vector3d direction(x, y, z); !direction.isZero())
                        choose(*std::max_element(points.begin(), points.end(),
                                                 [&](const Eigen::Vector3d &a, const Eigen::Vector3d &b)
                                                 { return direction.dot(a) < direction.dot(b); }));
        setPoints(chosen);
        const double small = SMALL_ROUNDING * extent_;
        // Points outside, by how far they were when they were last asked: as points are chosen, they only come nearer.
        std::priority_queue<std::pair<double, std::size_t>> outside;
        for (std::size_t i = 0; i < points.size(); ++i)
            outside.emplace(std::numeric_limits<double>::infinity(), i);
        while (!outside.empty())
        {
            const std::size_t farthest = outside.top().second;
            outside.pop();
            const double distance = distanceToHull(points[farthest]);
            if (distance <= small)
                rounding_ = std::max(rounding_, distance);
            else if (!outside.empty() && distance < outside.top().first)
                outside.emplace(distance, farthest);
            else if (chosen.size() < MOST_CORNERS)
            {
                choose(points[farthest]);
                setPoints(chosen);
            }
            else
            {
                rounding_ = distance;
                return;
            }
        }
    }

    double ConvexCover::distanceToHull(const Eigen::Vector3d &point) const
    {
        ConvexSearch search;
        // The middle has no direction of its own; it may lie outside as well, and then any direction will do to begin.
        Eigen::Vector3d direction = point.squaredNorm() > 0.0 ? point : Eigen::Vector3d(Eigen::Vector3d::UnitX());
        for (unsigned int step = 0; step < ConvexSearch::MOST_STEPS && direction.squaredNorm() > 0.0; ++step)
        {
            direction.normalize();
            const Eigen::Vector3d difference = point - farthest(direction);
            if (!search.add(difference, direction.dot(difference)))
                break;
            direction = search.getNearest();
        }
        return search.getNearest().norm();
    }

    double convexGap(const ConvexCover &first, const ConvexCover &second, const Pose &pose, double needed,
                     double wanted, Eigen::Vector3d &direction)
    {
        const Eigen::Matrix3d turn = pose.linear();
        const Eigen::Vector3d shift = pose * second.getCenter() - first.getCenter();
        const double rounding = first.getRounding() + second.getRounding();
        double best = -std::numeric_limits<double>::infinity();
        if (!shift.allFinite() || !turn.allFinite())
            return best;
        Eigen::Vector3d along = direction.squaredNorm() > 0.0 ? direction : shift;
        ConvexSearch search;
        for (unsigned int step = 0; step < ConvexSearch::MOST_STEPS && along.squaredNorm() > 0.0; ++step)
        {
            along.normalize();
            const Eigen::Vector3d difference =
                shift + turn * second.farthest(-(turn.transpose() * along)) - first.farthest(along);
            const double bound = along.dot(difference);
            if (bound - rounding > best)
            {
                best = bound - rounding;
                direction = along;
            }
            if (best > wanted || !search.add(difference, bound) || search.getNearest().norm() - rounding <= needed)
                break;
            along = search.getNearest();
        }
        return best;
    }

    double convexGap(const Body &first, const Body &second, const Pose &pose, double needed, double wanted,
                     Eigen::Vector3d &direction)
    {
        const auto &covers = first.getConvexCovers(), &others = second.getConvexCovers();
        if (covers.size() == 1 && others.size() == 1)
            return convexGap(covers.front(), others.front(), pose, needed, wanted, direction);
        double least = std::numeric_limits<double>::infinity();
        for (const ConvexCover &one : covers)
            for (const ConvexCover &other : others)
            {
                if (!(least > needed))
                    return least;
                // The gap of balls around both is no more than theirs, and that of two balls is all.
                const double extents = one.getExtent() + other.getExtent();
                const double balls = (pose * other.getCenter() - one.getCenter()).norm() - extents -
                                     (one.getRounding() + other.getRounding());
                if (balls >= least && std::isfinite(balls))
                    continue;
                least = std::min(least, extents == 0.0 && std::isfinite(balls)
                                            ? balls
                                            : convexGap(one, other, pose, needed, std::min(wanted, least), direction));
            }
        return least;
    }
}
