#include "ompl_certificates/control/Integrator.h"

#include "RigidFrame.h"

#include <algorithm>
#include <cmath>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** Names of the velocities or controls: as many as the space has axes */
        std::vector<std::string> axesOf(const RobotPtr &shape, const std::string &prefix)
        {
            std::vector<std::string> names{prefix + "x", prefix + "y", prefix + "z"};
            const std::size_t dimension = shape ? shape->getStateSpace()->getDimension() : 0;
            if (!shape || shape->getStateSpace()->getType() != ob::STATE_SPACE_REAL_VECTOR || dimension > names.size())
                throw ompl::Exception(shape ? shape->getName() : "Integrator", "its shape must move in R^2 or R^3");
            names.resize(dimension);
            return names;
        }

        double *valuesOf(const ob::State *state)
        {
            return state->as<ob::RealVectorStateSpace::StateType>()->values;
        }
    }

    std::shared_ptr<Integrator> Integrator::firstOrder(const RobotPtr &shape,
                                                       const ob::RealVectorBounds &velocityBounds)
    {
        return std::shared_ptr<Integrator>(
            new Integrator(shape, {}, ob::RealVectorBounds(0), axesOf(shape, "v"), velocityBounds));
    }

    std::shared_ptr<Integrator> Integrator::secondOrder(const RobotPtr &shape,
                                                        const ob::RealVectorBounds &velocityBounds,
                                                        const ob::RealVectorBounds &accelerationBounds)
    {
        return std::shared_ptr<Integrator>(
            new Integrator(shape, axesOf(shape, ""), velocityBounds, axesOf(shape, "a"), accelerationBounds));
    }

    Integrator::Integrator(const RobotPtr &shape, const std::vector<std::string> &velocityNames,
                           const ob::RealVectorBounds &velocityBounds, const std::vector<std::string> &controlNames,
                           const ob::RealVectorBounds &controlBounds)
      : DynamicRobot(shape, velocityNames, velocityBounds, controlNames, controlBounds)
    {
        // Only for what it refuses: without turns, it does not matter how far bodies are from the frame.
        distancesFromFrame(*shape);
    }

    void Integrator::propagate(const ob::State *from, const double *control, double duration, ob::State *to) const
    {
        const double *position = valuesOf(poseOf(from)), *velocity = velocitiesOf(from);
        double *newPosition = valuesOf(poseOf(to)), *newVelocity = velocitiesOf(to);
        for (std::size_t i = 0; i < getControlNames().size(); ++i)
        {
            if (!velocity)
            {
                newPosition[i] = position[i] + duration * control[i];
                continue;
            }
            newPosition[i] = position[i] + duration * (velocity[i] + 0.5 * duration * control[i]);
            newVelocity[i] = velocity[i] + duration * control[i];
        }
    }

    void Integrator::computeStepBounds(const ob::State *from, const double *control, double duration,
                                       MotionBound *bounds) const
    {
        // The speed of a steady acceleration is convex in time: it is largest at one of the ends.
        const double *velocity = velocitiesOf(from);
        double before = 0.0, after = 0.0;
        for (std::size_t i = 0; i < getControlNames().size(); ++i)
        {
            const double first = velocity ? velocity[i] : control[i];
            const double last = velocity ? velocity[i] + duration * control[i] : control[i];
            before += first * first;
            after += last * last;
        }
        std::fill_n(bounds, getBodies().size(), MotionBound{std::sqrt(std::max(before, after)) * duration, 0.0});
    }
}
