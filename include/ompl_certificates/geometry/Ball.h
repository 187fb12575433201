#ifndef OMPL_CERTIFICATES_GEOMETRY_BALL_
#define OMPL_CERTIFICATES_GEOMETRY_BALL_

#include <Eigen/Core>
#include <vector>

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

    /** \brief Whether two balls have no point in common, with a margin for rounding, of floats, too
        \param offset from one center to the other
        \param radii the sum of both radii */
    template <typename Vector>
    bool areApart(const Eigen::MatrixBase<Vector> &offset, typename Vector::Scalar radii)
    {
        return offset.squaredNorm() > typename Vector::Scalar(1.0001) * radii * radii;
    }

    /** \brief The same */
    inline bool areApart(const Ball &a, const Ball &b)
    {
        return areApart(a.center - b.center, a.radius + b.radius);
    }

    /** \brief A ball that contains all of \e points enlarged by \e rounding. Its radius is within a few per cent of the
        smallest. There must be points. Cost: linear in the number of points. */
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
        const Eigen::Vector3d middle = 0.5 * (low + high);
        const Eigen::Vector3d *farthest = &points.front();
        std::vector<double> reaches;  // the points' distances from the middle
        reaches.reserve(points.size());
        Ball best{middle, -1.0};
        for (const Eigen::Vector3d &point : points)
        {
            reaches.push_back((point - middle).norm());
            if (reaches.back() > best.radius)
            {
                best.radius = reaches.back();
                farthest = &point;
            }
        }
        Eigen::Vector3d center = middle;
        for (int i = 1; i <= 32; ++i)
        {
            // By the triangle inequality, points nearer to the middle than this are not the farthest from the center.
            const double shift = (center - middle).norm(), known = (*farthest - center).norm();
            const double least = (known - shift) - 1e-12 * (known + shift);
            double distance = -1.0;
            std::size_t index = 0;
            for (const Eigen::Vector3d &point : points)
                if (reaches[index++] >= least)
                    if (const double d = (point - center).norm(); d > distance)
                    {
                        distance = d;
                        farthest = &point;
                    }
            if (distance < best.radius)
                best = Ball{center, distance};
            center += (*farthest - center) / (i + 1.0);
        }
        best.radius += rounding;
        return best;
    }
}

#endif
