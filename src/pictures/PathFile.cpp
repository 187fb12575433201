#include "ompl_certificates/pictures/PathFile.h"

#include "files/WholeFile.h"
#include "geometry/ShortestText.h"
#include "ompl_certificates/control/DynamicRobot.h"
#include "ompl_certificates/control/PathSteps.h"
#include "ompl_certificates/team/PathTimes.h"
#include "ompl_certificates/team/TeamStateSpace.h"
#include "ompl_certificates/team/TimedPath.h"

#include <ompl/base/ScopedState.h>
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

        void requireNumbers(const ompl::geometric::PathGeometric &path)
        {
            const ob::StateSpace &space = *path.getSpaceInformation()->getStateSpace();
            if (space.getValueLocations().empty())
                throw ompl::Exception(space.getName(),
                                      "has states without numbers; call setup() of its "
                                      "SpaceInformation, if nobody has");
        }

        /** \param times one for each state */
        std::string toTable(const ompl::geometric::PathGeometric &path, const std::vector<double> &times)
        {
            const ob::SpaceInformation &si = *path.getSpaceInformation();
            std::string text = "length";
            for (const std::string &name : coordinateNames(*si.getStateSpace()))
                text += ',' + quoted(name);
            text += ",time\n";
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
        requireNumbers(path);
        return toTable(path, stateTimes(path));
    }

    std::string toCsv(const ompl::geometric::PathGeometric &path, double step)
    {
        requireNumbers(path);
        const TimedPath timed(path);
        const std::vector<double> times = timed.listTimes(step);
        ompl::geometric::PathGeometric all(path.getSpaceInformation());
        ob::ScopedState<> state(path.getSpaceInformation());
        for (const double time : times)
        {
            timed.computeState(time, state.get());
            all.append(state.get());
        }
        return toTable(all, times);
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

    void writePath(const std::string &file, const ompl::geometric::PathGeometric &path, double step)
    {
        writeWholeFile(file, toCsv(path, step));
    }

    void writePath(const std::string &file, const ompl::control::PathControl &path)
    {
        writeWholeFile(file, toCsv(path));
    }
}
