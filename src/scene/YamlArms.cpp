#include "YamlArms.h"

#include "geometry/Angle.h"
#include "geometry/ShortestText.h"
#include "robots/JointTypes.h"
#include "YamlAttached.h"
#include "YamlGoal.h"
#include "YamlLinkPose.h"
#include "YamlRobots.h"
#include "YamlShapes.h"

#include <algorithm>
#include <sstream>

namespace ompl_certificates
{
    namespace
    {
        using Joint = KinematicTree::Joint;
        using JointType = KinematicTree::JointType;
        using Values = std::map<std::string, double>;

        constexpr std::size_t MAX_COORDINATES = Arm::MAX_JOINTS;

        bool hasOneValue(const Joint &joint)
        {
            return coordinatesOf(joint.type) == 1;
        }

        const Joint &jointOf(const YamlNode &node, const KinematicTree &tree, const std::string &name)
        {
            return tree.getLinks()[node.orFail([&] { return tree.getChildOf(name); })].joint;
        }

        void checkLimits(const YamlNode &node, const Joint &joint, double value)
        {
            if (joint.type != JointType::CONTINUOUS && (value < joint.lower || value > joint.upper))
                node.fail("joint '" + joint.name + "' must be from " + shortestText(joint.lower) + " to " +
                          shortestText(joint.upper) + ", not " + shortestText(value));
        }

        /** The values of joints that \e node lists by their names, angles as they are: a joint may follow half of one.
            */
        Values readValues(const YamlNode &node, const KinematicTree &tree)
        {
            Values values;
            for (const std::string &name : node.keys())
            {
                const Joint &joint = jointOf(node, tree, name);
                if (!hasOneValue(joint))
                    node.at(name).fail("joint '" + name + "' has not one value: it is fixed, or moves in several ways");
                if (joint.mimic)
                    node.at(name).fail("joint '" + name + "' follows joint '" + joint.mimic->joint + "'");
                values[name] = node.at(name).number();
                checkLimits(node.at(name), joint, values[name]);
            }
            return values;
        }

        /** The coordinates that \e node lists, of \e joints one after another */
        std::vector<double> readCoordinates(const YamlNode &node, const std::vector<const Joint *> &joints)
        {
            std::size_t count = 0;
            for (const Joint *joint : joints)
                count += coordinatesOf(joint->type);
            std::vector<double> state = node.numbers(count);
            const auto items = node.items(0, MAX_COORDINATES);
            std::size_t i = 0;
            for (const Joint *joint : joints)
            {
                if (hasOneValue(*joint))
                    state[i] = checkedJointValue(items[i], *joint, state[i]);
                if (joint->type == JointType::PLANAR)
                    state[i + 2] = wrappedAngle(state[i + 2]);
                if (joint->type == JointType::FLOATING)
                {
                    Eigen::Map<Eigen::Vector4d> turn(state.data() + i + 3);
                    if (!(turn.norm() >= YamlNode::MIN_SIZE))
                        items[i + 3].fail("the quaternion of joint '" + joint->name + "' must not be zero");
                    turn.normalize();
                }
                i += coordinatesOf(joint->type);
            }
            return state;
        }

        /** The value of each of \e joints: \e node has them by their names, or names a state of the group. */
        std::vector<double> readNamedValues(const YamlNode &node, const ArmFile &file, const std::string &group,
                                            const KinematicTree &tree, const std::vector<const Joint *> &joints)
        {
            Values values;
            if (node.isMap())
                values = readValues(node, tree);
            else
                values = node.orFail([&] { return file.getState(group, node.text()); });
            std::vector<double> state;
            for (const Joint *joint : joints)
            {
                const auto value = values.find(joint->name);
                if (value == values.end())
                    node.fail("has no value of joint '" + joint->name + "'" +
                              (hasOneValue(*joint) ? "" : "; list all coordinates instead"));
                state.push_back(checkedJointValue(node, *joint, value->second));
                values.erase(value);
            }
            // A state may also tell of joints that follow others.
            for (const auto &[name, value] : values)
                if (node.isMap())
                    node.at(name).fail("joint '" + name + "' is not in the group");
            return state;
        }

        /** A start or a goal: a list of coordinates, joints with their values, or the name of a state of the group */
        std::vector<double> readState(const YamlNode &node, const ArmFile &file, const std::string &group,
                                      const Arm &arm)
        {
            std::vector<const Joint *> joints;
            for (const std::string &name : arm.getGroup())
                joints.push_back(&jointOf(node, arm.getTree(), name));
            return node.isList() ? readCoordinates(node, joints)
                                 : readNamedValues(node, file, group, arm.getTree(), joints);
        }

