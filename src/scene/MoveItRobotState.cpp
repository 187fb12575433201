#include "MoveItRobotState.h"

#include "MoveItMessages.h"
#include "SrdfReader.h"
#include "YamlShapes.h"
#include "robots/JointTypes.h"

#include <cmath>
#include <set>

namespace ompl_certificates
{
    namespace
    {
        AttachedBody readAttached(const YamlNode &node, const KinematicTree &tree, const std::string &folder,
                                  std::map<std::string, std::vector<std::string>> &notes)
        {
            node.allow({"link_name", "object", "touch_links", "detach_posture", "weight"});
            AttachedBody attached{"", node.at("link_name").text(), Body::sphere(0.0)};
            node.at("link_name").orFail([&] { return tree.getLinkIndex(attached.link); });
            refuse(node.at("object"), {"planes", "plane_poses"});
            std::vector<std::string> about;
            const MoveItObject object = readMoveItObject(node.at("object"), folder, about);
            if (object.frame != attached.link)
                node.at("object").fail("must be in the frame of its link, '" + attached.link + "': " +
                                       (object.frame.empty()
                                            ? "it has no header.frame_id"
                                            : "others, such as '" + object.frame + "', are not supported"));
            if (tree.hasLink(object.name))
                node.at("object").at("id").fail("there is a link '" + object.name + "' already");
            attached.name = object.name;
            auto &told = notes[attached.name];
            told.insert(told.end(), about.begin(), about.end());
            attached.pose = object.pose;
            std::vector<PlacedBody> bodies;
            for (const MoveItObject::Placed &placed : object.shapes)
                bodies.push_back({placed.shape.body, object.pose.inverse() * placed.shape.pose});
            attached.body = Body::join(bodies);
            for (const YamlNode &link : moveItItems(node, "touch_links"))
            {
                // Others make no difference to MoveIt either.
                if (const std::string name = link.text(); tree.hasLink(name))
                    attached.touchLinks.push_back(name);
                else
                    told.push_back("attached object '" + attached.name + "': touch_links: there is no link '" + name +
                                   "'");
            }
            return attached;
        }

        void readJointState(const YamlNode &node, const KinematicTree &tree, MoveItRobotState &state)
        {
            node.allow({"header", "name", "position", "velocity", "effort"});
            const auto names = moveItItems(node, "name");
            std::vector<double> values;
            std::vector<YamlNode> positions;
            if (!names.empty() || node.has("position"))
            {
                values = node.at("position").numbers(names.size());
                positions = moveItItems(node, "position");
            }
            std::set<std::string> seen;
            for (std::size_t i = 0; i < names.size(); ++i)
            {
                const std::string name = names[i].text();
                const std::size_t child = names[i].orFail([&] { return tree.getChildOf(name); });
                if (!seen.insert(name).second)
                    names[i].fail("'" + name + "' is given twice");
                // MoveIt's messages may list fixed joints, too.
                const KinematicTree::JointType type = tree.getLinks()[child].joint.type;
                if (type != KinematicTree::JointType::FIXED)
                    state.joints.emplace(name, MoveItNumber{values[i], positions[i]});
            }
        }

        bool isNoTransform(const Pose &pose)
        {
            return (pose.matrix() - Pose::Identity().matrix()).cwiseAbs().maxCoeff() <= FILE_ROUNDING;
        }

        /** Where \e joint brings the root, which is \e base but for what files round */
        Pose reachedBy(const VirtualJoint &joint, const Pose &base, const YamlNode &node)
        {
            const std::string title = "the SRDF file's virtual joint '" + joint.name + "' is ";
            if (joint.type == KinematicTree::JointType::FIXED)
            {
                if (!isNoTransform(base))
                    node.fail("must be no transform: " + title + "fixed");
                return Pose::Identity();
            }
            if (joint.type == KinematicTree::JointType::FLOATING)
                return base;
            const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
            if (!(std::abs(base.translation().z()) <= FILE_ROUNDING &&
                  (base.linear() * up - up).norm() <= FILE_ROUNDING))
                node.fail("must neither lift nor tilt the robot: " + title + "planar");
            return planarPose(base.translation().x(), base.translation().y(),
                              std::atan2(base.linear()(1, 0), base.linear()(0, 0)));
        }

