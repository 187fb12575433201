#ifndef OMPL_CERTIFICATES_GEOMETRY_POINT_CLOUD_
#define OMPL_CERTIFICATES_GEOMETRY_POINT_CLOUD_

#include "ompl_certificates/geometry/ZInterval.h"

#include <Eigen/Core>
#include <vector>

namespace ompl_certificates
{
    /** \brief Points of the workspace, such as those that a sensor has seen. All within \e radius of one of them is
        occupied. */
    struct PointCloud
    {
        /** \brief The points, in the scene's length unit; z = 0 in the plane */
        std::vector<Eigen::Vector3d> points;

        /** \brief The radius of each point */
        double radius{0.0};
    };

    /** \brief The cloud without points that have a coordinate that is infinite or not a number: there a sensor has seen
        nothing. loadCloud() leaves them out by itself. Cost: linear in the number of points. */
    PointCloud finite(PointCloud cloud);

    /** \brief A cloud of fewer points: the one nearest to the center of each cell of a grid. The radius grows by the
        largest distance of a point to the one that stands for it, so that all that was occupied still is. It grows by
        less than the diagonal of a cell.
        \param cell the extent of a cell
        \throws ompl::Exception if it is not positive, or a point is not finite or farther than 10^9 cells from the
        origin
        Cost: n log n for n points, some 0.2 s for 10^6. */
    PointCloud thinned(PointCloud cloud, double cell);

    /** \brief The planar cloud of what a cloud in space occupies within a z-interval. Points that reach into it are
        moved to z = 0 and keep their radius.
        \throws ompl::Exception if a point is not finite
        Cost: linear in the number of points. */
    PointCloud sliced(PointCloud cloud, const ZInterval &heights);
}

#endif
