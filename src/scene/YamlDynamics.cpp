#include "YamlDynamics.h"

#include "ompl_certificates/control/Car.h"
#include "ompl_certificates/control/Integrator.h"
#include "ompl_certificates/control/Unicycle.h"

#include <boost/math/constants/constants.hpp>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        ob::RealVectorBounds pairOf(double low0, double high0, double low1, double high1)
        {
            ob::RealVectorBounds bounds(2);
            bounds.low = {low0, low1};
            bounds.high = {high0, high1};
            return bounds;
        }

        ob::RealVectorBounds upTo(double first, double second)
        {
            return pairOf(-first, first, -second, second);
        }
    }

    RobotPtr withDynamics(const std::string &type, const RobotPtr &shape)
    {
        // The limits that db-CBS plans with, in meters, seconds and radians
        constexpr double pi = boost::math::constants::pi<double>();
        constexpr double speed = 0.5, steering = pi / 3.0, wheelbase = 0.25, hinge = pi / 4.0;
        if (type == "single_integrator")
            return Integrator::firstOrder(shape, upTo(speed, speed));
        if (type == "double_integrator")
            return Integrator::secondOrder(shape, upTo(speed, speed), upTo(2.0, 2.0));
        if (type == "unicycle_first_order")
            return Unicycle::firstOrder(shape, upTo(speed, 0.5));
        if (type == "unicycle_first_order_sphere")
            return Unicycle::firstOrder(shape, upTo(speed, 2.0));
        if (type == "unicycle_second_order")
            return Unicycle::secondOrder(shape, upTo(speed, 0.5), upTo(0.25, 0.25));
        if (type == "car_first_order")
            return Car::alone(shape, upTo(speed, steering), wheelbase);
        if (type == "car_first_order_with_1_trailers")
            return Car::withTrailer(shape, pairOf(-0.1, speed, -steering, steering), wheelbase, hinge);
        throw ompl::Exception(shape->getName(), "there are no dynamics of type '" + type + "'");
    }
}
