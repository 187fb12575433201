#include "ompl_certificates/team/Coordinates.h"

#include "geometry/ShortestText.h"
#include "robots/JointTypes.h"

#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/team/TeamStateSpace.h"

#include <boost/math/constants/constants.hpp>
#include <limits>
#include <ompl/base/StateSpaceTypes.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        std::string nameOfAxis(const ob::RealVectorStateSpace &space, unsigned int axis)
        {
            if (const std::string &name = space.getDimensionName(axis); !name.empty())
                return name;
            return space.getDimension() <= 3 ? std::string(1, "xyz"[axis]) : "x" + std::to_string(axis);
        }

        /** Add the names of the coordinates of \e space, which begin with \e prefix. */
        void addNames(const ob::StateSpace &space, const std::string &prefix, std::vector<std::string> &names)
        {
            const std::string dot = prefix.empty() ? "" : prefix + ".";
            const int type = space.getType();
            if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(&space))
            {
                // Position and rotation of one body need no further name.
                const bool body =
                    dynamic_cast<const ob::SE2StateSpace *>(&space) || dynamic_cast<const ob::SE3StateSpace *>(&space);
                for (const ob::StateSpacePtr &part : compound->getSubspaces())
                {
                    const std::string &name = part->getName();
                    const bool hasPrefix = name.compare(0, dot.size(), dot) == 0;
                    addNames(*part, body ? prefix : hasPrefix ? name : dot + name, names);
                }
            }
            else if (const auto *vector = dynamic_cast<const ob::RealVectorStateSpace *>(&space))
                for (unsigned int axis = 0; axis < vector->getDimension(); ++axis)
                    names.push_back(dot + nameOfAxis(*vector, axis));
            else if (type == ob::STATE_SPACE_SO2)
                names.push_back(dot + "yaw");
            else if (type == ob::STATE_SPACE_SO3)
                for (const char *name : {"qx", "qy", "qz", "qw"})
                    names.push_back(dot + name);
            else
                for (std::size_t i = 0; i < space.getValueLocations().size(); ++i)
                    names.push_back(dot + "value" + std::to_string(i));
        }

        /** Add the names of the coordinates of an arm, whatever spaces its joints are in. */
        void addNames(const Arm &arm, const std::string &prefix, std::vector<std::string> &names)
        {
            const KinematicTree &tree = arm.getTree();
            for (const std::string &name : arm.getGroup())
            {
                const auto type = tree.getLinks()[tree.getChildOf(name)].joint.type;
                if (coordinatesOf(type) > 1)
                    for (const char *part : type == KinematicTree::JointType::PLANAR
                                                ? std::vector<const char *>{"x", "y", "yaw"}
                                                : std::vector<const char *>{"x", "y", "z", "qx", "qy", "qz", "qw"})
                        names.push_back(prefix + name + '.' + part);
                else
                    names.push_back(prefix + name);
            }
        }

        void addBounds(const ob::StateSpace &space, std::vector<CoordinateBounds> &bounds)
        {
            constexpr double pi = boost::math::constants::pi<double>(), none = std::numeric_limits<double>::infinity();
            if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(&space))
                for (const ob::StateSpacePtr &part : compound->getSubspaces())
                    addBounds(*part, bounds);
            else if (const auto *vector = dynamic_cast<const ob::RealVectorStateSpace *>(&space))
                for (unsigned int axis = 0; axis < vector->getDimension(); ++axis)
                    bounds.push_back({vector->getBounds().low[axis], vector->getBounds().high[axis]});
            else if (space.getType() == ob::STATE_SPACE_SO2)
                bounds.push_back({-pi, pi});
            else if (space.getType() == ob::STATE_SPACE_SO3)
                bounds.insert(bounds.end(), 4, {-1.0, 1.0});
            else
                bounds.insert(bounds.end(), space.getValueLocations().size(), {-none, none});
        }
    }

    std::vector<std::string> coordinateNames(const ob::StateSpace &space)
    {
        std::vector<std::string> names;
        const auto *team = dynamic_cast<const TeamStateSpace *>(&space);
        if (!team)
            addNames(space, "", names);
        else
            for (const RobotPtr &robot : team->getRobots())
                if (const auto *arm = dynamic_cast<const Arm *>(robot.get()))
                    addNames(*arm, robot->getName() + '.', names);
                else
                    addNames(*robot->getStateSpace(), robot->getName(), names);
        return names;
    }

    std::vector<std::string> coordinateNames(const Robot &robot)
    {
        std::vector<std::string> names;
        if (const auto *arm = dynamic_cast<const Arm *>(&robot))
        {
            addNames(*arm, "", names);
            return names;
        }
        // Parts of its space may be called by its name themselves.
        addNames(*robot.getStateSpace(), robot.getName(), names);
        for (std::string &name : names)
            name.erase(0, robot.getName().empty() ? 0 : robot.getName().size() + 1);
        return names;
    }

    std::string sharedCoordinate(const Robot &first, const Robot &second)
    {
        const auto startsWith = [](const std::string &text, const std::string &start)
        { return text.compare(0, start.size(), start) == 0; };
        const std::string prefix = first.getName() + '.', other = second.getName() + '.';
        if (!startsWith(prefix, other) && !startsWith(other, prefix))
            return "";
        const std::vector<std::string> names = coordinateNames(first);
        for (const std::string &name : coordinateNames(second))
            for (const std::string &own : names)
                if (prefix + own == other + name)
                    return prefix + own;
        return "";
    }

    std::vector<CoordinateBounds> coordinateBounds(const ob::StateSpace &space)
    {
        std::vector<CoordinateBounds> bounds;
        addBounds(space, bounds);
        return bounds;
    }

    std::string describeOutOfBounds(const Robot &robot, const ob::State *state)
    {
        const ob::StateSpace &space = *robot.getStateSpace();
        if (space.satisfiesBounds(state))
            return "";
        std::string what = "is outside the bounds";
        constexpr double rounding = std::numeric_limits<double>::epsilon();  // OMPL's
        std::vector<double> values;
        space.copyToReals(values, state);
        const std::vector<std::string> names = coordinateNames(robot);
        const std::vector<CoordinateBounds> bounds = coordinateBounds(space);
        if (names.size() == values.size() && bounds.size() == values.size())
            for (std::size_t i = 0; i < values.size(); ++i)
                if (!(values[i] + rounding >= bounds[i].low && values[i] - rounding <= bounds[i].high))
                    return what + ": " + names[i] + " is " + shortestText(values[i]) + ", not from " +
                           shortestText(bounds[i].low) + " to " + shortestText(bounds[i].high);
        return what;
    }
}
