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

        /** \brief If positive, the body does not turn until the very end of the motion, and there by this angle at once,
            as OMPL does in SO(3) where both orientations are nearly equal. As no interval is short enough for a jump,
            \e angular is then so large that it proves nothing. A check that looks at the end by itself may take this for
            it. */
        double jump{0.0};

        /** \brief The bound for the center of a ball at distance \e distance from the origin of the body's frame */
        double at(double distance) const
        {
            return linear + angular * distance;
        }
    };
}

#endif
