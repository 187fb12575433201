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

    /** \brief A ball that contains all of \e points enlarged by \e rounding. But for rounding errors, its radius is
        within a thousandth of the smallest. There must be points. Cost: some five passes over them. */
    Ball enclosingBall(const std::vector<Eigen::Vector3d> &points, double rounding);
}

#endif
