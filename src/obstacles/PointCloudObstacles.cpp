#include "ompl_certificates/obstacles/PointCloudObstacles.h"

#include "Fingerprint.h"
#include "PointForest.h"

#include <algorithm>
#include <cmath>
#include <ompl/util/Exception.h>
#include <string>

namespace ompl_certificates
{
    namespace
    {
        constexpr double LARGEST = 1e15;

        constexpr std::size_t MOST_CLOUD_POINTS = std::size_t(1) << 31;

        /** The rounding of distances, relative to the largest coordinate */
        constexpr double DISTANCE_ROUNDING = 1e-12;

        double largestOf(const std::vector<double> &radii)
        {
            return radii.empty() ? 0.0 : *std::max_element(radii.begin(), radii.end());
        }

        std::unique_ptr<const PointForest> plant(std::vector<Eigen::Vector3d> points, std::vector<double> radii,
                                                 unsigned int dimension)
        {
            requirePoints(points, radii, dimension);
            const std::size_t count = points.size();
            auto tree = std::make_shared<const PointTree>(std::move(points), std::move(radii));
            return std::make_unique<const PointForest>(
                std::vector<PointForest::Layer>{{std::move(tree), nullptr, count}});
        }
    }

    void requirePoints(const std::vector<Eigen::Vector3d> &points, const std::vector<double> &radii,
                       unsigned int dimension)
    {
        if (dimension != 2 && dimension != 3)
            throw ompl::Exception("A workspace has 2 or 3 dimensions, not " + std::to_string(dimension));
        if (points.size() > MOST_CLOUD_POINTS)
            throw ompl::Exception("A point cloud must have at most " + std::to_string(MOST_CLOUD_POINTS) +
                                  " points, not " + std::to_string(points.size()));
        if (radii.size() != 1 && radii.size() != points.size())
            throw ompl::Exception("A point cloud of " + std::to_string(points.size()) +
                                  " points needs as many radii or one, not " + std::to_string(radii.size()));
        for (std::size_t i = 0; i < radii.size(); ++i)
            if (!(radii[i] >= 0.0 && radii[i] <= LARGEST))
                throw ompl::Exception("The radius of a point must be finite and not negative, but that of point " +
                                      std::to_string(i) + " is " + std::to_string(radii[i]));
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            if (!(points[i].cwiseAbs().array() <= LARGEST).all())
                throw ompl::Exception("The coordinates of point " + std::to_string(i) +
                                      " of a cloud must be finite and at most 10^15");
            if (dimension == 2 && points[i].z() != 0.0)
                throw ompl::Exception("In the plane points must have z = 0, but that of point " + std::to_string(i) +
                                      " is " + std::to_string(points[i].z()) + "; see sliced()");
        }
    }

    PointCloudObstacles::PointCloudObstacles(std::vector<Eigen::Vector3d> points, std::vector<double> radii,
                                             unsigned int dimension)
      : dimension_(dimension)
      , largestRadius_(largestOf(radii))
      , forest_(plant(std::move(points), std::move(radii), dimension))
      , tolerance_(DISTANCE_ROUNDING * (forest_->getExtent() + largestRadius_))
    {
    }

    PointCloudObstacles::PointCloudObstacles(std::unique_ptr<const PointForest> forest, double largestRadius,
                                             unsigned int dimension)
      : dimension_(dimension)
      , largestRadius_(largestRadius)
      , forest_(std::move(forest))
      , tolerance_(DISTANCE_ROUNDING * (forest_->getExtent() + largestRadius))
    {
    }

    PointCloudObstacles::PointCloudObstacles(PointCloud cloud, unsigned int dimension)
      : PointCloudObstacles(std::move(cloud.points), {cloud.radius}, dimension)
    {
    }

    PointCloudObstacles::~PointCloudObstacles() = default;

    ObstaclePart PointCloudObstacles::findHit(const Shape &shape, const Pose &pose, double within) const
    {
        const Pose toShape = pose.inverse();
        Eigen::AlignedBox3d bounds = shape.getBounds();
        // A planar mesh is above or below the points.
        if (dimension_ == 2 && shape.getMesh())
            bounds.min().z() = bounds.max().z() = toShape.translation().z();
        bounds.min().array() -= within;
        bounds.max().array() += within;
        // No rounding may hide what isWithin() finds.
        const double slack =
            tolerance_ + DISTANCE_ROUNDING * (bounds.max().norm() + bounds.min().norm() + pose.translation().norm());
        const auto isHit = [&](const Eigen::Vector3d &center, double radius)
        {
            const Eigen::Vector3d point = toShape * center;
            const double reach = radius + slack;
            return bounds.squaredExteriorDistance(point) <= reach * reach && shape.isWithin(point, radius + within);
        };
        const std::uint32_t hit = forest_->findNear(bounds, pose, isHit);
        return hit == PointTree::NONE ? NO_PART : hit;
    }

    bool PointCloudObstacles::collides(const Body &body, const Pose &pose) const
    {
        return touches(body, pose) == Touching::YES;
    }

    Touching PointCloudObstacles::touches(const Body &body, const Pose &pose, ObstaclePart *hit) const
    {
        for (const Body::Part &part : body.getParts())
            if (const ObstaclePart found = findHit(part.shape, pose * part.pose, body.getPadding()); found != NO_PART)
            {
                if (hit)
                    *hit = found;
                return Touching::YES;
            }
        return Touching::NO;
    }

    bool PointCloudObstacles::staysFree(const Body &body, const Pose &pose, double distance) const
    {
        const double within = body.getPadding() + distance + tolerance_ + exactCheckTolerance(body.getBoundingRadius());
        // No point is near what is no number.
        if (!(distance >= 0.0) || !isFinite(pose))
            return false;
        return std::none_of(body.getParts().begin(), body.getParts().end(),
                            [&](const Body::Part &part)
                            { return findHit(part.shape, pose * part.pose, within) != NO_PART; });
    }

    bool PointCloudObstacles::certainlyHits(const Body &body, const Pose &pose, ObstaclePart part) const
    {
        const auto [ball, isThere] = forest_->at(part);
        if (!isThere)
            return false;
        return std::any_of(body.getParts().begin(), body.getParts().end(),
                           [&, &point = ball](const Body::Part &bodyPart)
                           {
                               const Pose toShape = (pose * bodyPart.pose).inverse();
                               return bodyPart.shape.isWithin(toShape * point.center, point.radius + body.getPadding());
                           });
    }

    double PointCloudObstacles::clearance(const Eigen::Vector3d &point) const
    {
        return forest_->signedDistance(point, nullptr);
    }

    double PointCloudObstacles::clearanceUpTo(const Eigen::Vector3d &point, double most) const
    {
        return forest_->signedDistance(point, nullptr, most);
    }

    double PointCloudObstacles::findNearest(const Eigen::Vector3d &point, ObstaclePart &part) const
    {
        std::uint32_t nearest;
        const double distance = forest_->signedDistance(point, &nearest);
        part = nearest == PointTree::NONE ? NO_PART : nearest;
        return distance;
    }

    std::uint64_t PointCloudObstacles::getFingerprint() const
    {
        std::uint64_t sum = fingerprintOf({double(dimension_), double(size())});
        for (const auto &[point, radius] : getBalls())
            sum += fingerprintOf({point.x(), point.y(), point.z(), radius});
        return sum == 0 ? 1 : sum;
    }

    std::size_t PointCloudObstacles::size() const
    {
        return forest_->size();
    }

    std::vector<Ball> PointCloudObstacles::getBalls() const
    {
        return forest_->getBalls();
    }

    Ball PointCloudObstacles::getBall(ObstaclePart part) const
    {
        return forest_->at(part).first;
    }
}
