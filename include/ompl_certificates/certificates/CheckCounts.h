#ifndef OMPL_CERTIFICATES_CERTIFICATES_CHECK_COUNTS_
#define OMPL_CERTIFICATES_CERTIFICATES_CHECK_COUNTS_

#include <cstdint>

namespace ompl_certificates
{
    /** \brief What settled the collision checks. Unless stated otherwise, a count is of robots at states. */
    struct CheckCounts
    {
        /** \brief Robots at states that were checked: certifiedFree + certifiedColliding + asked */
        std::uint64_t robotPoses{0};

        /** \brief … of which earlier certificates proved free */
        std::uint64_t certifiedFree{0};

        /** \brief … of which earlier certificates, or the part of the obstacles hit last nearby, proved colliding */
        std::uint64_t certifiedColliding{0};

        /** \brief … for which the obstacles were asked: byClearances + byContact + exact. The paper's proportion of
            points that require a collision check is asked / robotPoses. */
        std::uint64_t asked{0};

        /** \brief Those of \e asked that new clearances settled, for all bodies of the robot */
        std::uint64_t byClearances{0};

        /** \brief Those of \e asked that the contact test settled, Obstacles::touches() */
        std::uint64_t byContact{0};

        /** \brief Those of \e asked that needed the exact check, Obstacles::collides(): FCL */
        std::uint64_t exact{0};

        /** \brief Those of \e asked that were found to collide */
        std::uint64_t askedColliding{0};

        /** \brief Clearances of points, and gaps of whole bodies, that the obstacles computed */
        std::uint64_t clearanceQueries{0};

        /** \brief Calls of the contact test of the obstacles */
        std::uint64_t contactTests{0};

        /** \brief Calls of the exact check of the obstacles (FCL), one for each body */
        std::uint64_t exactCalls{0};

        /** \brief Bodies found to hit the part of the obstacles that was hit last nearby */
        std::uint64_t hitAgain{0};

        /** \brief Bodies checked without clearances, because these have not paid lately; see SwitchingPolicy */
        std::uint64_t steppedAside{0};

        /** \brief Pairs of robots at states that were checked; also robots checked against themselves */
        std::uint64_t pairPoses{0};

        /** \brief Calls of the exact check (FCL) for such pairs, one for each pair of bodies */
        std::uint64_t pairExact{0};

        /** \brief Motions that were checked */
        std::uint64_t motions{0};

        /** \brief Robots at samples of motions, ends included, whether checked or skipped. The samples at which a
            motion is first tested count twice if they are free. */
        std::uint64_t motionSamples{0};

        /** \brief … of which were skipped, because they lie in an interval of the motion that is certified free */
        std::uint64_t motionSamplesSkipped{0};

        /** \brief Those of \e robotPoses at the ends of motions; in RRT and similar planners these are the new samples.
            The standard method does not count them, since it asks for every pose. */
        std::uint64_t endPoses{0};

        /** \brief … for which the obstacles were asked */
        std::uint64_t endAsked{0};
    };

    /** \brief What settled a pose, in order of cost */
    enum class SettledBy
    {
        /// Earlier certificates, or the part of the obstacles hit last nearby.
        CERTIFICATE,
        /// New clearances.
        CLEARANCES,
        /// The contact test.
        CONTACT,
        /// The exact check.
        EXACT_CHECK
    };

    /** \brief Counts a robot at a state by the most expensive check of its bodies */
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
