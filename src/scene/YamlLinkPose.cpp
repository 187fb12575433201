#include "YamlLinkPose.h"

#include "YamlShapes.h"

#include <algorithm>
#include <array>

namespace ompl_certificates
{
    namespace
    {
        /** What a pose of a link may have, in the plane or in space */
        constexpr std::array KEYS{"link",     "point", "position",   "position_tolerance",
                                  "rotation", "angle", "quaternion", "rotation_tolerance"};

        /** A point of the workspace, which may be planar */
        Eigen::Vector3d readPoint(const YamlNode &node, unsigned int dimension)
        {
            const std::vector<double> numbers = node.numbers(dimension);
            return {numbers[0], numbers[1], dimension == 3 ? numbers[2] : 0.0};
        }

        /** One tolerance for all axes, or one for each of \e count */
        Eigen::Vector3d readTolerance(const YamlNode &node, std::size_t count, double otherwise)
        {
            Eigen::Vector3d tolerance = Eigen::Vector3d::Constant(otherwise);
            if (!node.isList())
                tolerance.setConstant(node.positive());
            else
            {
                const std::vector<double> numbers = node.positives(count);
                std::copy(numbers.begin(), numbers.end(), tolerance.data());
            }
            return tolerance;
        }

        void refuseAlone(const YamlNode &node, const std::string &key, const std::string &needed)
        {
            if (node.has(key))
                node.at(key).fail("needs " + needed);
        }

        LinkPose readLinkPose(const YamlNode &node, unsigned int dimension)
        {
            const bool planar = dimension == 2;
            const std::string turn = planar ? "angle" : "rotation";
            std::vector<std::string> keys{
                "link", "point", "position", "position_tolerance", turn, "rotation_tolerance"};
            if (!planar)
                keys.emplace_back("quaternion");
            node.allow(keys);
            LinkPose pose{node.at("link").text()};
            if (node.has("position"))
            {
                pose.position = LinkPose::Position{readPoint(node.at("position"), dimension)};
                if (node.has("point"))
                    pose.point = readPoint(node.at("point"), dimension);
                if (node.has("position_tolerance"))
                    pose.position->tolerance =
                        readTolerance(node.at("position_tolerance"), dimension, LinkPose::DEFAULT_POSITION_TOLERANCE);
            }
            else
                for (const char *key : {"point", "position_tolerance"})
                    refuseAlone(node, key, "a position");
            if (node.has(turn) || node.has("quaternion"))
            {
                pose.rotation = LinkPose::Rotation{planar ? planarPose(0.0, 0.0, node.at("angle").number()).linear()
                                                          : readRotation(node)};
                if (node.has("rotation_tolerance"))
                {
                    if (planar && node.at("rotation_tolerance").isList())
                        node.at("rotation_tolerance").fail("must be one number in the plane");
                    pose.rotation->tolerance = readTolerance(node.at("rotation_tolerance"), 3, 0.0);
                }
            }
            else
                refuseAlone(node, "rotation_tolerance", planar ? "an angle" : "a rotation or a quaternion");
            return pose;
        }

        bool isLinkPose(const YamlNode &node, const KinematicTree &tree)
        {
            return node.isMap() && std::any_of(KEYS.begin(), KEYS.end(),
                                               [&](const char *key) { return node.has(key) && !tree.hasJoint(key); });
        }
    }

    RobotGoalPtr readLinkPoseGoal(const YamlNode &node, const std::shared_ptr<const Arm> &arm)
    {
        if (!isLinkPose(node, arm->getTree()))
            return nullptr;
        const LinkPose pose = readLinkPose(node, arm->getWorkspaceDimension());
        return node.orFail([&] { return std::make_shared<LinkPoseGoal>(arm, pose); });
    }
}
