#ifndef OMPL_CERTIFICATES_GEOMETRY_BALL_
#define OMPL_CERTIFICATES_GEOMETRY_BALL_

#include <Eigen/Core>

namespace ompl_certificates
{
    /** \brief A closed ball of the workspace; a disc (center at z = 0) where the workspace is the plane. */
    struct Ball
    {
        /** \brief The center, in the scene's length unit */
        Eigen::Vector3d center{Eigen::Vector3d::Zero()};

        /** \brief The radius, in the scene's length unit, not negative */
        double radius{0.0};
    };

    /** \brief A ball that contains all of \e points enlarged by \e rounding. Its radius is within a few per cent of the
        smallest.
        \e points must not be empty. Cost: linear in the number of points. */
    template <typename Points>
    Ball enclosingBall(const Points &points, double rounding)
    {
        Eigen::Vector3d low = points.front(), high = points.front();
        for (const Eigen::Vector3d &point : points)
        {
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
        // Badoiu and Clarkson's iteration, started at the middle of the box, which is exact for symmetric shapes.
        const auto farthestFrom = [&points](const Eigen::Vector3d &center, double &distance)
        {
            const Eigen::Vector3d *farthest = nullptr;
            distance = -1.0;
            for (const Eigen::Vector3d &point : points)
                if (const double d = (point - center).norm(); d > distance)
                {
                    distance = d;
                    farthest = &point;
                }
            return farthest;
        };
        Ball best;
        best.center = 0.5 * (low + high);
        farthestFrom(best.center, best.radius);
        Eigen::Vector3d center = best.center;
        for (int i = 1; i <= 32; ++i)
        {
            double distance;
            const Eigen::Vector3d *farthest = farthestFrom(center, distance);
            if (distance < best.radius)
                best = Ball{center, distance};
            center += (*farthest - center) / (i + 1.0);
        }
        best.radius += rounding;
        return best;
    }
}

#endif
