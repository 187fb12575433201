#ifndef OMPL_CERTIFICATES_CERTIFICATES_CHECK_COUNTS_
#define OMPL_CERTIFICATES_CERTIFICATES_CHECK_COUNTS_

#include <cstdint>

namespace ompl_certificates
{
    /** \brief How collision checks were settled. All numbers but those of pairs count one robot at one state. */
    struct CheckCounts
    {
        /** \brief Robots at states that were looked at: certifiedFree + certifiedColliding + asked */
        std::uint64_t robotPoses{0};

        /** \brief … of which certificates made earlier proved that they are free */
        std::uint64_t certifiedFree{0};

        /** \brief … of which certificates made earlier, or the part of the obstacles that was hit last around there, proved
            that they collide */
        std::uint64_t certifiedColliding{0};

        /** \brief … of which the obstacles had to be asked: byClearances + byContact + exact. The paper's proportion of points
            that require a collision check is asked / robotPoses. */
        std::uint64_t asked{0};

        /** \brief Those of \e asked that new clearances settled: for all bodies of the robot, as below */
        std::uint64_t byClearances{0};

        /** \brief Those of \e asked that the contact test settled, Obstacles::touches() */
        std::uint64_t byContact{0};

        /** \brief Those of \e asked that needed the exact check, Obstacles::collides(): FCL */
        std::uint64_t exact{0};

        /** \brief Those of \e asked that were found to collide */
        std::uint64_t askedColliding{0};

        /** \brief Clearances of points that were asked of the obstacles */
        std::uint64_t clearanceQueries{0};

        /** \brief Calls of the contact test of the obstacles */
        std::uint64_t contactTests{0};

        /** \brief Calls of the exact check of the obstacles (FCL), one for each body */
        std::uint64_t exactCalls{0};

        /** \brief Bodies that were found to hit the same part of the obstacles as was hit last around there */
        std::uint64_t hitAgain{0};

        /** \brief Bodies that were asked about without clearances, since those do not pay; see SwitchingPolicy */
        std::uint64_t steppedAside{0};

        /** \brief Pairs of robots at states that were looked at */
        std::uint64_t pairPoses{0};

        /** \brief Calls of the exact check (FCL) for pairs of robots, one for each pair of bodies */
        std::uint64_t pairExact{0};

        /** \brief Motions that were checked */
        std::uint64_t motions{0};

        /** \brief Robots at samples of motions, their ends included: looked at or skipped */
        std::uint64_t motionSamples{0};

        /** \brief … of which were skipped, for they lie in a interval of the motion that is certified free */
        std::uint64_t motionSamplesSkipped{0};

        /** \brief Those of \e robotPoses that are at the ends of motions: in RRT and its kin, at the new samples. Not
            counted by the standard method, which asks for every pose. */
        std::uint64_t endPoses{0};

        /** \brief … of which the obstacles had to be asked */
        std::uint64_t endAsked{0};
    };

    /** \brief What settled a pose, the most expensive last */
    enum class SettledBy
    {
        /// Certificates made earlier, or a part of the obstacles hit before.
        CERTIFICATE,
        /// New clearances.
        CLEARANCES,
        /// The contact test.
        CONTACT,
        /// The exact check.
        EXACT_CHECK
    };

    /** \brief Count a robot at a state by what settled the most expensive of its bodies */
    inline void countRobotPose(CheckCounts &counts, SettledBy by, bool free)
    {
        ++counts.robotPoses;
        if (by == SettledBy::CERTIFICATE)
        {
            ++(free ? counts.certifiedFree : counts.certifiedColliding);
            return;
        }
        ++counts.asked;
        counts.askedColliding += free ? 0 : 1;
        ++(by == SettledBy::CLEARANCES ? counts.byClearances
           : by == SettledBy::CONTACT  ? counts.byContact
                                       : counts.exact);
    }
}

#endif
