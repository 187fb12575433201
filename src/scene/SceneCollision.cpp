#include "SceneCollision.h"

#include "robots/ContactText.h"
#include "robots/PairPadding.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/robots/Arm.h"

#include <algorithm>
#include <utility>

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

        /** The bodies of two robots that touch each other, or of one; none if none is found */
        std::optional<BodyPair> findContact(const Robot &first, const std::vector<Pose> &poses, const Robot &second,
                                            const std::vector<Pose> &others)
        {
            const bool alone = &first == &second;
            std::vector<BodyPair> pairs = alone ? first.getBodyPairs() : std::vector<BodyPair>();
            for (std::size_t i = 0; !alone && i < poses.size(); ++i)
                for (std::size_t k = 0; k < others.size(); ++k)
                    if (first.mayCollide(i, second, k) && second.mayCollide(k, first, i))
                        pairs.push_back({i, k});
            // Obstacles that count for a robot alone come first.
            std::stable_partition(pairs.begin(), pairs.end(),
                                  [&](const BodyPair &pair) {
                                      return alone &&
                                             (isOwnObstacle(first, pair.first) || isOwnObstacle(first, pair.second));
                                  });
            for (const BodyPair &pair : pairs)
            {
                const PlacedBody other{second.getBodies()[pair.second].withoutPadding(), others[pair.second]};
                const Body body =
                    first.getBodies()[pair.first].padded(paddingBetween(first, pair.first, second, pair.second));
                if (FclObstacles({other}, other.body.getDimension()).collides(body, poses[pair.first]))
                    return pair;
            }
            return std::nullopt;
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
                return describeTouch(robot, i, nameOfObstacle(scene, zInterval, body, poses[i]));
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
        // Another thread may set up the team's space, whose parameters a SpaceInformation reads.
        const auto own = std::make_shared<TeamStateSpace>();
        for (unsigned int i = 0; i < count; ++i)
            own->addRobot(team->getRobots()[i]);
        // First of all, since threads share what it prepares of large meshes.
        const TeamValidityChecker checker(std::make_shared<ob::SpaceInformation>(own), obstacles, Method::STANDARD);
        std::vector<std::vector<Pose>> poses;
        for (unsigned int i = 0; i < count; ++i)
        {
            const Robot &robot = team->getRobot(i);
            poses.emplace_back(robot.getBodies().size());
            robot.placeBodies(components[i], poses.back().data());
            // FCL must not be asked about it.
            if (!std::all_of(poses.back().begin(), poses.back().end(), [](const Pose &pose) { return isFinite(pose); }))
                return SceneCollision{i, i, "has a number that is not finite", "", ""};
            const std::string touch = describeTouch(scene, *obstacles, team->getZInterval(), robot, poses.back());
            if (!touch.empty())
                return SceneCollision{i, i, touch, "", ""};
        }
        // The obstacles leave each robot free.
        for (unsigned int i = 0; i < count; ++i)
            if (!checker.isRobotFree(i, components[i]))
            {
                const Robot &robot = team->getRobot(i);
                const auto contact = findContact(robot, poses[i], robot, poses[i]);
                return SceneCollision{i, i, contact ? describeOwnContact(robot, *contact) : "touches itself", "", ""};
            }
        for (unsigned int i = 0; i < count; ++i)
            for (unsigned int k = i + 1; k < count; ++k)
                if (!checker.isPairFree(i, components[i], k, components[k]))
                {
                    const Robot &robot = team->getRobot(i), &other = team->getRobot(k);
                    const auto contact = findContact(robot, poses[i], other, poses[k]);
                    return SceneCollision{i, k, "",
                                          contact ? describeContact(robot, contact->first, other, contact->second) : "",
                                          hintOn(robot, poses[i], other, poses[k])};
                }
        return std::nullopt;
    }
}
