#ifndef OMPL_CERTIFICATES_GEOMETRY_WINDING_
#define OMPL_CERTIFICATES_GEOMETRY_WINDING_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace ompl_certificates
{
    /** \brief Half the signed solid angle of a triangle, seen from the origin: the formula of Van Oosterom and
        Strackee. The sum over a closed surface is 2 pi times the number of times that it winds around the origin. */
    inline double halfSolidAngle(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Eigen::Vector3d &c)
    {
        const double x = a.norm(), y = b.norm(), z = c.norm();
        return std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
    }
}

#endif
