#include "ompl_certificates/robots/ZoneGoal.h"

#include "UniformState.h"
#include "ompl_certificates/robots/Arm.h"

#include <algorithm>
#include <cmath>
#include <ompl/util/Exception.h>
#include <sstream>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** How many random states are tried: of a box that is partly out of bounds some are. */
        constexpr unsigned int MOST_STATES = 100;
    }

    ZoneGoal::ZoneGoal(RobotPtr robot, const ob::RealVectorBounds &box) : robot_(std::move(robot)), box_(box)
    {
        const std::string owner = robot_->getName() + ": goal";
        if (dynamic_cast<const Arm *>(robot_.get()))
            throw ompl::Exception(owner, "the state of an arm is no position; see LinkPoseGoal");
        const ob::StateSpacePtr &space = robot_->getStateSpace();
        space->computeLocations();
        const std::size_t dimension = robot_->getWorkspaceDimension();
        if (space->getValueLocations().size() < dimension)
            throw ompl::Exception(owner, "the robot has no position");
        if (box_.low.size() != dimension || box_.high.size() != dimension)
            throw ompl::Exception(owner, "the box must have " + std::to_string(dimension) + " dimensions");
        for (std::size_t i = 0; i < dimension; ++i)
            if (!std::isfinite(box_.low[i]) || !std::isfinite(box_.high[i]) || box_.low[i] > box_.high[i])
                throw ompl::Exception(owner, "the box must be finite, and no lower end above the upper one");
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

    std::string ZoneGoal::describe() const
    {
        std::ostringstream text;
        for (const auto &[name, corner] : {std::pair{"its zone from ", &box_.low}, {" to ", &box_.high}})
            for (std::size_t i = 0; i < corner->size(); ++i)
                text << (i == 0 ? name : "") << (i == 0 ? "[" : ", ") << (*corner)[i]
                     << (i + 1 == corner->size() ? "]" : "");
        return text.str();
    }

    bool ZoneGoal::sample(ompl::RNG &random, ob::State *state) const
    {
        const ob::StateSpacePtr &space = robot_->getStateSpace();
        for (unsigned int i = 0; i < MOST_STATES; ++i)
        {
            sampleUniform(*space, random, state);
            for (std::size_t k = 0; k < box_.low.size(); ++k)
                *space->getValueAddressAtLocation(state, space->getValueLocations()[k]) =
                    random.uniformReal(box_.low[k], box_.high[k]);
            if (space->satisfiesBounds(state))
                return true;
        }
        return false;
    }
}
