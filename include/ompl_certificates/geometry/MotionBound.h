#ifndef OMPL_CERTIFICATES_GEOMETRY_MOTION_BOUND_
#define OMPL_CERTIFICATES_GEOMETRY_MOTION_BOUND_

namespace ompl_certificates
{
    /** \brief The motion bound of a body along a motion whose time runs from 0 to 1. A point at distance d from the
        origin of the body's frame moves at most (linear + angular * d) * dt in any interval of length dt. */
    struct MotionBound
    {
        /** \brief How far the origin of the body's frame travels, at most */
        double linear{0.0};

        /** \brief How far the body turns, at most, in radians */
        double angular{0.0};

        /** \brief The bound for the center of a ball at distance \e distance from the origin of the body's frame */
        double at(double distance) const
        {
            return linear + angular * distance;
        }
    };
}

#endif
