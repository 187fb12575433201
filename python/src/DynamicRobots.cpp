#include "DynamicRobots.h"

#include <ompl_certificates/control/Car.h>
#include <ompl_certificates/control/Integrator.h>
#include <ompl_certificates/control/Unicycle.h>
#include <ompl_certificates/robots/CarWithTrailer.h>
#include <ompl_certificates/robots/ConfinedRobot.h>
#include <ompl_certificates/robots/RigidRobot.h>

#include <cmath>
#include <ompl/util/Exception.h>
#include <optional>
#include <pybind11/stl.h>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;
    using ompl::base::RealVectorBounds;

    namespace
    {
        using Robots = std::shared_ptr<Robot>;

        void requirePlane(const Body &body, const std::string &what)
        {
            if (body.getDimension() != 2)
                throw ompl::Exception(what, "must be a body in the plane, such as Body.box(0.5, 0.25)");
        }

        /** Limits along some axes: of a number v from -v to v along each, of (low, high) these along each, and of
            pairs those of each axis */
        RealVectorBounds limitsOf(const py::object &object, const std::string &what, unsigned int axes)
        {
            const Doubles numbers = toDoubles(object, what);
            const auto all = static_cast<py::ssize_t>(axes);
            const bool one = numbers.ndim() == 0, pair = numbers.ndim() == 1 && numbers.size() == 2,
                       each = axes > 1 && numbers.ndim() == 2 && numbers.shape(0) == all && numbers.shape(1) == 2;
            if (!one && !pair && !each)
                throw ompl::Exception(what,
                                      "must be a number or (low, high)" +
                                          (axes > 1 ? ", or an array of shape (" + std::to_string(axes) + ", 2)" : "") +
                                          ", not of shape " + shapeOf(numbers));
            RealVectorBounds limits(axes);
            for (unsigned int axis = 0; axis < axes; ++axis)
            {
                const double *values = numbers.data() + (each ? 2 * axis : 0);
                limits.low[axis] = one ? -values[0] : values[0];
                limits.high[axis] = one ? values[0] : values[1];
                if (!std::isfinite(limits.low[axis]) || !std::isfinite(limits.high[axis]))
                    throw ompl::Exception(what, "must be finite, not " + py::str(object).cast<std::string>());
                if (limits.low[axis] >= limits.high[axis])
                    throw ompl::Exception(what, (one ? "must be positive, not " : "low must be below high, not ") +
                                                    py::str(object).cast<std::string>());
            }
            return limits;
        }

        /** The limits of two different quantities, such as a length and an angle */
        RealVectorBounds limitsOf(const py::object &first, const std::string &firstName, const py::object &second,
                                  const std::string &secondName)
        {
            RealVectorBounds limits = limitsOf(first, firstName, 1);
            const RealVectorBounds others = limitsOf(second, secondName, 1);
            limits.low.push_back(others.low[0]);
            limits.high.push_back(others.high[0]);
            return limits;
        }

        Robots makeIntegrator(const std::string &name, const Body &body, const py::object &low, const py::object &high,
                              const py::object &velocity, const py::object &acceleration,
                              const std::vector<Placed> &keepOut)
        {
            const RealVectorBounds bounds = toBounds(low, high);
            const unsigned int axes = body.getDimension();
            const RobotPtr shape = confined(
                axes == 2 ? RigidRobot::inR2(name, body, bounds) : RigidRobot::inR3(name, body, bounds), keepOut);
            const RealVectorBounds velocities = limitsOf(velocity, "velocity", axes);
            if (acceleration.is_none())
                return Integrator::firstOrder(shape, velocities);
            return Integrator::secondOrder(shape, velocities, limitsOf(acceleration, "acceleration", axes));
        }

        Robots makeUnicycle(const std::string &name, const Body &body, const py::object &low, const py::object &high,
                            const py::object &linear, const py::object &angular, const py::object &linearAcceleration,
                            const py::object &angularAcceleration, const std::vector<Placed> &keepOut)
        {
            requirePlane(body, "body");
            const RobotPtr shape = confined(RigidRobot::inSE2(name, body, toBounds(low, high)), keepOut);
            const RealVectorBounds speeds = limitsOf(linear, "linear", angular, "angular");
            if (linearAcceleration.is_none() != angularAcceleration.is_none())
                throw ompl::Exception(linearAcceleration.is_none() ? "linear_acceleration" : "angular_acceleration",
                                      "must be given, too: a unicycle has two accelerations or none");
            if (linearAcceleration.is_none())
                return Unicycle::firstOrder(shape, speeds);
            return Unicycle::secondOrder(
                shape, speeds,
                limitsOf(linearAcceleration, "linear_acceleration", angularAcceleration, "angular_acceleration"));
        }

        Robots makeCar(const std::string &name, const Body &body, const py::object &low, const py::object &high,
                       const py::object &speed, const py::object &steering, double wheelbase,
                       const std::optional<Body> &trailer, const std::optional<double> &hitchLength,
                       const std::optional<double> &maxHingeAngle, const std::vector<Placed> &keepOut)
        {
            requirePlane(body, "body");
            const RealVectorBounds bounds = toBounds(low, high);
            const RealVectorBounds controls = limitsOf(speed, "speed", steering, "steering");
            if (trailer.has_value() != hitchLength.has_value() || trailer.has_value() != maxHingeAngle.has_value())
                throw ompl::Exception(!trailer       ? "trailer"
                                      : !hitchLength ? "hitch_length"
                                                     : "max_hinge_angle",
                                      "must be given, too: trailer, hitch_length and max_hinge_angle go together");
            if (!trailer)
                return Car::alone(confined(RigidRobot::inSE2(name, body, bounds), keepOut), controls, wheelbase);
            requirePlane(*trailer, "trailer");
            const auto shape = std::make_shared<CarWithTrailer>(name, body, *trailer, *hitchLength, bounds);
            return Car::withTrailer(confined(shape, keepOut), controls, wheelbase, *maxHingeAngle);
        }
    }

    RobotPtr confined(const RobotPtr &robot, const std::vector<Placed> &zones)
    {
        if (zones.empty())
            return robot;
        return std::make_shared<ConfinedRobot>(robot, toPlacedBodies(zones, robot->getWorkspaceDimension()));
    }

    void bindDynamicRobots(py::class_<Robot, Robots> &robot)
    {
        robot
            .def_static("integrator", &makeIntegrator, py::arg("name"), py::arg("body"), py::arg("low"),
                        py::arg("high"), py::arg("velocity"), py::arg("acceleration") = py::none(), py::kw_only(),
                        py::arg("keep_out") = std::vector<Placed>(),
                        "A robot that moves by controls and does not turn. Its controls are its velocities along the "
                        "axes; with an acceleration its accelerations, and then the velocities are part of its state. "
                        "Limits are a number v for -v to v along each axis, or (low, high), or an array of shape "
                        "(dimension, 2). keep_out is that of Robot.rigid.")
            .def_static("unicycle", &makeUnicycle, py::arg("name"), py::arg("body"), py::arg("low"), py::arg("high"),
                        py::arg("linear"), py::arg("angular"), py::arg("linear_acceleration") = py::none(),
                        py::arg("angular_acceleration") = py::none(), py::kw_only(),
                        py::arg("keep_out") = std::vector<Placed>(),
                        "A robot in the plane that moves by controls: along its heading, and by turns. Its controls "
                        "are these two speeds; with both accelerations these, and then the speeds are part of its "
                        "state. Limits are a number v for -v to v, or (low, high). keep_out is that of Robot.rigid.")
            .def_static("car", &makeCar, py::arg("name"), py::arg("body"), py::arg("low"), py::arg("high"),
                        py::arg("speed"), py::arg("steering"), py::arg("wheelbase"), py::arg("trailer") = py::none(),
                        py::arg("hitch_length") = py::none(), py::arg("max_hinge_angle") = py::none(), py::kw_only(),
                        py::arg("keep_out") = std::vector<Placed>(),
                        "A car that moves by controls: the speed of its rear axle, where its frame's origin is, and "
                        "the steering angle. Limits are a number v for -v to v, or (low, high). wheelbase is the "
                        "distance between the axles. With a trailer, whose origin is hitch_length behind the car's, "
                        "the headings of both differ by at most max_hinge_angle. keep_out is that of Robot.rigid.")
            .def_property_readonly(
                "control_names",
                [](const Robot &self)
                {
                    const auto *dynamic = dynamic_cast<const DynamicRobot *>(&self);
                    return dynamic ? dynamic->getControlNames() : std::vector<std::string>();
                },
                "The names of its controls; none if it moves without");
    }
}
