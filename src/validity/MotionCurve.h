#ifndef OMPL_CERTIFICATES_VALIDITY_MOTION_CURVE_
#define OMPL_CERTIFICATES_VALIDITY_MOTION_CURVE_

#include "robots/CurveOf.h"

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <variant>
#include <vector>

namespace ompl_certificates
{
    /** \brief Interpolates motions as their space does, to the bit. But a curve of Dubins or of Reeds and Shepp is found
        once for each motion; these spaces find it anew for each state. */
    class MotionCurve
    {
    public:
        explicit MotionCurve(const ompl::base::StateSpace &space);

        /** \brief Whether the space is one of these two */
        bool isCurve() const
        {
            return !std::holds_alternative<None>(curve_);
        }

        /** \brief Whether a motion may be led beside its end: OMPL takes steps of Dubins' that are shorter than a
            millionth of the radius for straight ones, wherever they lead. */
        bool mayMissEnd() const
        {
            return std::holds_alternative<Dubins>(curve_);
        }

        /** \brief Begins another motion */
        void begin()
        {
            isNew_ = true;
        }

        /** \brief Writes the state at \e t into \e state. All calls since begin() have the same ends. */
        void interpolate(const ompl::base::State *from, const ompl::base::State *to, double t,
                         ompl::base::State *state);

    private:
        struct None
        {
        };

        using Dubins = CurveOf<ompl::base::DubinsStateSpace>;
        using ReedsShepp = CurveOf<ompl::base::ReedsSheppStateSpace>;

        const ompl::base::StateSpace &space_;
        std::variant<None, Dubins, ReedsShepp> curve_;
        bool isNew_{true};
    };
}

#endif
