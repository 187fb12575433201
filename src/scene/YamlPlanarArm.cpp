#include "YamlPlanarArm.h"

#include "YamlArms.h"
#include "YamlGoal.h"
#include "YamlLinkPose.h"
#include "YamlShapes.h"
#include "ompl_certificates/robots/Arm.h"

namespace ompl_certificates
{
    namespace
    {
        using Joint = KinematicTree::Joint;
        using JointType = KinematicTree::JointType;

        /** The body of a link, in the frame of its joint: it lies along x, to the next joint. */
        Body readLink(const YamlNode &node, YamlMeshes &meshes)
        {
            const double length = node.at("length").positive();
            std::vector<std::string> given;
            for (const std::string key : {"width", "radius", "shape", "shapes"})
                if (node.has(key))
                    given.push_back(key);
            if (given.empty())
                node.fail("give the link's width, radius, shape or shapes");
            if (given.size() > 1)
                node.at(given.back()).fail("give either " + given.front() + " or " + given.back());
            if (given.front() == "shape" || given.front() == "shapes")
                return readBody(node, 2, meshes);
            const Body body = given.front() == "width" ? Body::box(length, node.at("width").positive())
                                                       : Body::planarCapsule(node.at("radius").positive(), length);
            return Body::join({{body, planarPose(0.5 * length, 0.0)}});
        }

        Joint readJoint(const YamlNode &node, const std::string &name, double lengthBefore)
        {
            Joint joint{name, JointType::CONTINUOUS, planarPose(lengthBefore, 0.0)};
            if (!node.has("limits"))
                return joint;
            const std::vector<double> limits = node.at("limits").numbers(2);
            if (!(limits[1] - limits[0] >= YamlNode::MIN_SIZE))
                node.at("limits").fail("the lower one must be below the upper one");
            joint.type = JointType::REVOLUTE;
            joint.lower = limits[0];
            joint.upper = limits[1];
            return joint;
        }

        /** All links may collide but those that a joint connects. */
        std::vector<std::pair<std::string, std::string>> namedPairsOf(const KinematicTree &tree)
        {
            const auto &links = tree.getLinks();
            std::vector<std::pair<std::string, std::string>> pairs;
            for (std::size_t i = 1; i < links.size(); ++i)
                for (std::size_t k = i + 2; k < links.size(); ++k)
                    pairs.emplace_back(links[i].name, links[k].name);
            return pairs;
        }

        std::vector<double> readAngles(const YamlNode &node, const KinematicTree &tree)
        {
            const std::size_t count = tree.getLinks().size() - 1;
            std::vector<double> angles = node.numbers(count);
            const auto items = node.items(count, count);
            for (std::size_t i = 0; i < count; ++i)
                angles[i] = checkedJointValue(items[i], tree.getLinks()[i + 1].joint, angles[i]);
            return angles;
        }
    }

    void readPlanarArm(const YamlNode &node, const std::string &name, YamlMeshes &meshes, Scene::Member &member)
    {
        ArmOptions options;
        if (node.has("base"))
        {
            node.at("base").allow({"center", "angle"});
            options.base = readPose(node.at("base"), 2, false);
        }
        KinematicTree tree("base");
        std::vector<std::string> joints;
        std::string parent = "base";
        double length = 0.0;  // of the link before
        for (const YamlNode &link : node.at("links").items(1, Arm::MAX_JOINTS))
        {
            link.allow({"length", "width", "radius", "shape", "shapes", "limits"});
            const std::string number = std::to_string(joints.size() + 1);
            joints.push_back("joint_" + number);
            tree.addLink(parent, readJoint(link, joints.back(), length), "link_" + number, readLink(link, meshes));
            parent = "link_" + number;
            length = link.at("length").number();
        }
        if (!node.has("self_collision") || node.at("self_collision").boolean())
            options.linkPairs = namedPairsOf(tree);
        std::map<std::string, double> paddings;
        for (const KinematicTree::Link &link : tree.getLinks())
            paddings.emplace(link.name, readPadding(node));
        tree = tree.padded(paddings);
        const auto arm =
            node.at("links").orFail([&] { return std::make_shared<const Arm>(name, tree, joints, options); });
        member.robot = arm;
        member.start = readAngles(node.at("start"), tree);
        readGoal(
            node.at("goal"), [&](const YamlNode &state) { return readAngles(state, tree); },
            [&](const YamlNode &goal) { return readLinkPoseGoal(goal, arm); }, member);
    }
}
