#ifndef OMPL_CERTIFICATES_TEAM_SEGMENT_COUNT_
#define OMPL_CERTIFICATES_TEAM_SEGMENT_COUNT_

#include <ompl/base/StateSpace.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief Counts the segments of motions in a space as the space would with another fraction of its extent as the
        longest valid segment. So teams can share a robot, and its space, and have resolutions of their own.

        That holds for OMPL's spaces of R^n, SO(2), SO(3), SE(2) and SE(3), its spaces of curves, and compounds of them.
        Any other space may count as it likes: it is told the fraction and asked. */
    class SegmentCount
    {
    public:
        /** \brief A count for \e space, of whose extent the longest valid segment is \e fraction. Spaces of other kinds
            are told now, and know it after their setup(). */
        SegmentCount(const ompl::base::StateSpacePtr &space, double fraction);

        /** \brief The number of segments from \e state1 to \e state2; see StateSpace::validSegmentCount() */
        unsigned int operator()(const ompl::base::State *state1, const ompl::base::State *state2) const;

    private:
        const ompl::base::StateSpace *space_;
        /** \brief The longest valid segment; 0 if the space counts itself */
        double longest_{0.0};
        /** \brief The counts of a compound's components, the largest of which is its own */
        std::vector<SegmentCount> parts_;
    };
}

#endif