        Pose baseOf(const YamlNode &robot)
        {
            if (!robot.has("base"))
                return Pose::Identity();
            robot.at("base").allow({"position", "rotation", "quaternion"});
            return readFrame(robot.at("base"));
        }

        std::string groupOf(const YamlNode &robot)
        {
            return robot.has("group") ? robot.at("group").text() : "";
        }

        /** Read the paddings of a part; \e first is the name of the first one, if this is another. */
        void readPaddings(const YamlNode &node, const std::string *first, const KinematicTree &tree,
                          ArmFile::ArmSettings &settings)
        {
            const double padding = readPadding(node);
            if (first && padding != settings.padding)
                (node.has("padding") ? node.at("padding") : node)
                    .fail("the padding must be that of robot '" + *first +
                          "', which is of the same mechanism: " + shortestText(settings.padding));
            settings.padding = padding;
            if (!node.has("link_padding"))
                return;
            const YamlNode links = node.at("link_padding");
            for (const std::string &link : links.keys())
            {
                if (std::none_of(settings.attached.begin(), settings.attached.end(),
                                 [&link](const AttachedBody &body) { return body.name == link; }))
                    links.at(link).orFail([&] { return tree.getLinkIndex(link); });
                const double own = readDistance(links.at(link));
                if (const double known = settings.linkPadding.emplace(link, own).first->second; known != own)
                    links.at(link).fail("must be " + shortestText(known) + ", as for another robot of the mechanism");
            }
        }

        /** Require that the bounds of a part are \e bounds, those of the first part. */
        void requireBounds(const YamlNode &node, const ompl::base::RealVectorBounds &bounds, const std::string &first)
        {
            const ompl::base::RealVectorBounds own = readBounds(node, static_cast<unsigned int>(bounds.low.size()));
            if (own.low != bounds.low || own.high != bounds.high)
                node.fail("must be those of '" + first + "', which has the same file and base");
        }
    }

    double checkedJointValue(const YamlNode &node, const KinematicTree::Joint &joint, double value)
    {
        if (joint.type == JointType::CONTINUOUS)
            return wrappedAngle(value);
        checkLimits(node, joint, value);
        return value;
    }

    YamlArms::YamlArms(std::vector<YamlNode> robots) : robots_(std::move(robots))
    {
    }

    std::string YamlArms::keyOf(const YamlNode &node, ArmFile::Options &options) const
    {
        options.useVisuals = node.has("visuals") && node.at("visuals").boolean();
        std::string key = node.at("file").pathBesideFile() + '\n' +
                          (node.has("srdf") ? node.at("srdf").pathBesideFile() : "") +
                          (options.useVisuals ? "\nvisuals" : "");
        if (node.has("packages"))
            for (const std::string &name : node.at("packages").keys())
            {
                options.packages[name] = node.at("packages").at(name).pathBesideFile();
                key += '\n' + name + '\n' + options.packages[name];
            }
        return key;
    }

    const ArmFile &YamlArms::fileOf(const YamlNode &node)
    {
        ArmFile::Options options;
        const std::string key = keyOf(node, options);
        if (const auto known = files_.find(key); known != files_.end())
            return known->second;
        const std::string urdf = node.at("file").pathBesideFile(),
                          srdf = node.has("srdf") ? node.at("srdf").pathBesideFile() : "";
        try
        {
            return files_.emplace(key, ArmFile(urdf, srdf, options)).first->second;
        }
        catch (const ompl::Exception &exception)
        {
            // It begins with the name of the file that is wrong.
            const std::string message = exception.what();
            node.at(!srdf.empty() && message.rfind(srdf + ":", 0) == 0 ? "srdf" : "file").fail(message);
        }
    }

    bool YamlArms::standsStill(const YamlNode &node)
    {
        const ArmFile &file = fileOf(node);
        return node.orFail(
            [&]
            {
                // A joint of the group that the tree does not have is the virtual one, which moves the root.
                const auto &joints = file.getJoints(groupOf(node));
                return std::all_of(joints.begin(), joints.end(),
                                   [&](const std::string &joint) { return file.getTree().hasJoint(joint); });
            });
    }

    std::vector<std::size_t> YamlArms::partsWith(std::size_t robot)
    {
        const auto keyOfMechanism = [this](const YamlNode &node)
        {
            ArmFile::Options options;
            std::ostringstream key;
            // 0 in place of -0, which is equal but written in another way
            key << keyOf(node, options) << std::hexfloat << '\n' << (baseOf(node).matrix().array() + 0.0).matrix();
            return key.str();
        };
        if (mechanisms_.empty())
            for (std::size_t i = 0; i < robots_.size(); ++i)
                if (robots_[i].at("type").text() == "urdf")
                    mechanisms_[keyOfMechanism(robots_[i])].push_back(i);
        if (!standsStill(robots_[robot]))
            return {robot};
        std::vector<std::size_t> parts = mechanisms_.at(keyOfMechanism(robots_[robot]));
        parts.erase(std::remove_if(parts.begin(), parts.end(),
                                   [this](std::size_t part) { return !standsStill(robots_[part]); }),
                    parts.end());
        return parts;
    }

