#include "ompl_certificates/control/Car.h"

#include "Planar.h"
#include "RigidFrame.h"
#include "geometry/Angle.h"

#include "ompl_certificates/robots/ConfinedRobot.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        ob::SO2StateSpace::StateType &trailerHeadingOf(const ob::State *state)
        {
            return *state->as<ob::CompoundState>()->components[1]->as<ob::SO2StateSpace::StateType>();
        }

        /** The angle of the hinge between a car and its trailer, within [-pi, pi] */
        double hingeAngleOf(double yaw, double trailer)
        {
            return std::remainder(yaw - trailer, 2.0 * M_PI);
        }

        /** The heading of a trailer behind a car that drives along an arc: d' = turnRate - pull * sin(d), where d is
            the angle of the hinge. The tangent of d / 2 obeys a Riccati equation, whose numerator and denominator obey
            a linear one. Its matrix's square is a multiple of the unit matrix, so its exponential is elementary. */
        double trailerAfter(double trailer, double yaw, double speed, double turnRate, double hitch, double duration)
        {
            const double pull = speed / hitch;
            const double square = 0.25 * (pull - turnRate) * (pull + turnRate), root = std::sqrt(std::abs(square));
            double same = 1.0, change = duration;
            if (square > 0.0)
                change = std::tanh(root * duration) / root;  // both are divided by a cosh, which may overflow
            else if (root > 0.0)
            {
                same = std::cos(root * duration);
                change = std::sin(root * duration) / root;
            }
            const double half = 0.5 * hingeAngleOf(yaw, trailer), s = std::sin(half), c = std::cos(half);
            const double hinge = 2.0 * std::atan2(same * s + 0.5 * change * (turnRate * c - pull * s),
                                                  same * c + 0.5 * change * (pull * c - turnRate * s));
            return yaw + turnRate * duration - hinge;
        }

        /** The car with a trailer that \e shape is, or keeps out of zones */
        const CarWithTrailer &requireTrailer(const RobotPtr &shape)
        {
            const auto *confined = dynamic_cast<const ConfinedRobot *>(shape.get());
            const auto *car = dynamic_cast<const CarWithTrailer *>(confined ? confined->getRobot().get() : shape.get());
            if (!car)
                throw ompl::Exception(shape ? shape->getName() : "A dynamic robot", "is no car with a trailer");
            return *car;
        }
    }

    std::shared_ptr<Car> Car::alone(const RobotPtr &shape, const ob::RealVectorBounds &controlBounds, double wheelbase)
    {
        return std::shared_ptr<Car>(new Car(requirePlanar(shape), controlBounds, wheelbase, 0.0, 0.0));
    }

    std::shared_ptr<Car> Car::withTrailer(const RobotPtr &shape, const ob::RealVectorBounds &controlBounds,
                                          double wheelbase, double maxHingeAngle)
    {
        const CarWithTrailer &car = requireTrailer(shape);
        if (!(car.getHitchLength() > 0.0) || !(maxHingeAngle > 0.0))
            throw ompl::Exception(shape->getName(), "its hitch length and largest hinge angle must be positive, not " +
                                                        std::to_string(car.getHitchLength()) + " and " +
                                                        std::to_string(maxHingeAngle));
        return std::shared_ptr<Car>(new Car(shape, controlBounds, wheelbase, car.getHitchLength(), maxHingeAngle));
    }

    Car::Car(const RobotPtr &shape, const ob::RealVectorBounds &controlBounds, double wheelbase, double hitchLength,
             double maxHingeAngle)
      : DynamicRobot(shape, {}, ob::RealVectorBounds(0), {"speed", "steering"}, controlBounds)
      , wheelbase_(wheelbase)
      , hitchLength_(hitchLength)
      , maxHingeAngle_(maxHingeAngle)
      , distances_(hitchLength > 0.0 ? std::vector<double>() : distancesFromFrame(*shape))
    {
        constexpr double straightAngle = 1.5707;
        if (!(wheelbase > 0.0) || !std::isfinite(wheelbase))
            throw ompl::Exception(getName(), "its wheelbase must be positive, not " + std::to_string(wheelbase));
        if (controlBounds.low[1] < -straightAngle || controlBounds.high[1] > straightAngle)
            throw ompl::Exception(getName(), "its steering angle must stay below a right angle");
    }

    void Car::propagate(const ob::State *from, const double *control, double duration, ob::State *to) const
    {
        const double turnRate = control[0] / wheelbase_ * std::tan(control[1]);
        const bool pulls = hitchLength_ > 0.0;
        const ob::State *carFrom = pulls ? from->as<ob::CompoundState>()->components[0] : from;
        ob::State *carTo = pulls ? to->as<ob::CompoundState>()->components[0] : to;
        Planar car = Planar::of(carFrom);
        if (pulls)
            trailerHeadingOf(to).value = wrappedAngle(
                trailerAfter(trailerHeadingOf(from).value, car.yaw, control[0], turnRate, hitchLength_, duration));
        car.drive(duration * control[0], duration * turnRate);
        car.writeTo(carTo);
    }

    void Car::computeStepBounds(const ob::State * /*from*/, const double *control, double duration,
                                MotionBound *bounds) const
    {
        const double way = std::abs(control[0]) * duration;
        const double turn = way / wheelbase_ * std::abs(std::tan(control[1]));
        for (std::size_t body = 0; body < distances_.size(); ++body)
            bounds[body] = {way + turn * distances_[body], turn};
        if (hitchLength_ == 0.0)
            return;
        bounds[0] = {way, turn};
        // The trailer's origin follows the hinge along the trailer's heading, so it is never faster.
        bounds[1] = {way, way / hitchLength_};
        std::fill(bounds + 2, bounds + getBodies().size(), MotionBound());
    }

    bool Car::isWithinLimits(const ob::State *state) const
    {
        if (!DynamicRobot::isWithinLimits(state))
            return false;
        if (hitchLength_ == 0.0)
            return true;
        const double yaw = Planar::of(state->as<ob::CompoundState>()->components[0]).yaw;
        return std::abs(hingeAngleOf(yaw, trailerHeadingOf(state).value)) <= maxHingeAngle_;
    }
}
