#ifndef OMPL_CERTIFICATES_OBSTACLES_POINT_CLOUD_OBSTACLES_
#define OMPL_CERTIFICATES_OBSTACLES_POINT_CLOUD_OBSTACLES_

#include "ompl_certificates/obstacles/Obstacles.h"
#include "ompl_certificates/geometry/Ball.h"
#include "ompl_certificates/geometry/PointCloud.h"

#include <memory>
#include <vector>

namespace ompl_certificates
{
    class PointForest;

    /** \brief Obstacles that are points with a radius, as a sensor sees them. A body collides if it is nowhere farther
        from a point than its radius.

        Primitives are solid. A mesh is a surface, as in FclObstacles: a point wholly inside a closed mesh does not
        touch it. In the plane a mesh is what is seen of it from above, whatever its z.

        Distances have closed forms, so checks need no margin but that for rounding. Uses about 30 bytes per point.

        For points that come and go, PointCloudSet makes these. */
    class PointCloudObstacles : public Obstacles
    {
    public:
        /** \brief The points of a cloud, in a workspace of \e dimension 2 or 3. Give it with std::move() to keep the
            points once.
            \throws ompl::Exception for another dimension; if the radius is negative or not finite; if a coordinate is
            not finite or larger than 10^15, or in the plane has z other than 0; or for more than 2^31 points
            Cost: n log n for n points, about 0.2 s for 10^6. */
        explicit PointCloudObstacles(PointCloud cloud, unsigned int dimension = 3);

        /** \brief Points with a radius each, or one for all
            \throws ompl::Exception as above, and if there is another number of \e radii */
        PointCloudObstacles(std::vector<Eigen::Vector3d> points, std::vector<double> radii, unsigned int dimension = 3);

        ~PointCloudObstacles() override;

        unsigned int getDimension() const override
        {
            return dimension_;
        }

        /** \brief Takes some 0.1 µs where nothing is near. Each point within the bounds of a part costs some 10 ns
            more, for a mesh about 0.1 µs. */
        bool collides(const Body &body, const Pose &pose) const override;

        bool knowsPadding() const override
        {
            return true;
        }

        /** \brief The distance to the nearest point, less its radius: exact, but for rounding. Takes 0.3 to 1.7 µs. */
        double clearance(const Eigen::Vector3d &point) const override;

        double clearanceUpTo(const Eigen::Vector3d &point, double most) const override;

        /** \brief A part is a point; getBall() tells which. */
        double findNearest(const Eigen::Vector3d &point, ObstaclePart &part) const override;

        /** \brief The answer of collides(), always */
        Touching touches(const Body &body, const Pose &pose, ObstaclePart *hit = nullptr) const override;

        /** \brief By the test of touches(), with all points so much larger */
        bool staysFree(const Body &body, const Pose &pose, double distance) const override;

        /** \brief Tests that one point */
        bool certainlyHits(const Body &body, const Pose &pose, ObstaclePart part) const override;

        /** \brief Pays for rounding alone: a million millionth of the largest coordinate */
        double getTolerance() const override
        {
            return tolerance_;
        }

        /** \brief A checksum of the points and radii, whatever their order. Takes some 0.1 s for 10^6 points. */
        std::uint64_t getFingerprint() const override;

        /** \brief The number of points */
        std::size_t size() const;

        /** \brief The largest radius that was given, also if there are no points */
        double getLargestRadius() const
        {
            return largestRadius_;
        }

        /** \brief All points with their radii, in another order than they were given. Cost: linear in their number. */
        std::vector<Ball> getBalls() const;

        /** \brief The point of a part that findNearest() or touches() named, and its radius */
        Ball getBall(ObstaclePart part) const;

    private:
        friend class PointCloudSet;

        PointCloudObstacles(std::unique_ptr<const PointForest> forest, double largestRadius, unsigned int dimension);

        /** \brief The first point found that is within a distance of a shape; else NO_PART */
        ObstaclePart findHit(const Shape &shape, const Pose &pose, double within) const;

        unsigned int dimension_;
        double largestRadius_;
        std::unique_ptr<const PointForest> forest_;
        double tolerance_;
    };
}

#endif
