#ifndef OMPL_CERTIFICATES_ROBOTS_CURVE_OF_
#define OMPL_CERTIFICATES_ROBOTS_CURVE_OF_

#include <ompl/base/State.h>

namespace ompl_certificates
{
    /** \brief Declared for CurveOf alone */
    template <typename Space, typename Curve>
    Curve curveOf(void (Space::*)(const ompl::base::State *, const ompl::base::State *, double, bool &, Curve &,
                                  ompl::base::State *) const);

    /** \brief The class of the curves of \e Space, DubinsStateSpace or ReedsSheppStateSpace. Its name changes with
        OMPL's release. */
    template <typename Space>
    using CurveOf = decltype(curveOf(&Space::interpolate));
}

#endif
