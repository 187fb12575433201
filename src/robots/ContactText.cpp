#include "ContactText.h"

#include "PairPadding.h"
#include "geometry/ShortestText.h"

#include "ompl_certificates/robots/Arm.h"

namespace ompl_certificates
{
    namespace
    {
        /** How many bodies a robot moves: zones come after them. */
        std::size_t countMoved(const Robot &robot)
        {
            std::size_t count = robot.getBodies().size();
            while (count > 0 && robot.isZone(count - 1))
                --count;
            return count;
        }

        const Arm *asArm(const Robot &robot)
        {
            return dynamic_cast<const Arm *>(&robot);
        }
    }

    std::string nameOfBody(const Robot &robot, std::size_t body)
    {
        if (robot.isZone(body))
            return "keep_out[" + std::to_string(body - countMoved(robot)) + "]";
        if (const Arm *arm = asArm(robot))
            return (arm->isObstacle(body) ? "obstacle '" : "link '") + arm->getLinkOfBody(body) + "'";
        return countMoved(robot) > 1 ? "body " + std::to_string(body) : "";
    }

    bool isOwnObstacle(const Robot &robot, std::size_t body)
    {
        const Arm *arm = asArm(robot);
        return robot.isZone(body) || (arm && arm->isObstacle(body));
    }

    std::string describeTouch(const Robot &robot, std::size_t body, const std::string &obstacle)
    {
        const std::string name = nameOfBody(robot, body);
        const double padding = robot.getBodies()[body].getPadding();
        return "touches " + obstacle + (name.empty() ? "" : " with " + name) +
               (padding > 0.0 ? ", with its padding of " + shortestText(padding) : "");
    }

    std::string describeOwnContact(const Robot &robot, const BodyPair &pair)
    {
        for (const auto &[body, other] : {std::pair{pair.first, pair.second}, {pair.second, pair.first}})
            if (isOwnObstacle(robot, other))
                return describeTouch(robot, body, nameOfBody(robot, other));
        return "touches itself: " + nameOfBody(robot, pair.first) + " and " + nameOfBody(robot, pair.second);
    }

    std::string describeContact(const Robot &first, std::size_t body, const Robot &second, std::size_t otherBody)
    {
        std::string text;
        const auto add = [&text](const Robot &robot, const std::string &name)
        {
            if (!name.empty())
                text += (text.empty() ? ": " : " and ") + name + " of '" + robot.getName() + "'";
        };
        add(first, nameOfBody(first, body));
        add(second, nameOfBody(second, otherBody));
        const double padding = paddingBetween(first, body, second, otherBody);
        return text + (padding > 0.0 ? ", with their padding of " + shortestText(padding) : "");
    }
}
