#include "Interpolation.h"

#include <Eigen/Geometry>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        namespace ob = ompl::base;

        Eigen::Quaterniond quaternionOf(const ob::SO3StateSpace::StateType &state)
        {
            return Eigen::Quaterniond(state.w, state.x, state.y, state.z).normalized();
        }

        /** The angle between two orientations */
        double angleOf(const ob::SO3StateSpace::StateType &from, const ob::SO3StateSpace::StateType &to)
        {
            const Eigen::Quaterniond turn = quaternionOf(from).conjugate() * quaternionOf(to);
            return 2.0 * std::atan2(turn.vec().norm(), std::abs(turn.w()));
        }

        // SO3StateSpace takes quaternions with 1 - |q1.q2| < 1e-9 for equal: angles up to 0.9e-4, or 1.6e-4 with its
        // tolerance on their norms. Between two such it keeps the first orientation until the end of the motion, then
        // jumps.
        constexpr double JUMP = 2e-4, NO_TURN = 1e-12;

        /** Whether OMPL takes a quaternion for one of length 1, with a tolerance of 1e-9 */
        bool isUnit(const ob::SO3StateSpace::StateType &state)
        {
            return std::abs(state.x * state.x + state.y * state.y + state.z * state.z + state.w * state.w - 1.0) < 4e-9;
        }
    }

    double turnOf(const ob::SO2StateSpace::StateType &from, const ob::SO2StateSpace::StateType &to)
    {
        const double difference = std::abs(to.value - from.value);
        return difference <= M_PI ? difference : std::abs(2.0 * M_PI - difference);
    }

    double signedTurnOf(const ob::SO2StateSpace::StateType &from, const ob::SO2StateSpace::StateType &to)
    {
        const double difference = to.value - from.value;
        if (std::abs(difference) <= M_PI)
            return difference;
        return difference > 0.0 ? difference - 2.0 * M_PI : difference + 2.0 * M_PI;
    }

    double turnOf(const ob::SO3StateSpace::StateType &from, const ob::SO3StateSpace::StateType &to)
    {
        const double angle = angleOf(from, to);
        // No bound on the speed holds for a jump.
        if (angle > NO_TURN && (angle < JUMP || !isUnit(from) || !isUnit(to)))
            return 1e100;
        // Unnormalised quaternions do not turn evenly. OMPL's tolerance on their norms bounds how unevenly.
        return angle * (1.0 + 1e-6);
    }

    double jumpOf(const ob::SO3StateSpace::StateType &from, const ob::SO3StateSpace::StateType &to)
    {
        const double angle = angleOf(from, to);
        return angle > NO_TURN && angle < JUMP && isUnit(from) && isUnit(to) ? angle : 0.0;
    }

    double distanceOf(const ob::SE2StateSpace::StateType &from, const ob::SE2StateSpace::StateType &to)
    {
        return std::hypot(to.getX() - from.getX(), to.getY() - from.getY());
    }

    double distanceOf(const ob::SE3StateSpace::StateType &from, const ob::SE3StateSpace::StateType &to)
    {
        return Eigen::Vector3d(to.getX() - from.getX(), to.getY() - from.getY(), to.getZ() - from.getZ()).norm();
    }
}
