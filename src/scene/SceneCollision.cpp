#include "SceneCollision.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/robots/Arm.h"

#include <algorithm>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** What helps if two arms have a link at the same place: they are parts of one mechanism. */
        std::string hintOn(const Robot &first, const std::vector<Pose> &poses, const Robot &second,
                           const std::vector<Pose> &others)
        {
            const auto *arm = dynamic_cast<const Arm *>(&first), *other = dynamic_cast<const Arm *>(&second);
            for (std::size_t i = 0; arm && other && i < poses.size(); ++i)
                for (std::size_t k = 0; k < others.size(); ++k)
                    if (arm->getLinkOfBody(i) == other->getLinkOfBody(k) && poses[i].matrix() == others[k].matrix())
                        return ": both have link '" + arm->getLinkOfBody(i) +
                               "' there; to be parts of one mechanism they must be made together, of the same file, "
                               "srdf and base";
            return "";
        }

        /** What messages call a body of a robot that has several, or of an arm; else nothing */
        std::string nameOfBody(const Robot &robot, std::size_t body)
        {
            if (const auto *arm = dynamic_cast<const Arm *>(&robot))
                return "link '" + arm->getLinkOfBody(body) + "'";
            return robot.getBodies().size() > 1 ? "body " + std::to_string(body) : "";
        }

        /** The bodies of two robots that touch each other, or of one, as the end of a message; nothing if neither has
            more than one body */
        std::string describeBodies(const Robot &first, const std::vector<Pose> &poses, const Robot &second,
                                   const std::vector<Pose> &others)
        {
            const bool alone = &first == &second;
            std::vector<BodyPair> pairs = alone ? first.getBodyPairs() : std::vector<BodyPair>();
            for (std::size_t i = 0; !alone && i < poses.size(); ++i)
                for (std::size_t k = 0; k < others.size(); ++k)
                    if (first.mayCollide(i, second, k) && second.mayCollide(k, first, i))
                        pairs.push_back({i, k});
            for (const BodyPair &pair : pairs)
            {
                const PlacedBody other{second.getBodies()[pair.second], others[pair.second]};
                if (!FclObstacles({other}, other.body.getDimension())
                         .collides(first.getBodies()[pair.first], poses[pair.first]))
                    continue;
                const std::string name = nameOfBody(first, pair.first), otherName = nameOfBody(second, pair.second);
                const std::string whose = alone ? "" : " of '" + first.getName() + "'",
                                  otherWhose = alone ? "" : " of '" + second.getName() + "'";
                if (name.empty() && otherName.empty())
                    return "";
                return ": " + (name.empty() ? "" : name + whose) + (name.empty() || otherName.empty() ? "" : " and ") +
                       (otherName.empty() ? "" : otherName + otherWhose);
            }
            return "";
        }

        /** What an arm touches of the obstacles that count as its links, as SceneCollision::touch; empty if nothing */
        std::string describeTouch(const Robot &robot, const std::vector<Pose> &poses)
        {
            const auto *arm = dynamic_cast<const Arm *>(&robot);
            for (const BodyPair &pair : arm ? arm->getBodyPairs() : std::vector<BodyPair>())
            {
                const bool isFirst = arm->isObstacle(pair.first);
                const std::size_t obstacle = isFirst ? pair.first : pair.second,
                                  link = isFirst ? pair.second : pair.first;
                if (arm->isObstacle(obstacle) && FclObstacles({{arm->getBodies()[obstacle], poses[obstacle]}}, 3)
                                                     .collides(arm->getBodies()[link], poses[link]))
                    return "touches obstacle '" + arm->getLinkOfBody(obstacle) + "' with " + nameOfBody(robot, link);
            }
            return "";
        }

        /** What messages call the obstacle that \e body touches at \e pose */
        std::string nameOfObstacle(const Scene &scene, const ZInterval &zInterval, const Body &body, const Pose &pose)
        {
            for (std::size_t i = 0; i < scene.getObstacles().size(); ++i)
                if (FclObstacles({scene.getObstacles()[i]}, scene.getDimension(), zInterval).collides(body, pose))
                    return scene.getObstacleTitles()[i];
            for (std::size_t i = 0; i < scene.getSensedObstacles().size(); ++i)
                if (scene.getSensedObstacles()[i]->collides(body, pose))
                    return scene.getSensedTitles()[i];
            return "an obstacle";
        }

        /** What \e robot touches of \e obstacles, all of the scene's, as SceneCollision::touch; empty if nothing */
        std::string describeTouch(const Scene &scene, const Obstacles &obstacles, const ZInterval &zInterval,
                                  const Robot &robot, const std::vector<Pose> &poses)
        {
            for (std::size_t i = 0; i < poses.size(); ++i)
            {
                if (robot.mayTouchObstacles(i))
                    continue;
                const Body &body = robot.getBodies()[i];
                const Touching contact = obstacles.touches(body, poses[i]);
                if (contact == Touching::UNKNOWN ? !obstacles.collides(body, poses[i]) : contact != Touching::YES)
                    continue;
                const std::string name = nameOfBody(robot, i);
                return "touches " + nameOfObstacle(scene, zInterval, body, poses[i]) +
                       (name.empty() ? "" : " with " + name);
            }
            return "";
        }
    }

    std::optional<SceneCollision> findCollision(const Scene &scene, const TeamStateSpacePtr &team,
                                                const ob::State *state)
    {
        const unsigned int count = team->getRobotCount();
        const auto *components = state->as<TeamStateSpace::StateType>()->components;
        const ObstaclesPtr obstacles = scene.makeObstacles();
        std::vector<std::vector<Pose>> poses;
        for (unsigned int i = 0; i < count; ++i)
        {
            const Robot &robot = team->getRobot(i);
            poses.emplace_back(robot.getBodies().size());
            robot.placeBodies(components[i], poses.back().data());
            // FCL must not be asked about it.
            if (!std::all_of(poses.back().begin(), poses.back().end(), [](const Pose &pose) { return isFinite(pose); }))
                return SceneCollision{SceneCollision::OBSTACLES, i, i, "has a number that is not finite", "", ""};
            const std::string touch = describeTouch(scene, *obstacles, team->getZInterval(), robot, poses.back());
            if (!touch.empty())
                return SceneCollision{SceneCollision::OBSTACLES, i, i, touch, "", ""};
        }
        const TeamValidityChecker checker(std::make_shared<ob::SpaceInformation>(team), obstacles, Method::STANDARD);
        // The obstacles leave each robot free.
        for (unsigned int i = 0; i < count; ++i)
            if (!checker.isRobotFree(i, components[i]))
            {
                const Robot &robot = team->getRobot(i);
                if (const std::string touch = describeTouch(robot, poses[i]); !touch.empty())
                    return SceneCollision{SceneCollision::OBSTACLES, i, i, touch, "", ""};
                return SceneCollision{
                    SceneCollision::ITSELF, i, i, "", describeBodies(robot, poses[i], robot, poses[i]), ""};
            }
        for (unsigned int i = 0; i < count; ++i)
            for (unsigned int k = i + 1; k < count; ++k)
                if (!checker.isPairFree(i, components[i], k, components[k]))
                {
                    const Robot &robot = team->getRobot(i), &other = team->getRobot(k);
                    return SceneCollision{SceneCollision::ROBOT,
                                          i,
                                          k,
                                          "",
                                          describeBodies(robot, poses[i], other, poses[k]),
                                          hintOn(robot, poses[i], other, poses[k])};
                }
        return std::nullopt;
    }
}
