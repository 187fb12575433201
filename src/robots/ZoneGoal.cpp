#include "ompl_certificates/robots/ZoneGoal.h"

#include "SpaceBounds.h"
#include "UniformState.h"
#include "ompl_certificates/robots/Arm.h"

#include <algorithm>
#include <cmath>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>
#include <sstream>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        std::string cornerText(const std::vector<double> &corner)
        {
            std::ostringstream text;
            for (std::size_t i = 0; i < corner.size(); ++i)
                text << (i == 0 ? "[" : ", ") << corner[i];
            return text.str() + "]";
        }
    }

    ZoneGoal::ZoneGoal(RobotPtr robot, const ob::RealVectorBounds &box) : robot_(std::move(robot)), box_(box)
    {
        if (!robot_)
            throw ompl::Exception("ZoneGoal", "the robot must not be null");
        const std::string owner = robot_->getName() + ": goal";
        if (dynamic_cast<const Arm *>(robot_.get()))
            throw ompl::Exception(owner, "the state of an arm is no position; give the pose of a link");
        const std::size_t dimension = robot_->getWorkspaceDimension();
        const ob::RealVectorBounds *bounds = findPositionBounds(*robot_->getStateSpace());
        if (!bounds || bounds->low.size() < dimension)
            throw ompl::Exception(owner, "the robot has no position");
        if (box_.low.size() != dimension || box_.high.size() != dimension)
            throw ompl::Exception(owner, "the box must have " + std::to_string(dimension) + " dimensions");
        for (std::size_t i = 0; i < dimension; ++i)
            if (!std::isfinite(box_.low[i]) || !std::isfinite(box_.high[i]) || box_.low[i] > box_.high[i])
                throw ompl::Exception(owner, "the box must be finite, and no lower end above the upper one");
        for (std::size_t i = 0; i < dimension; ++i)
        {
            box_.low[i] = std::max(box_.low[i], bounds->low[i]);
            box_.high[i] = std::min(box_.high[i], bounds->high[i]);
            if (box_.low[i] > box_.high[i])
                throw ompl::Exception(owner, "the box is out of the bounds");
        }
    }

    double ZoneGoal::distance(const ob::State *state) const
    {
        const ob::StateSpacePtr &space = robot_->getStateSpace();
        double squares = 0.0;
        for (std::size_t i = 0; i < box_.low.size(); ++i)
        {
            const double value = *space->getValueAddressAtLocation(state, space->getValueLocations()[i]);
            const double beyond = value - std::clamp(value, box_.low[i], box_.high[i]);
            squares += beyond * beyond;
        }
        return std::sqrt(squares);
    }

    bool ZoneGoal::isFor(const Robot &robot) const
    {
        return areAlike(*robot_->getStateSpace(), *robot.getStateSpace());
    }

    std::string ZoneGoal::describe() const
    {
        return "its zone from " + cornerText(box_.low) + " to " + cornerText(box_.high);
    }

    bool ZoneGoal::sample(ompl::RNG &random, ob::State *state) const
    {
        const ob::StateSpacePtr &space = robot_->getStateSpace();
        sampleUniform(*space, random, state);
        for (std::size_t i = 0; i < box_.low.size(); ++i)
            *space->getValueAddressAtLocation(state, space->getValueLocations()[i]) =
                random.uniformReal(box_.low[i], box_.high[i]);
        return space->satisfiesBounds(state);
    }
}
