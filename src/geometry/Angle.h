#ifndef OMPL_CERTIFICATES_GEOMETRY_ANGLE_
#define OMPL_CERTIFICATES_GEOMETRY_ANGLE_

#include <cmath>

namespace ompl_certificates
{
    /** \brief \e angle, in radians, brought into [-pi, pi), as OMPL's SO2StateSpace wants it. An angle within that range
        stays as it is, to the last bit. NaN stays NaN, and an infinite angle becomes NaN. */
    inline double wrappedAngle(double angle)
    {
        if (angle >= -M_PI && angle < M_PI)
            return angle;
        const double wrapped = std::remainder(angle, 2.0 * M_PI);
        // That of an odd multiple of pi may be pi itself.
        return wrapped >= M_PI ? -M_PI : wrapped;
    }
}

#endif
