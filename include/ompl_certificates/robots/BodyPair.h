#ifndef OMPL_CERTIFICATES_ROBOTS_BODY_PAIR_
#define OMPL_CERTIFICATES_ROBOTS_BODY_PAIR_

#include "ompl_certificates/geometry/MotionBound.h"

#include <cstddef>

namespace ompl_certificates
{
    /** \brief Two bodies of one robot that may collide with each other, by their indices in Robot::getBodies() */
    struct BodyPair
    {
        /** \brief The index of one body */
        std::size_t first;

        /** \brief The index of the other body */
        std::size_t second;

        /** \brief Whether both name the same bodies in the same order */
        bool operator==(const BodyPair &other) const
        {
            return first == other.first && second == other.second;
        }
    };

    /** \brief How fast the two bodies of a BodyPair move relative to each other, along a motion whose time runs from 0
        to 1.

        One bound would do. But for a chain of links the two differ, and the smaller one is used. */
    struct PairMotionBound
    {
        /** \brief The motion bound of the first body, seen from the frame of the second. It bounds distances: take a
            point of the first body's frame, at distance d from its origin, and any point within the second body's
            bounding radius. The distance between the two changes by at most (linear + angular * d) * dt in any interval
            of length dt. */
        MotionBound first;

        /** \brief The motion bound of the second body, seen from the frame of the first */
        MotionBound second;
    };
}

#endif
