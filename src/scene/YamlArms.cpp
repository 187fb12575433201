#include "YamlArms.h"

#include "YamlShapes.h"

#include <algorithm>
#include <cmath>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        using Joint = KinematicTree::Joint;
        using JointType = KinematicTree::JointType;
        using Values = std::map<std::string, double>;

        constexpr std::size_t MAX_ATTACHED = 100, MAX_COORDINATES = Arm::MAX_JOINTS;

        Pose readPose(const YamlNode &node)
        {
            Pose pose = Pose::Identity();
            if (node.has("position"))
                pose.translation() = Eigen::Map<const Eigen::Vector3d>(node.at("position").numbers(3).data());
            pose.linear() = readRotation(node);
            return pose;
        }

        bool hasOneValue(const Joint &joint)
        {
            return joint.type == JointType::REVOLUTE || joint.type == JointType::CONTINUOUS ||
                   joint.type == JointType::PRISMATIC;
        }

        /** \e value, if the joint can have it; angles without limits are brought into [-pi, pi). */
        double checked(const YamlNode &node, const Joint &joint, double value)
        {
            if (joint.type == JointType::CONTINUOUS)
            {
                if (value >= -M_PI && value < M_PI)
                    return value;
                value = std::remainder(value, 2.0 * M_PI);
                return value < M_PI ? value : -M_PI;
            }
            if (value < joint.lower || value > joint.upper)
                node.fail("joint '" + joint.name + "' must be from " + std::to_string(joint.lower) + " to " +
                          std::to_string(joint.upper) + ", not " + std::to_string(value));
            return value;
        }

        const Joint &jointOf(const YamlNode &node, const KinematicTree &tree, const std::string &name)
        {
            if (!tree.hasJoint(name))
                node.fail("there is no joint '" + name + "'");
            return tree.getLinks()[tree.getChildOf(name)].joint;
        }

        /** The values of joints that \e node lists by their names */
        Values readValues(const YamlNode &node, const KinematicTree &tree)
        {
            Values values;
            for (const std::string &name : node.keys())
            {
                const Joint &joint = jointOf(node, tree, name);
                if (!hasOneValue(joint))
                    node.at(name).fail("joint '" + name + "' has not one value");
                if (joint.mimic)
                    node.at(name).fail("joint '" + name + "' follows joint '" + joint.mimic->joint + "'");
                values[name] = checked(node.at(name), joint, node.at(name).number());
            }
            return values;
        }

        /** A start or a goal: a list of coordinates, joints with their values, or the name of a state of the group */
        std::vector<double> readState(const YamlNode &node, const ArmFile &file, const std::string &group,
                                      const Arm &arm)
        {
            std::vector<const Joint *> joints;
            std::size_t coordinates = 0;
            for (const std::string &name : arm.getGroup())
            {
                joints.push_back(&jointOf(node, arm.getTree(), name));
                coordinates += joints.back()->type == JointType::PLANAR     ? 3
                               : joints.back()->type == JointType::FLOATING ? 7
                                                                            : 1;
            }
            std::vector<double> state;
            if (node.isList())
            {
                state = node.numbers(coordinates);
                const auto items = node.items(0, MAX_COORDINATES);
                std::size_t i = 0;
                for (const Joint *joint : joints)
                {
                    if (hasOneValue(*joint))
                        state[i] = checked(items[i], *joint, state[i]);
                    if (joint->type == JointType::PLANAR)
                        state[i + 2] = std::remainder(state[i + 2], 2.0 * M_PI);
                    if (joint->type == JointType::FLOATING)
                    {
                        Eigen::Map<Eigen::Vector4d> turn(state.data() + i + 3);
                        if (!(turn.norm() >= YamlNode::MIN_SIZE))
                            items[i + 3].fail("the quaternion of joint '" + joint->name + "' must not be zero");
                        turn.normalize();
                    }
                    i += joint->type == JointType::PLANAR ? 3 : joint->type == JointType::FLOATING ? 7 : 1;
                }
                return state;
            }
            Values values;
            if (node.isMap())
                values = readValues(node, arm.getTree());
            else
                try
                {
                    values = file.getState(group, node.text());
                }
                catch (const ompl::Exception &exception)
                {
                    node.fail(exception.what());
                }
            for (const Joint *joint : joints)
            {
                const auto value = values.find(joint->name);
                if (value == values.end())
                    node.fail("has no value of joint '" + joint->name + "'" +
                              (hasOneValue(*joint) ? "" : "; list all coordinates instead"));
                state.push_back(checked(node, *joint, value->second));
                values.erase(value);
            }
            // A state may also tell of joints that follow others.
            for (const auto &[name, value] : values)
                if (node.isMap())
                    node.at(name).fail("joint '" + name + "' is not in the group");
            return state;
        }

        AttachedBody readAttached(const YamlNode &node, YamlMeshes &meshes)
        {
            node.allow({"name", "link", "shape", "shapes", "position", "rotation", "quaternion", "touch_links"});
            AttachedBody body{node.at("name").text(), node.at("link").text(), readBody(node, 3, meshes),
                              readPose(node)};
            if (node.has("touch_links"))
                for (const YamlNode &link : node.at("touch_links").items(0, 1000))
                    body.touchLinks.push_back(link.text());
            return body;
        }
    }

    YamlArms::YamlArms(const std::string &source) : folder_(std::filesystem::path(source).parent_path())
    {
    }

    std::string YamlArms::pathOf(const YamlNode &node) const
    {
        return (folder_ / node.text()).lexically_normal().string();
    }

    const ArmFile &YamlArms::fileOf(const YamlNode &node)
    {
        const std::string urdf = pathOf(node.at("file")), srdf = node.has("srdf") ? pathOf(node.at("srdf")) : "";
        ArmFile::Options options;
        options.useVisuals = node.has("visuals") && node.at("visuals").boolean();
        std::string key = urdf + '\n' + srdf + (options.useVisuals ? "\nvisuals" : "");
        if (node.has("packages"))
            for (const std::string &name : node.at("packages").keys())
            {
                options.packages[name] = pathOf(node.at("packages").at(name));
                key += '\n' + name + '\n' + options.packages[name];
            }
        if (const auto known = files_.find(key); known != files_.end())
            return known->second;
        try
        {
            return files_.emplace(key, ArmFile(urdf, srdf, options)).first->second;
        }
        catch (const ompl::Exception &exception)
        {
            node.at("file").fail(exception.what());
        }
    }

    void YamlArms::read(const YamlNode &node, const std::string &name, const ompl::base::RealVectorBounds &bounds,
                        Scene &scene, YamlMeshes &meshes, Scene::Member &member)
    {
        const ArmFile &file = fileOf(node);
        const std::string group = node.has("group") ? node.at("group").text() : "";
        ArmFile::ArmSettings settings;
        settings.bounds = bounds;
        if (node.has("base"))
        {
            node.at("base").allow({"position", "rotation", "quaternion"});
            settings.base = readPose(node.at("base"));
        }
        if (node.has("states"))
            for (const std::string &other : node.at("states").keys())
            {
                const YamlNode state = node.at("states").at(other);
                try
                {
                    for (const auto &[joint, value] : file.getState(other, state.text()))
                        if (file.getTree().hasJoint(joint) && hasOneValue(jointOf(state, file.getTree(), joint)))
                            settings.jointValues[joint] = value;
                }
                catch (const ompl::Exception &exception)
                {
                    state.fail(exception.what());
                }
            }
        if (node.has("joints"))
            for (const auto &[joint, value] : readValues(node.at("joints"), file.getTree()))
                settings.jointValues[joint] = value;
        if (node.has("attached"))
            for (const YamlNode &item : node.at("attached").items(0, MAX_ATTACHED))
                settings.attached.push_back(readAttached(item, meshes));
        std::shared_ptr<const Arm> arm;
        try
        {
            std::vector<std::string> notes;
            arm = file.makeArm(name, group, settings, &notes);
            for (const std::string &note : notes)
                scene.addNote(note);
        }
        catch (const ompl::Exception &exception)
        {
            node.fail(exception.what());
        }
        for (const std::string &joint : arm->getGroup())
            if (node.has("joints") && node.at("joints").has(joint))
                node.at("joints").at(joint).fail("joint '" + joint + "' is in the group, so start and goal tell it");
        member.start = readState(node.at("start"), file, group, *arm);
        member.goal = readState(node.at("goal"), file, group, *arm);
        member.robot = arm;
    }
}
