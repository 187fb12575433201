#include "ompl_certificates/robots/CarWithTrailer.h"

#include "Interpolation.h"
#include "SpaceBounds.h"

#include <cmath>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        ob::StateSpacePtr makeSpace(const std::string &name, const ob::RealVectorBounds &bounds)
        {
            requirePositionBounds(name, bounds, 2);
            auto car = std::make_shared<ob::SE2StateSpace>();
            car->setName(name + ".car");
            car->setBounds(bounds);
            auto trailer = std::make_shared<ob::SO2StateSpace>();
            trailer->setName(name + ".trailer");
            auto space = std::make_shared<ob::CompoundStateSpace>();
            space->addSubspace(car, 1.0);
            // SE2StateSpace gives its own angle this weight.
            space->addSubspace(trailer, car->getSubspaceWeight(1));
            space->lock();
            return space;
        }

        const ob::SE2StateSpace::StateType &carOf(const ob::State *state)
        {
            return *state->as<ob::CompoundState>()->as<ob::SE2StateSpace::StateType>(0);
        }

        const ob::SO2StateSpace::StateType &trailerOf(const ob::State *state)
        {
            return *state->as<ob::CompoundState>()->as<ob::SO2StateSpace::StateType>(1);
        }
    }

    CarWithTrailer::CarWithTrailer(const std::string &name, const Body &car, const Body &trailer, double hitchLength,
                                   const ob::RealVectorBounds &bounds, bool selfCollision)
      : Robot(name, makeSpace(name, bounds), {car, trailer},
              selfCollision ? std::vector<BodyPair>{{0, 1}} : std::vector<BodyPair>{})
      , hitchLength_(hitchLength)
    {
        if (car.getDimension() != 2)
            throw ompl::Exception(name, "a car and its trailer are planar bodies");
        if (!(hitchLength >= 0.0) || !std::isfinite(hitchLength))
            throw ompl::Exception(name, "the hitch length must be finite and not negative, not " +
                                            std::to_string(hitchLength));
    }

    void CarWithTrailer::computePoses(const ob::State *state, Pose *poses) const
    {
        const auto &car = carOf(state);
        const double heading = trailerOf(state).value;
        poses[0] = planarPose(car.getX(), car.getY(), car.getYaw());
        poses[1] = planarPose(car.getX() - hitchLength_ * std::cos(heading),
                              car.getY() - hitchLength_ * std::sin(heading), heading);
    }

    void CarWithTrailer::computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const
    {
        const auto &a = carOf(from), &b = carOf(to);
        const double linear = distanceOf(a, b), turn = turnOf(trailerOf(from), trailerOf(to));
        bounds[0] = {linear, turnOf(*a.as<ob::SO2StateSpace::StateType>(1), *b.as<ob::SO2StateSpace::StateType>(1))};
        bounds[1] = {linear + hitchLength_ * turn, turn};
    }

    void CarWithTrailer::computePairMotionBounds(const ob::State *from, const ob::State *to,
                                                 const MotionBound * /*bodyBounds*/, PairMotionBound *pairBounds) const
    {
        // Each turns about the hinge, which is fixed in the other's frame. Rounding may add to a small difference.
        constexpr double rounding = 1e-15;
        const double turn = rounding + std::abs(signedTurnOf(trailerOf(from), trailerOf(to)) -
                                                signedTurnOf(*carOf(from).as<ob::SO2StateSpace::StateType>(1),
                                                             *carOf(to).as<ob::SO2StateSpace::StateType>(1)));
        if (!getBodyPairs().empty())
            pairBounds[0] = {{0.0, turn}, {hitchLength_ * turn, turn}};
    }

    bool CarWithTrailer::isLike(const Robot &other) const
    {
        const auto *car = dynamic_cast<const CarWithTrailer *>(&other);
        return car && car->hitchLength_ == hitchLength_ && car->getBodies() == getBodies() &&
               car->getBodyPairs() == getBodyPairs() && haveEqualBounds(*getStateSpace(), *car->getStateSpace());
    }
}
