#include "ompl_certificates/pictures/PathFile.h"

#include "files/WholeFile.h"
#include "geometry/ShortestText.h"
#include "ompl_certificates/control/DynamicRobot.h"
#include "ompl_certificates/control/PathSteps.h"
#include "ompl_certificates/team/PathTimes.h"
#include "ompl_certificates/team/TeamStateSpace.h"

#include <ompl/base/SpaceInformation.h>
#include <ompl/control/spaces/RealVectorControlSpace.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
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
        if (si.getStateSpace()->getValueLocations().empty())
            throw ompl::Exception(si.getStateSpace()->getName(),
                                  "has states without numbers; call setup() of its SpaceInformation, if nobody has");
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
            text += shortestText(length);
            si.getStateSpace()->copyToReals(reals, path.getState(i));
            for (const double real : reals)
                text += ',' + shortestText(real);
            text += ',' + shortestText(times[i]) + '\n';
        }
        return text;
    }

    std::string toCsv(const ompl::control::PathControl &original)
    {
        const ompl::control::PathControl path = pathSteps(original);
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
            text += '\n' + shortestText(times[i]);
            space.copyToReals(reals, path.getState(static_cast<unsigned int>(i)));
            for (const double real : reals)
                text += ',' + shortestText(real);
            const bool moves = i < path.getControlCount();
            const auto *values =
                moves ? path.getControl(static_cast<unsigned int>(i))->as<ControlType>()->values : nullptr;
            for (std::size_t k = 0; k < controls.size(); ++k)
                text += ',' + (values ? shortestText(values[k]) : "");
        }
        return text + '\n';
    }

    void writePath(const std::string &file, const ompl::geometric::PathGeometric &path)
    {
        writeWholeFile(file, toCsv(path));
    }
}
