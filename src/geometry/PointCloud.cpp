#include "ompl_certificates/geometry/PointCloud.h"

#include "ShortestText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ompl/util/Exception.h>
#include <string>

namespace ompl_certificates
{
    namespace
    {
        /** Cell numbers must fit well into what they are kept in. */
        constexpr double LARGEST_CELL = 1e9;

        struct Binned
        {
            std::array<std::int32_t, 3> cell;
            float fromCenter;
            std::uint32_t point;

            bool operator<(const Binned &other) const
            {
                if (cell != other.cell)
                    return cell < other.cell;
                return fromCenter != other.fromCenter ? fromCenter < other.fromCenter : point < other.point;
            }
        };

        std::vector<Binned> inCells(const std::vector<Eigen::Vector3d> &points, double cell)
        {
            std::vector<Binned> binned(points.size());
            for (std::size_t i = 0; i < points.size(); ++i)
            {
                const Eigen::Array3d scaled = points[i].array() / cell, lowest = scaled.floor();
                if (!(scaled.abs() < LARGEST_CELL).all())
                    throw ompl::Exception(
                        "A point of a cloud to be thinned must be finite and nearer than 10^9 cells "
                        "of size " +
                        shortestText(cell) + " to the origin");
                for (Eigen::Index axis = 0; axis < 3; ++axis)
                    binned[i].cell[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(lowest[axis]);
                binned[i].fromCenter = static_cast<float>((scaled - lowest - 0.5).matrix().norm());
                binned[i].point = static_cast<std::uint32_t>(i);
            }
            return binned;
        }
    }

    PointCloud finite(PointCloud cloud)
    {
        const auto isOut = [](const Eigen::Vector3d &point) { return !point.allFinite(); };
        cloud.points.erase(std::remove_if(cloud.points.begin(), cloud.points.end(), isOut), cloud.points.end());
        return cloud;
    }

    PointCloud thinned(PointCloud cloud, double cell)
    {
        if (!(cell > 0.0) || !std::isfinite(cell))
            throw ompl::Exception("The cell of a thinned cloud must be positive and finite, not " + shortestText(cell));
        std::vector<Binned> binned = inCells(cloud.points, cell);
        std::sort(binned.begin(), binned.end());
        PointCloud thin;
        double moved = 0.0;
        for (std::size_t i = 0; i < binned.size(); ++i)
        {
            const Eigen::Vector3d &point = cloud.points[binned[i].point];
            if (i == 0 || binned[i].cell != binned[i - 1].cell)
                thin.points.push_back(point);
            moved = std::max(moved, (point - thin.points.back()).norm());
        }
        // Not below the exact sum
        thin.radius =
            moved > 0.0 ? std::nextafter(cloud.radius + moved, std::numeric_limits<double>::infinity()) : cloud.radius;
        return thin;
    }

    PointCloud sliced(PointCloud cloud, const ZInterval &heights)
    {
        if (!std::all_of(cloud.points.begin(), cloud.points.end(), [](const auto &point) { return point.allFinite(); }))
            throw ompl::Exception("A point that is not finite cannot be moved to the plane; see finite()");
        const auto isOutside = [&](const Eigen::Vector3d &point)
        { return !(point.z() + cloud.radius >= heights.low && point.z() - cloud.radius <= heights.high); };
        cloud.points.erase(std::remove_if(cloud.points.begin(), cloud.points.end(), isOutside), cloud.points.end());
        for (Eigen::Vector3d &point : cloud.points)
            point.z() = 0.0;
        return cloud;
    }
}
