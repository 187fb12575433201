#ifndef OMPL_CERTIFICATES_VALIDITY_TWO_BODIES_
#define OMPL_CERTIFICATES_VALIDITY_TWO_BODIES_

#include "CheckContext.h"
#include "JointCellCheck.h"

#include <limits>
#include <optional>

namespace ompl_certificates
{
    class BodyFrame;

    /** \brief A body of one robot and another body, of the same robot or not, that are checked against each other.
        Indices count the bodies of the whole team. */
    struct TwoBodies
    {
        std::size_t firstIndex, secondIndex;
        const Body *first, *second;

        /** \brief The environment: the second body, or the first if \e swapped. Null for two balls. */
        BodyFrame *frame;
        bool swapped;

        /** \brief The possible error of rounding and of FCL when bounding spheres or gaps are compared */
        double margin;

        /** \brief Bodies are apart if the centers of their bounding spheres are farther from each other than
            this. */
        double farthest;

        /** \brief Where the relative motion bound of two bodies of one robot is in
            CheckContext::pairMotionBounds */
        unsigned int robot{0};
        std::size_t ownPair{NOT_OWN};
        static constexpr std::size_t NOT_OWN = std::numeric_limits<std::size_t>::max();

        /** \brief Whether all centers of either body's sphere tree lie within its bounding radius */
        bool centersWithin{false};

        /** \brief The joint cells of two bodies of one robot, if it has some */
        std::optional<JointCellCheck> cells{};

        /** \brief The body that is looked up in the frame of the other */
        const Body &lookedUp() const
        {
            return swapped ? *second : *first;
        }

        /** \brief The pose of that body in the frame */
        Pose relativePose(const CheckContext &context) const
        {
            const Pose &a = context.poses[firstIndex], &b = context.poses[secondIndex];
            return swapped ? a.inverse() * b : b.inverse() * a;
        }

        /** \brief The distance between the bounding spheres; negative if they overlap */
        double gap(const CheckContext &context) const;

        /** \brief How fast the bounding spheres approach each other, at most */
        double speed(const CheckContext &context) const;

        /** \brief The motion bound of lookedUp() in the frame of the other. It bounds how fast clearances
            change. */
        MotionBound relativeMotionBound(const CheckContext &context) const;
    };
}

#endif
