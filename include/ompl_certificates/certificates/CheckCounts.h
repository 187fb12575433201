#ifndef OMPL_CERTIFICATES_CERTIFICATES_CHECK_COUNTS_
#define OMPL_CERTIFICATES_CERTIFICATES_CHECK_COUNTS_

#include <cstdint>

namespace ompl_certificates
{
    /** \brief How collision checks were settled. All numbers but those of pairs count one robot at one state. */
    struct CheckCounts
    {
        /** \brief Robots at states that were looked at: certifiedFree + certifiedColliding + exact */
        std::uint64_t robotPoses{0};

        /** \brief … of which certificates made earlier proved that they are free */
        std::uint64_t certifiedFree{0};

        /** \brief … of which certificates made earlier proved that they collide */
        std::uint64_t certifiedColliding{0};

        /** \brief … of which the obstacles had to be asked, by new clearances or by the exact check: the paper's proportion of
            points that require a collision check is exact / robotPoses */
        std::uint64_t exact{0};

        /** \brief Those of \e exact that were found to collide */
        std::uint64_t exactColliding{0};

        /** \brief Clearances of points that were asked of the obstacles */
        std::uint64_t clearanceQueries{0};

        /** \brief Calls of the exact check of the obstacles (FCL) */
        std::uint64_t exactCalls{0};

        /** \brief Robots at states that were found to hit the same part of the obstacles as was hit last around there */
        std::uint64_t hitAgain{0};

        /** \brief Exact checks that no clearances were asked before, since that does not pay; see SwitchingPolicy */
        std::uint64_t steppedAside{0};

        /** \brief Pairs of robots at states that were looked at */
        std::uint64_t pairPoses{0};

        /** \brief … of which the exact check (FCL) had to be called */
        std::uint64_t pairExact{0};

        /** \brief Motions that were checked */
        std::uint64_t motions{0};

        /** \brief Robots at samples of motions, their ends included: looked at or skipped */
        std::uint64_t motionSamples{0};

        /** \brief … of which were skipped, for they lie in a stretch of the motion that is certified free */
        std::uint64_t motionSamplesSkipped{0};

        /** \brief Those of \e robotPoses that are at the ends of motions: in RRT and its kin, at the new samples. Not
            counted by the standard method, which asks for every pose. */
        std::uint64_t endPoses{0};

        /** \brief … of which the obstacles had to be asked */
        std::uint64_t endExact{0};
    };
}

#endif
