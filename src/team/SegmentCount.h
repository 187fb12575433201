#ifndef OMPL_CERTIFICATES_TEAM_SEGMENT_COUNT_
#define OMPL_CERTIFICATES_TEAM_SEGMENT_COUNT_

#include <ompl/base/StateSpace.h>
#include <optional>
#include <vector>

namespace ompl_certificates
{
    /** \brief Counts the segments of motions in a space as the space would with another fraction of its extent as the
        longest valid segment. So teams can share a robot, and its space, and have resolutions of their own.

        That holds for OMPL's spaces of R^n, SO(2), SO(3), SE(2) and SE(3), and compounds of them. In its spaces of
        curves there are as many as in SE(2), but no fewer than along the curve: OMPL 1.5 goes by the straight way, and
        has no samples on a loop back to the start. Any other space may count as it likes: it is told the fraction and
        asked. */
    class SegmentCount
    {
    public:
        /** \brief A count for \e space, of whose extent the longest valid segment is \e fraction; without one the space has
            its own. Spaces of other kinds are told now, and know it after their setup(). */
        SegmentCount(const ompl::base::StateSpacePtr &space, std::optional<double> fraction);

        /** \brief Whether motions are curves, or those of a component are, which the space itself may count otherwise */
        bool hasCurves() const;

        /** \brief The number of segments from \e state1 to \e state2; see StateSpace::validSegmentCount() */
        unsigned int operator()(const ompl::base::State *state1, const ompl::base::State *state2) const;

    private:
        /** \brief The number of segments of a way of that length; 0 if it is not finite */
        unsigned int along(double length, double longest) const;

        /** \brief The number of segments of a curve by its length */
        unsigned int alongCurve(const ompl::base::State *state1, const ompl::base::State *state2) const;

        const ompl::base::StateSpace *space_;
        /** \brief The longest valid segment; 0 if the space counts itself */
        double longest_{0.0};
        /** \brief Whether motions are curves of Dubins or of Reeds and Shepp */
        bool isCurve_{false};
        /** \brief The counts of a compound's components, the largest of which is its own */
        std::vector<SegmentCount> parts_;
    };
}

#endif
