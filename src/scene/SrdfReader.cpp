#include "SrdfReader.h"

#include "LineReader.h"
#include "XmlFile.h"
#include "robots/JointTypes.h"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        using Node = pugi::xml_node;
        using Names = std::set<std::string>;

        std::pair<std::string, std::string> ordered(const std::string &first, const std::string &second)
        {
            return first < second ? std::make_pair(first, second) : std::make_pair(second, first);
        }

        constexpr std::size_t MAX_GROUPS = 1000;

        /** Finds the joints of groups, which may hold each other. What the robot does not have is left out and noted,
            as MoveIt does: one SRDF file often serves several variants of a robot. */
        class Groups
        {
        public:
            /** \param model has the virtual joint, and is told what is left out */
            Groups(const XmlFile &file, const KinematicTree &tree, SrdfModel &model)
              : file_(file)
              , tree_(tree)
              , virtualJoint_(model.virtualJoint ? model.virtualJoint->name : "")
              , model_(model)
            {
                for (const Node group : file.getRoot().children("group"))
                    if (!nodes_.emplace(file.attribute(group, "name"), group).second)
                        file.fail(group, "there are two groups '" + file.attribute(group, "name") + "'");
                // Each may hold all others.
                if (nodes_.size() > MAX_GROUPS)
                    file.fail("has " + std::to_string(nodes_.size()) + " groups, more than " +
                              std::to_string(MAX_GROUPS));
            }

            const std::map<std::string, Node> &getNodes() const
            {
                return nodes_;
            }

            /** All joints of a group, those of the groups in it too */
            Names jointsOf(const std::string &group)
            {
                Names joints, seen{group};
                std::vector<std::string> open{group};
                while (!open.empty())
                {
                    const Node node = nodes_.at(open.back());
                    open.pop_back();
                    for (const Node child : node.children("chain"))
                        addChain(child, joints);
                    for (const Node child : node.children("joint"))
                        if (const auto name = joint(child))
                            joints.insert(*name);
                    for (const Node child : node.children("link"))
                        if (const auto index = link(child, "name"))
                            joints.insert(*index == 0 ? virtualJoint_ : tree_.getLinks()[*index].joint.name);
                    for (const Node child : node.children("group"))
                    {
                        const std::string name = file_.attribute(child, "name");
                        if (nodes_.count(name) == 0)
                            note(child, "there is no group '" + name + "'");
                        else if (seen.insert(name).second)
                            open.push_back(name);
                    }
                }
                return joints;
            }

            /** The joint that an element names, if the robot has it */
            std::optional<std::string> joint(const Node &node)
            {
                std::string name = file_.attribute(node, "name");
                if (name == virtualJoint_ || tree_.hasJoint(name))
                    return name;
                note(node, "there is no joint '" + name + "'");
                return std::nullopt;
            }

            /** The link that an attribute names, if the robot has it */
            std::optional<std::size_t> link(const Node &node, const char *key)
            {
                const std::string name = file_.attribute(node, key);
                if (tree_.hasLink(name))
                    return tree_.getLinkIndex(name);
                note(node, std::string(key) + ": there is no link '" + name + "'");
                return std::nullopt;
            }

            void note(const Node &node, const std::string &remark)
            {
                // A group in several others is read several times.
                if (const std::string text = file_.remark(node, remark + "; ignored"); noted_.insert(text).second)
                    model_.ignore(text);
            }

        private:
            /** The joints between two links. If neither is above the other, they are those to the nearest link above
                both. */
            void addChain(const Node &node, Names &joints)
            {
                const auto base = link(node, "base_link"), tip = link(node, "tip_link");
                if (!base || !tip)
                    return;
                const auto &links = tree_.getLinks();
                // Links stand after their parents.
                for (std::size_t one = *base, other = *tip; one != other;)
                {
                    std::size_t &lower = one > other ? one : other;
                    joints.insert(links[lower].joint.name);
                    lower = links[lower].parent;
                }
            }

            const XmlFile &file_;
            const KinematicTree &tree_;
            const std::string virtualJoint_;
            SrdfModel &model_;
            Names noted_;
            std::map<std::string, Node> nodes_;
        };

        bool canMove(const KinematicTree::Joint &joint)
        {
            return joint.type != KinematicTree::JointType::FIXED && !joint.mimic &&
                   (!isLimited(joint.type) || joint.lower < joint.upper);
        }

        std::string noteOnEqualLimits(const KinematicTree::Joint &joint)
        {
            return "joint '" + joint.name + "' does not move: both limits are " + std::to_string(joint.lower);
        }

        using JointType = KinematicTree::JointType;

        void readVirtualJoint(const XmlFile &file, const KinematicTree &tree, SrdfModel &model)
        {
            const std::string &root = tree.getLinks().front().name;
            for (const Node node : file.getRoot().children("virtual_joint"))
            {
                const std::string name = file.attribute(node, "name"), type = file.attribute(node, "type");
                const std::map<std::string, JointType> types{
                    {"fixed", JointType::FIXED}, {"planar", JointType::PLANAR}, {"floating", JointType::FLOATING}};
                if (types.count(type) == 0)
                    file.fail(node, "type: must be fixed, planar or floating, not '" + type + "'");
                if (file.attribute(node, "child_link") != root)
                    model.ignore("virtual joint '" + name + "' is ignored: its child is not the root link '" + root +
                                 "'");
                else if (model.virtualJoint)
                    file.fail(node, "there are two virtual joints of link '" + root + "'");
                else
                {
                    if (tree.hasJoint(name))
                        file.fail(node, "name: there is a joint '" + name + "' already");
                    model.virtualJoint = VirtualJoint{name, file.attribute(node, "parent_frame"), types.at(type)};
                }
            }
        }

        /** Note that a base is planned for as if it could move in all directions. */
        void noteMotionModel(const XmlFile &file, SrdfModel &model)
        {
            for (const Node node : file.getRoot().children("joint_property"))
            {
                const std::string kind = node.attribute("value").value();
                if (model.virtualJoint && model.virtualJoint->type == JointType::PLANAR &&
                    node.attribute("joint_name").value() == model.virtualJoint->name &&
                    std::string(node.attribute("property_name").value()) == "motion_model" && kind != "holonomic")
                    model.notes.push_back("virtual joint '" + model.virtualJoint->name + "': its motion model " + kind +
                                          " is ignored: it moves in any direction");
            }
        }

        /** The joints of all groups but the passive ones */
        void readGroups(const XmlFile &file, const KinematicTree &tree, Groups &all, SrdfModel &model)
        {
            for (const Node node : file.getRoot().children("passive_joint"))
                if (const auto joint = all.joint(node))
                    model.passive.insert(*joint);
            const auto &virtualJoint = model.virtualJoint;
            Names held, passive;
            for (const auto &[group, node] : all.getNodes())
            {
                const Names names = all.jointsOf(group);
                for (const std::string &joint : model.passive)
                    if (names.count(joint) > 0 && passive.insert(joint).second)
                        model.ignore("joint '" + joint + "' is passive: no group moves it");
                const auto isMoved = [&](const std::string &joint)
                { return names.count(joint) > 0 && model.passive.count(joint) == 0; };
                std::vector<std::string> &joints = model.groups[group];
                if (virtualJoint && virtualJoint->type != JointType::FIXED && isMoved(virtualJoint->name))
                    joints.push_back(virtualJoint->name);
                for (const KinematicTree::Link &link : tree.getLinks())
                    if (const std::string &joint = link.joint.name; isMoved(joint))
                    {
                        if (canMove(link.joint))
                            joints.push_back(joint);
                        else if (hasEqualLimits(link.joint) && held.insert(joint).second)
                            model.ignore(noteOnEqualLimits(link.joint));
                    }
            }
        }

        void readStates(const XmlFile &file, const KinematicTree &tree, Groups &all, SrdfModel &model)
        {
            for (const Node node : file.getRoot().children("group_state"))
            {
                const std::string group = node.attribute("group").value(), name = file.attribute(node, "name");
                if (model.groups.count(group) == 0)
                {
                    all.note(node, "there is no group '" + group + "'");
                    continue;
                }
                auto &values = model.states[group][name];
                for (const Node child : node.children("joint"))
                {
                    const auto joint = all.joint(child);
                    if (!joint)
                        continue;
                    const std::string text = boost::algorithm::trim_copy(file.attribute(child, "value"));
                    double value = 0.0;
                    // Joints with several coordinates, such as the virtual one, are not described by one number.
                    if (!tree.hasJoint(*joint) || text.find_first_of(" \t") != std::string::npos)
                        model.notes.push_back("state '" + name + "' of group '" + group + "': the value of joint '" +
                                              *joint + "' is ignored");
                    else if (!parseNumber(text, value) || !std::isfinite(value))
                        file.fail(child, "joint '" + *joint + "', value: must be a finite number, not '" + text + "'");
                    else
                        values[*joint] = withinLimits(tree.getLinks()[tree.getChildOf(*joint)].joint, value);
                }
            }
        }
    }

    bool hasEqualLimits(const KinematicTree::Joint &joint)
    {
        return isLimited(joint.type) && !joint.mimic && joint.lower == joint.upper;
    }

    double withinLimits(const KinematicTree::Joint &joint, double value)
    {
        if (!isLimited(joint.type))
            return value;
        const double nearest = std::clamp(value, joint.lower, joint.upper);
        return std::abs(value - nearest) <= FILE_ROUNDING ? nearest : value;
    }

    SrdfModel::SrdfModel(const KinematicTree &tree)
    {
        std::vector<std::string> &joints = groups[""];
        for (const KinematicTree::Link &link : tree.getLinks())
            if (canMove(link.joint))
                joints.push_back(link.joint.name);
            else if (hasEqualLimits(link.joint))
                notes.push_back(noteOnEqualLimits(link.joint));
    }

    SrdfModel::SrdfModel(const std::string &file, const std::string &robot, const KinematicTree &tree)
    {
        const XmlFile xml(file, "robot");
        for (std::string &note : xml.leftOverFromXacro())
            notes.push_back(std::move(note));
        if (const std::string name = xml.getRoot().attribute("name").value(); name != robot)
            notes.insert(notes.begin(), file + ": describes robot '" + name + "', not '" + robot + "'");
        readVirtualJoint(xml, tree, *this);
        noteMotionModel(xml, *this);
        Groups all(xml, tree, *this);
        readGroups(xml, tree, all, *this);
        readStates(xml, tree, all, *this);
        readPairs(xml, tree);
    }

    void SrdfModel::readPairs(const XmlFile &file, const KinematicTree &tree)
    {
        Names missing;
        const auto linkOf = [&](const Node &node, const char *key)
        {
            std::string name = file.attribute(node, key);
            if (!tree.hasLink(name))
                missing.insert(name);
            return name;
        };
        const auto collect = [&](const char *element, std::set<Pair> &pairs)
        {
            for (const Node node : file.getRoot().children(element))
            {
                const std::string first = linkOf(node, "link1"), second = linkOf(node, "link2");
                pairs.insert(ordered(first, second));
            }
        };
        collect("disable_collisions", disabled_);
        collect("enable_collisions", enabled_);
        for (const Node node : file.getRoot().children("disable_default_collisions"))
            disabledLinks_.insert(linkOf(node, "link"));
        if (!missing.empty())
            notes.push_back(file.getName() +
                            ": pairs of links name some that there are not: " + boost::algorithm::join(missing, ", "));
    }

    void SrdfModel::ignore(const std::string &note)
    {
        notes.push_back(note);
        ignored.push_back(note);
    }

    bool SrdfModel::isDisabled(const std::string &first, const std::string &second) const
    {
        const auto pair = ordered(first, second);
        if (disabled_.count(pair) > 0)
            return true;
        return (isDisabledByDefault(first) || isDisabledByDefault(second)) && enabled_.count(pair) == 0;
    }
}
