#ifndef OMPL_CERTIFICATES_ROBOTS_INTERPOLATION_
#define OMPL_CERTIFICATES_ROBOTS_INTERPOLATION_

#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

namespace ompl_certificates
{
    /** \brief The angle that OMPL's interpolation in SO(2) turns through: the shorter way round */
    double turnOf(const ompl::base::SO2StateSpace::StateType &from, const ompl::base::SO2StateSpace::StateType &to);

    /** \brief The same with its sign: positive if it turns to the left */
    double signedTurnOf(const ompl::base::SO2StateSpace::StateType &from,
                        const ompl::base::SO2StateSpace::StateType &to);

    /** \brief The angle that OMPL's interpolation in SO(3) turns through; very large where it jumps instead of
        turning */
    double turnOf(const ompl::base::SO3StateSpace::StateType &from, const ompl::base::SO3StateSpace::StateType &to);

    /** \brief The angle that it turns through at once where it jumps; 0 where it turns, or where that is not known */
    double jumpOf(const ompl::base::SO3StateSpace::StateType &from, const ompl::base::SO3StateSpace::StateType &to);

    /** \brief How far the position of an SE(2) state moves */
    double distanceOf(const ompl::base::SE2StateSpace::StateType &from, const ompl::base::SE2StateSpace::StateType &to);

    /** \brief How far the position of an SE(3) state moves */
    double distanceOf(const ompl::base::SE3StateSpace::StateType &from, const ompl::base::SE3StateSpace::StateType &to);
}

#endif
