#ifndef OMPL_CERTIFICATES_GEOMETRY_POSE_BATCH_
#define OMPL_CERTIFICATES_GEOMETRY_POSE_BATCH_

#include <cstddef>
#include <cstdint>

namespace ompl_certificates
{
    /** \brief The poses of one body in several states at once, in single precision. Each number of a pose stands beside
        the same number of the others, so that an instruction takes several of them. */
    struct PoseBatch
    {
        /** \brief How many states there are */
        static constexpr std::size_t SIZE = 8;

        /** \brief The rotation, column by column: axes[column][row][state] */
        alignas(32) float axes[3][3][SIZE];

        /** \brief The translation: origin[row][state] */
        alignas(32) float origin[3][SIZE];
    };

    /** \brief Some of the states of a batch: a bit for each, the lowest for the first one */
    using BatchMask = std::uint8_t;

    /** \brief All states of a batch */
    constexpr BatchMask WHOLE_BATCH = 0xFF;

    /** \brief Whether a state is one of them */
    constexpr bool contains(BatchMask mask, std::size_t state)
    {
        return ((mask >> state) & 1U) != 0;
    }

    /** \brief How far the poses of a batch may be from the poses themselves. A point of a body at distance d from the
        origin of its frame is off by at most linear + angular * d. */
    struct PoseError
    {
        /** \brief How far off the origin is, at most */
        double linear{0.0};

        /** \brief By how much the rotation turns a unit vector astray, at most */
        double angular{0.0};

        /** \brief How far off a point is, at distance \e distance from the origin of the body's frame */
        double at(double distance) const
        {
            return linear + angular * distance;
        }
    };
}

#endif
