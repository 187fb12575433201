#ifndef OMPL_CERTIFICATES_CONTROL_PLANAR_
#define OMPL_CERTIFICATES_CONTROL_PLANAR_

#include "geometry/Angle.h"

#include "ompl_certificates/robots/Robot.h"

#include <cmath>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/util/Exception.h>
#include <typeinfo>

namespace ompl_certificates
{
    /** \brief Position and heading */
    struct Planar
    {
        double x, y, yaw;

        static Planar of(const ompl::base::State *state)
        {
            const auto *pose = state->as<ompl::base::SE2StateSpace::StateType>();
            return {pose->getX(), pose->getY(), pose->getYaw()};
        }

        /** \brief Write it to a state of SE(2), the heading within [-pi, pi) */
        void writeTo(ompl::base::State *state) const
        {
            auto *pose = state->as<ompl::base::SE2StateSpace::StateType>();
            pose->setXY(x, y);
            pose->setYaw(wrappedAngle(yaw));
        }

        /** \brief Drive along an arc at steady speeds. The chord is exact for any turn, zero included. */
        void drive(double distance, double turn)
        {
            const double half = 0.5 * turn;
            const double chord = std::abs(half) < 1e-6 ? distance : distance * std::sin(half) / half;
            x += chord * std::cos(yaw + half);
            y += chord * std::sin(yaw + half);
            yaw += turn;
        }
    };

    /** \brief \throws ompl::Exception if \e robot does not move in SE(2) */
    inline const RobotPtr &requirePlanar(const RobotPtr &robot)
    {
        if (!robot)
            return robot;
        // Cars that drive along curves move in spaces that are derived from this one.
        const ompl::base::StateSpace &space = *robot->getStateSpace();
        if (typeid(space) != typeid(ompl::base::SE2StateSpace))
            throw ompl::Exception(robot->getName(), "its shape must move in SE(2)");
        return robot;
    }
}

#endif
