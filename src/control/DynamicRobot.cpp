#include "ompl_certificates/control/DynamicRobot.h"

#include <algorithm>
#include <cmath>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        const RobotPtr &existing(const RobotPtr &shape)
        {
            if (!shape)
                throw ompl::Exception("A dynamic robot needs a shape");
            return shape;
        }

        /** How much a velocity counts in distances, beside a length */
        constexpr double VELOCITY_WEIGHT = 0.25;

        ob::StateSpacePtr makeSpace(const RobotPtr &shape, const std::vector<std::string> &velocityNames,
                                    const ob::RealVectorBounds &velocityBounds)
        {
            if (velocityNames.empty())
                return existing(shape)->getStateSpace();
            const std::string name = existing(shape)->getName();
            auto velocities = std::make_shared<ob::RealVectorStateSpace>();
            for (const std::string &velocity : velocityNames)
                velocities->addDimension(velocity, -1.0, 1.0);
            velocities->setBounds(velocityBounds);
            velocities->setName(name + ".velocity");
            shape->getStateSpace()->setName(name + ".pose");
            auto space = std::make_shared<ob::CompoundStateSpace>();
            space->addSubspace(shape->getStateSpace(), 1.0);
            space->addSubspace(velocities, VELOCITY_WEIGHT);
            space->lock();
            return space;
        }

        void requireBounds(const std::string &name, const std::string &what, const ob::RealVectorBounds &bounds,
                           std::size_t dimension)
        {
            if (bounds.low.size() != dimension || bounds.high.size() != dimension)
                throw ompl::Exception(name, "the bounds of its " + what + " must have " + std::to_string(dimension) +
                                                " dimensions, not " + std::to_string(bounds.low.size()));
            for (std::size_t i = 0; i < dimension; ++i)
                if (!std::isfinite(bounds.low[i]) || !std::isfinite(bounds.high[i]) || bounds.low[i] >= bounds.high[i])
                    throw ompl::Exception(
                        name, "the bounds of its " + what + " must be finite, each low below its high, not " +
                                  std::to_string(bounds.low[i]) + " to " + std::to_string(bounds.high[i]));
        }
    }

    DynamicRobot::DynamicRobot(const RobotPtr &shape, const std::vector<std::string> &velocityNames,
                               const ob::RealVectorBounds &velocityBounds, const std::vector<std::string> &controlNames,
                               const ob::RealVectorBounds &controlBounds)
      : Robot(existing(shape)->getName(),
              (requireBounds(existing(shape)->getName(), "velocities", velocityBounds, velocityNames.size()),
               requireBounds(existing(shape)->getName(), "controls", controlBounds, controlNames.size()),
               makeSpace(shape, velocityNames, velocityBounds)),
              existing(shape)->getBodies(), existing(shape)->getBodyPairs())
      , shape_(shape)
      , velocityCount_(velocityNames.size())
      , controlNames_(controlNames)
      , controlBounds_(controlBounds)
    {
    }

    const ob::State *DynamicRobot::poseOf(const ob::State *state) const
    {
        return velocityCount_ > 0 ? state->as<ob::CompoundState>()->components[0] : state;
    }

    ob::State *DynamicRobot::poseOf(ob::State *state) const
    {
        return velocityCount_ > 0 ? state->as<ob::CompoundState>()->components[0] : state;
    }

    double *DynamicRobot::velocitiesOf(const ob::State *state) const
    {
        if (velocityCount_ == 0)
            return nullptr;
        return state->as<ob::CompoundState>()->components[1]->as<ob::RealVectorStateSpace::StateType>()->values;
    }

    void DynamicRobot::computePoses(const ob::State *state, Pose *poses) const
    {
        shape_->computePoses(poseOf(state), poses);
    }

    void DynamicRobot::computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const
    {
        shape_->computeMotionBounds(poseOf(from), poseOf(to), bounds);
    }

    std::optional<Robot::Jump> DynamicRobot::getJump(std::size_t body, const ob::State *from, const ob::State *to) const
    {
        return shape_->getJump(body, poseOf(from), poseOf(to));
    }

    void DynamicRobot::computePairMotionBounds(const ob::State *from, const ob::State *to,
                                               const MotionBound *bodyBounds, PairMotionBound *pairBounds) const
    {
        shape_->computePairMotionBounds(poseOf(from), poseOf(to), bodyBounds, pairBounds);
    }

    bool DynamicRobot::mayCollide(std::size_t body, const Robot &other, std::size_t otherBody) const
    {
        // Shapes know those of their own kind.
        const auto *dynamic = dynamic_cast<const DynamicRobot *>(&other);
        return shape_->mayCollide(body, dynamic ? *dynamic->shape_ : other, otherBody);
    }

    bool DynamicRobot::mayTouchObstacles(std::size_t body) const
    {
        return shape_->mayTouchObstacles(body);
    }

    bool DynamicRobot::isZone(std::size_t body) const
    {
        return shape_->isZone(body);
    }

    std::size_t DynamicRobot::getTracedBody() const
    {
        return shape_->getTracedBody();
    }

    void DynamicRobot::computeBrake(const ob::State *state, double duration, double *control) const
    {
        const double *velocities = velocityCount_ == controlNames_.size() ? velocitiesOf(state) : nullptr;
        for (std::size_t i = 0; i < controlNames_.size(); ++i)
            control[i] = std::clamp(velocities ? (0.0 - velocities[i]) / duration : 0.0, controlBounds_.low[i],
                                    controlBounds_.high[i]);
    }

    bool DynamicRobot::isWithinLimits(const ob::State *state) const
    {
        // OMPL takes NaN to be within any bounds.
        const ob::StateSpace &space = *getStateSpace();
        const auto &locations = space.getValueLocations();
        return std::all_of(locations.begin(), locations.end(),
                           [&](const auto &location)
                           { return std::isfinite(*space.getValueAddressAtLocation(state, location)); }) &&
               space.satisfiesBounds(state);
    }
}
