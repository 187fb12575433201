#include "ompl_certificates/pictures/PathFile.h"

#include "files/WholeFile.h"
#include "ompl_certificates/control/DynamicRobot.h"
#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/team/PathTimes.h"
#include "ompl_certificates/team/TeamStateSpace.h"

#include <charconv>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSpaceTypes.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/control/spaces/RealVectorControlSpace.h>
#include <ompl/util/Exception.h>

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
                if (type == KinematicTree::JointType::PLANAR || type == KinematicTree::JointType::FLOATING)
                    for (const char *part : type == KinematicTree::JointType::PLANAR
                                                ? std::vector<const char *>{"x", "y", "yaw"}
                                                : std::vector<const char *>{"x", "y", "z", "qx", "qy", "qz", "qw"})
                        names.push_back(prefix + name + '.' + part);
                else
                    names.push_back(prefix + name);
            }
        }

        /** A field of a table; names come from users and may have anything in them. */
        std::string quoted(const std::string &text)
        {
            if (text.find_first_of(",\"\r\n") == std::string::npos)
                return text;
            std::string result;
            for (const char c : text)
                result += c == '"' ? "\"\"" : std::string(1, c);
            return '"' + result + '"';
        }

        using ControlType = ompl::control::RealVectorControlSpace::ControlType;

        /** All digits of \e value that tell it from its neighbors, and no more */
        std::string digitsOf(double value)
        {
            char text[32];
            return std::string(text, std::to_chars(text, text + sizeof(text), value).ptr);
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

    std::vector<std::string> controlNames(const ob::StateSpace &space)
    {
        std::vector<std::string> names;
        const auto *team = dynamic_cast<const TeamStateSpace *>(&space);
        for (const RobotPtr &robot : team ? team->getRobots() : std::vector<RobotPtr>{nullptr})
        {
            const auto *dynamic = dynamic_cast<const DynamicRobot *>(robot.get());
            if (!dynamic)
                throw ompl::Exception(space.getName(), "is not the space of a team of DynamicRobots");
            for (const std::string &control : dynamic->getControlNames())
                names.push_back(robot->getName() + '.' + control);
        }
        return names;
    }

    std::string toCsv(const ompl::geometric::PathGeometric &path)
    {
        const ob::SpaceInformation &si = *path.getSpaceInformation();
        std::string text = "length";
        for (const std::string &name : coordinateNames(*si.getStateSpace()))
            text += ',' + quoted(name);
        text += ",time\n";
        const std::vector<double> times = stateTimes(path);
        double length = 0.0;
        std::vector<double> reals;
        for (unsigned int i = 0; i < path.getStateCount(); ++i)
        {
            if (i > 0)
                length += si.distance(path.getState(i - 1), path.getState(i));
            text += digitsOf(length);
            si.getStateSpace()->copyToReals(reals, path.getState(i));
            for (const double real : reals)
                text += ',' + digitsOf(real);
            text += ',' + digitsOf(times[i]) + '\n';
        }
        return text;
    }

    std::string toCsv(const ompl::control::PathControl &original)
    {
        ompl::control::PathControl path(original);
        path.interpolate();
        const ob::StateSpace &space = *path.getSpaceInformation()->getStateSpace();
        std::string text = "time";
        for (const std::string &name : coordinateNames(space))
            text += ',' + quoted(name);
        const std::vector<std::string> controls = controlNames(space);
        for (const std::string &name : controls)
            text += ',' + quoted(name);
        const std::vector<double> times = stateTimes(path);
        std::vector<double> reals;
        for (std::size_t i = 0; i < path.getStateCount(); ++i)
        {
            text += '\n' + digitsOf(times[i]);
            space.copyToReals(reals, path.getState(static_cast<unsigned int>(i)));
            for (const double real : reals)
                text += ',' + digitsOf(real);
            const bool moves = i < path.getControlCount();
            const auto *values =
                moves ? path.getControl(static_cast<unsigned int>(i))->as<ControlType>()->values : nullptr;
            for (std::size_t k = 0; k < controls.size(); ++k)
                text += ',' + (values ? digitsOf(values[k]) : "");
        }
        return text + '\n';
    }

    void writePath(const std::string &file, const ompl::geometric::PathGeometric &path)
    {
        writeWholeFile(file, toCsv(path));
    }
}