        /** Where the robot stands: the transform of the joint between its root and the world */
        void readBase(const YamlNode &node, const ArmFile &robot, MoveItRobotState &state)
        {
            node.allow({"header", "joint_names", "transforms", "twist", "wrench"});
            const auto names = moveItItems(node, "joint_names"), transforms = moveItItems(node, "transforms");
            if (names.size() != transforms.size())
                node.fail("must have as many transforms as joint_names, " + std::to_string(names.size()) + ", not " +
                          std::to_string(transforms.size()));
            if (names.size() > 1)
                names[1].fail("more than one joint of several degrees of freedom is not supported");
            if (names.empty())
                return;
            const std::string name = names.front().text();
            if (robot.getTree().hasJoint(name))
                names.front().fail("joints of several degrees of freedom are not supported but that of the root");
            const Pose base = readMoveItTransform(transforms.front());
            const auto joint = robot.getVirtualJoint();
            if (joint && name == joint->name)
                state.base = reachedBy(*joint, base, transforms.front());
            else if (!joint)
                // The file alone says how the root is joined to the world.
                state.base = base;
            else if (!isNoTransform(base))
                names.front().fail("there is no joint '" + name + "'; the SRDF file's virtual joint is '" +
                                   joint->name + "'");
        }
    }

    MoveItRobotState readMoveItRobotState(const YamlNode &node, const ArmFile &robot, const std::string &folder)
    {
        const KinematicTree &tree = robot.getTree();
        node.allow({"joint_state", "multi_dof_joint_state", "attached_collision_objects", "is_diff"});
        MoveItRobotState state;
        const bool isDifference = !node.has("is_diff") || node.at("is_diff").boolean();
        if (node.has("joint_state"))
            readJointState(node.at("joint_state"), tree, state);
        if (node.has("multi_dof_joint_state"))
            readBase(node.at("multi_dof_joint_state"), robot, state);
        // As in MoveIt, a message that names no joint changes nothing.
        state.isWhole = !isDifference && (!state.joints.empty() || state.base);
        for (const YamlNode &item : moveItItems(node, "attached_collision_objects"))
            state.attached.push_back(readAttached(item, tree, folder, state.notes));
        return state;
    }

    double moveItValueUntold(const KinematicTree::Joint &joint)
    {
        return isLimited(joint.type) && (joint.lower > 0.0 || joint.upper < 0.0) ? 0.5 * (joint.lower + joint.upper)
                                                                                 : 0.0;
    }

    double moveItValue(const MoveItRobotState &state, const KinematicTree &tree, const KinematicTree::Joint &joint)
    {
        if (joint.mimic)
            return joint.mimic->offset +
                   joint.mimic->multiplier *
                       moveItValue(state, tree, tree.getLinks()[tree.getChildOf(joint.mimic->joint)].joint);
        const auto told = state.joints.find(joint.name);
        return told != state.joints.end() ? told->second.value : moveItValueUntold(joint);
    }

    std::map<std::string, double> readMoveItPadding(const YamlNode &root, const KinematicTree &tree)
    {
        for (const YamlNode &item : moveItItems(root, "link_scale"))
        {
            item.allow({"link_name", "scale"});
            if (item.at("scale").number() != 1.0)
                item.at("scale").fail("is not supported but as 1");
        }
        std::map<std::string, double> paddings;
        for (const YamlNode &item : moveItItems(root, "link_padding"))
        {
            item.allow({"link_name", "padding"});
            const YamlNode link = item.at("link_name");
            link.orFail([&] { return tree.getLinkIndex(link.text()); });
            if (!paddings.emplace(link.text(), readDistance(item.at("padding"))).second)
                link.fail("has a padding already");
        }
        return paddings;
    }
}
