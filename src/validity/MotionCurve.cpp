#include "MotionCurve.h"

#include "robots/CarStateSpace.h"

#include <typeinfo>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    MotionCurve::MotionCurve(const ob::StateSpace &space) : space_(space)
    {
        // Not dynamic_cast: a derived class may interpolate in another way.
        if (typeid(space) == typeid(ob::DubinsStateSpace))
            curve_ = Dubins();
        else if (typeid(space) == typeid(ob::ReedsSheppStateSpace) || typeid(space) == typeid(CarStateSpace))
            curve_ = ReedsShepp();
    }

    void MotionCurve::interpolate(const ob::State *from, const ob::State *to, double t, ob::State *state)
    {
        const bool isEnd = t <= 0.0 || t >= 1.0;  // which a curve may miss by its rounding
        if (auto *dubins = isEnd ? nullptr : std::get_if<Dubins>(&curve_))
            space_.as<ob::DubinsStateSpace>()->interpolate(from, to, t, isNew_, *dubins, state);
        else if (auto *reedsShepp = isEnd ? nullptr : std::get_if<ReedsShepp>(&curve_))
            space_.as<ob::ReedsSheppStateSpace>()->interpolate(from, to, t, isNew_, *reedsShepp, state);
        else
            space_.interpolate(from, to, t, state);
    }
}
