#include "ompl_certificates/geometry/Ball.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <optional>

namespace ompl_certificates
{
    namespace
    {
        /** A radius is good enough within this fraction of the smallest. */
        constexpr double TOLERANCE = 1e-3;

        /** Rounding lets a point of a ball's surface seem to be outside by less than this fraction of the radius. */
        constexpr double ROUNDING = 1e-9;

        constexpr int MOST_STEPS = 64;

        using Corners = boost::container::static_vector<Eigen::Vector3d, 4>;

        /** The smallest ball with all its corners on the surface */
        struct Support
        {
            Corners corners;
            Eigen::Vector3d center;
            double squaredRadius;
        };

        /** The point nearest to the corners of all that have equal distances from them; not finite if there is none */
        Eigen::Vector3d circumcenter(const Corners &corners)
        {
            const Eigen::Vector3d &origin = corners[0];
            if (corners.size() == 1)
                return origin;
            const Eigen::Vector3d a = corners[1] - origin;
            if (corners.size() == 2)
                return origin + 0.5 * a;
            const Eigen::Vector3d b = corners[2] - origin, normal = a.cross(b);
            if (corners.size() == 3)
                return origin + (a.squaredNorm() * b.cross(normal) + b.squaredNorm() * normal.cross(a)) /
                                    (2.0 * normal.squaredNorm());
            const Eigen::Vector3d c = corners[3] - origin;
            return origin + (a.squaredNorm() * b.cross(c) + b.squaredNorm() * c.cross(a) + c.squaredNorm() * normal) /
                                (2.0 * c.dot(normal));
        }

        /** The smallest ball around \e known and a point outside the smallest ball around \e known: the point is on its
            surface, and some of the others are. */
        std::optional<Support> smallestAround(const Corners &known, const Eigen::Vector3d &point)
        {
            std::optional<Support> best;
            for (unsigned int chosen = 0; chosen < (1U << known.size()); ++chosen)
            {
                Corners corners{point}, others;
                for (unsigned int i = 0; i < known.size(); ++i)
                    (corners.size() < 4 && (chosen >> i & 1U) != 0 ? corners : others).push_back(known[i]);
                const Eigen::Vector3d center = circumcenter(corners);
                const double squared = (point - center).squaredNorm();
                const auto isInside = [&](const Eigen::Vector3d &other)
                { return (other - center).squaredNorm() <= (1.0 + ROUNDING) * squared; };
                if (center.allFinite() && (!best || squared < best->squaredRadius) &&
                    std::all_of(others.begin(), others.end(), isInside))
                    best = Support{corners, center, squared};
            }
            return best;
        }

        const Eigen::Vector3d &farthestFrom(const Eigen::Vector3d &center, const std::vector<Eigen::Vector3d> &points)
        {
            const Eigen::Vector3d *farthest = &points.front();
            double most = -1.0;
            for (const Eigen::Vector3d &point : points)
                if (const double squared = (point - center).squaredNorm(); squared > most)
                {
                    most = squared;
                    farthest = &point;
                }
            return *farthest;
        }
    }

    Ball enclosingBall(const std::vector<Eigen::Vector3d> &points, double rounding)
    {
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d &point : points)
            box.extend(point);
        // The middle of the box is exact for symmetric shapes.
        const Eigen::Vector3d first = farthestFrom(box.center(), points);
        Ball best{box.center(), (first - box.center()).norm()};
        // As Gärtner's pivoting: the ball of a few points grows by the farthest of all, until none is outside. It is never
        // larger than the smallest ball around all.
        Support support{{first}, first, 0.0};
        for (int step = 0; step < MOST_STEPS; ++step)
        {
            const Eigen::Vector3d &farthest = farthestFrom(support.center, points);
            if (const double reach = (farthest - support.center).norm(); reach < (1.0 - ROUNDING) * best.radius)
                best = {support.center, reach};
            if (best.radius <= (1.0 + TOLERANCE) * std::sqrt(support.squaredRadius))
                break;
            const auto next = smallestAround(support.corners, farthest);
            if (!next || next->squaredRadius <= support.squaredRadius)
                break;
            support = *next;
        }
        best.radius += rounding;
        return best;
    }
}