    void YamlArms::readJointValues(const YamlNode &node, const std::map<std::string, std::string> &movers,
                                   Values &values)
    {
        const ArmFile &file = fileOf(node);
        Values own;
        if (node.has("states"))
            for (const std::string &group : node.at("states").keys())
            {
                const YamlNode state = node.at("states").at(group);
                const Values described = state.orFail([&] { return file.getState(group, state.text()); });
                for (const auto &[joint, value] : described)
                {
                    if (movers.count(joint) > 0 || !file.getTree().hasJoint(joint))
                        continue;
                    const Joint &fixed = jointOf(state, file.getTree(), joint);
                    if (!hasOneValue(fixed))
                    {
                        if (fixed.type == JointType::FIXED)
                            state.note("the value of joint '" + joint + "' has no effect: the URDF file fixes it");
                        continue;
                    }
                    checkLimits(state, fixed, value);
                    own[joint] = value;
                }
            }
        if (node.has("joints"))
            for (const auto &[joint, value] : readValues(node.at("joints"), file.getTree()))
            {
                if (const auto mover = movers.find(joint); mover != movers.end())
                    node.at("joints").at(joint).fail("joint '" + joint + "' is in the group of '" + mover->second +
                                                     "', so start and goal tell it");
                own[joint] = value;
            }
        for (const auto &[joint, value] : own)
            if (const auto known = values.emplace(joint, value).first; known->second != value)
                node.fail("joint '" + joint + "' is at " + shortestText(value) + " here, but at " +
                          shortestText(known->second) + " for another robot of the same file and base");
    }

    void YamlArms::makeArms(const std::vector<std::size_t> &parts, const ompl::base::RealVectorBounds &bounds,
                            Scene &scene, YamlMeshes &meshes)
    {
        const YamlNode &first = robots_[parts.front()];
        const ArmFile &file = fileOf(first);
        std::vector<ArmFile::Part> names;
        std::map<std::string, std::string> movers;  // The robot that moves a joint
        for (const std::size_t part : parts)
        {
            const YamlNode &node = robots_[part];
            names.push_back(
                {node.has("name") ? node.at("name").text() : "robot_" + std::to_string(part), groupOf(node)});
            for (const std::string &joint : file.getJoints(groupOf(node)))
                movers.emplace(joint, names.back().name);
        }
        ArmFile::ArmSettings settings;
        settings.base = baseOf(first);
        settings.bounds = bounds;
        for (const std::size_t part : parts)
        {
            const YamlNode &node = robots_[part];
            if (node.has("bounds") && part != parts.front())
                requireBounds(node.at("bounds"), bounds, names.front().name);
            readJointValues(node, movers, settings.jointValues);
            if (node.has("attached"))
                readAttached(node.at("attached"), meshes, settings.attached);
            if (node.has("touchable"))
                readTouchable(node.at("touchable"), meshes, settings.touchable);
            if (node.has("may_touch_obstacles"))
            {
                const std::vector<std::string> links = readLinkNames(node.at("may_touch_obstacles"));
                settings.mayTouchObstacles.insert(settings.mayTouchObstacles.end(), links.begin(), links.end());
            }
        }
        for (const std::size_t part : parts)
            readPaddings(robots_[part], part == parts.front() ? nullptr : &names.front().name, file.getTree(),
                         settings);
        std::vector<std::string> notes;
        const auto arms = first.orFail([&] { return file.makeArms(names, settings, &notes); });
        for (std::size_t i = 0; i < parts.size(); ++i)
            arms_.emplace(parts[i], arms[i]);
        for (const std::string &note : notes)
            scene.addNote(note);
    }

    void YamlArms::read(const ompl::base::RealVectorBounds &bounds, Scene &scene, YamlMeshes &meshes,
                        Scene::Member &member)
    {
        const std::size_t robot = scene.getMembers().size();
        if (arms_.count(robot) == 0)
            makeArms(partsWith(robot), bounds, scene, meshes);
        const YamlNode &node = robots_[robot];
        const std::shared_ptr<const Arm> &arm = arms_.at(robot);
        const auto readOne = [&](const YamlNode &state) { return readState(state, fileOf(node), groupOf(node), *arm); };
        member.robot = arm;
        member.start = readOne(node.at("start"));
        readGoal(
            node.at("goal"), readOne, [&](const YamlNode &goal) { return readLinkPoseGoal(goal, arm); }, member);
    }
}
