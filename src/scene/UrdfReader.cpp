#include "UrdfReader.h"

#include "UrdfElements.h"
#include "UrdfGeometry.h"
#include "XmlFile.h"
#include "robots/JointTypes.h"
#include "ompl_certificates/files/Suggestion.h"

#include <console_bridge/console.h>
#include <map>
#include <mutex>
#include <ompl/util/Exception.h>
#include <set>
#include <sstream>
#include <urdf_parser/urdf_parser.h>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t MAX_LINKS = 1000;

        /** Keeps what urdfdom would print. One at a time. */
        class Complaints : public console_bridge::OutputHandler
        {
        public:
            Complaints() : lock_(mutex()), previous_(console_bridge::getOutputHandler())
            {
                console_bridge::useOutputHandler(this);
            }

            ~Complaints() override
            {
                console_bridge::useOutputHandler(previous_);
            }

            Complaints(const Complaints &) = delete;
            Complaints &operator=(const Complaints &) = delete;

            void log(const std::string &text, console_bridge::LogLevel level, const char * /*filename*/,
                     int /*line*/) override
            {
                if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR)
                    text_ += (text_.empty() ? "" : "; ") + text;
            }

            const std::string &getText() const
            {
                return text_;
            }

        private:
            static std::mutex &mutex()
            {
                static std::mutex one;
                return one;
            }

            std::unique_lock<std::mutex> lock_;
            console_bridge::OutputHandler *previous_;
            std::string text_;
        };

        /** urdfdom's model. Its links own each other: long chains are taken apart one by one, not by recursion. */
        class Model
        {
        public:
            Model(const XmlFile &file, const std::string &text)
            {
                Complaints complaints;
                try
                {
                    model_ = urdf::parseURDF(text);
                }
                catch (const std::exception &exception)
                {
                    file.fail(exception.what());
                }
                // It leaves out shapes that it does not understand.
                if (!model_ || !complaints.getText().empty())
                    file.fail(complaints.getText().empty() ? "is not a URDF model" : complaints.getText());
            }

            ~Model()
            {
                if (model_)
                    for (auto &[name, link] : model_->links_)
                    {
                        link->child_links.clear();
                        link->child_joints.clear();
                    }
            }

            Model(const Model &) = delete;
            Model &operator=(const Model &) = delete;

            const urdf::ModelInterface &get() const
            {
                return *model_;
            }

        private:
            urdf::ModelInterfaceSharedPtr model_;
        };

        /** Drop what planning does not need, so that it cannot be wrong. */
        void prune(pugi::xml_node robot, bool useVisuals)
        {
            const auto keep = [](pugi::xml_node node, const std::set<std::string> &names)
            {
                for (pugi::xml_node child = node.first_child(); child;)
                {
                    const pugi::xml_node next = child.next_sibling();
                    if (names.count(child.name()) == 0)
                        node.remove_child(child);
                    child = next;
                }
            };
            keep(robot, {"link", "joint"});
            for (const pugi::xml_node link : robot.children("link"))
            {
                const std::string kept = useVisuals ? "visual" : "collision";
                keep(link, {kept});
                for (const pugi::xml_node element : link.children(kept.c_str()))
                    keep(element, {"origin", "geometry"});
            }
            for (const pugi::xml_node joint : robot.children("joint"))
            {
                keep(joint, {"origin", "parent", "child", "axis", "limit", "mimic"});
                // urdfdom asks for them.
                for (pugi::xml_node limit : joint.children("limit"))
                    for (const char *const name : {"effort", "velocity"})
                    {
                        limit.remove_attribute(name);
                        limit.append_attribute(name) = 0;
                    }
            }
            robot.remove_attribute("version");
        }

        /** What urdfdom would not notice, or not name */
        void check(const XmlFile &file, pugi::xml_node robot)
        {
            // urdfdom takes its complaint about a wrong number for the format of printf().
            const std::set<std::string> words{"name", "link", "joint", "type", "filename"};
            for (const pugi::xpath_node &found : robot.select_nodes(".//@*[contains(., '%')]"))
                if (words.count(found.attribute().name()) == 0)
                    file.fail(found.parent(), std::string(found.attribute().name()) + ": must be numbers, not '" +
                                                  found.attribute().value() + "'");
            // Debian 12's urdfdom does not know it.
            if (const pugi::xpath_node found = robot.select_node(".//origin[@quat_xyzw]"))
                file.fail(found.node(), "quat_xyzw: is not supported; give rpy");
            // For each attribute urdfdom looks through all of its element.
            if (const pugi::xpath_node found = robot.select_node("descendant-or-self::*[count(@*) > 64]"))
                file.fail(found.node(), "has more than 64 attributes");
            std::size_t links = 0;
            for ([[maybe_unused]] const pugi::xml_node link : robot.children("link"))
                ++links;
            if (links == 0)
                file.fail("has no link");
            if (links > MAX_LINKS)
                file.fail("has " + std::to_string(links) + " links, more than " + std::to_string(MAX_LINKS));
            // The joint of each child, and its parent
            std::map<std::string, std::pair<std::string, std::string>> joints;
            for (const pugi::xml_node joint : robot.children("joint"))
            {
                const std::string name = joint.attribute("name").value(),
                                  child = joint.child("child").attribute("link").value(),
                                  parent = joint.child("parent").attribute("link").value();
                const auto [other, isNew] = joints.insert({child, {name, parent}});
                if (!isNew)
                    file.fail("link '" + child + "' is the child of two joints, '" + other->second.first + "' and '" +
                              name + "'");
            }
            if (joints.size() > MAX_LINKS)
                file.fail("has " + std::to_string(joints.size()) + " joints, more than " + std::to_string(MAX_LINKS));
            // urdfdom never frees the links of a loop.
            for (const auto &[child, joint] : joints)
            {
                std::size_t steps = 0;
                for (auto up = joints.find(child); up != joints.end(); up = joints.find(up->second.second))
                    if (++steps > joints.size())
                        file.fail("link '" + child + "' hangs on a loop of joints");
            }
        }

        KinematicTree::JointType typeOf(const urdf::Joint &joint)
        {
            using Type = KinematicTree::JointType;
            static const std::map<int, Type> types{
                {urdf::Joint::REVOLUTE, Type::REVOLUTE},   {urdf::Joint::CONTINUOUS, Type::CONTINUOUS},
                {urdf::Joint::PRISMATIC, Type::PRISMATIC}, {urdf::Joint::FLOATING, Type::FLOATING},
                {urdf::Joint::PLANAR, Type::PLANAR},       {urdf::Joint::FIXED, Type::FIXED}};
            const auto type = types.find(joint.type);
            if (type == types.end())
                throw ompl::Exception("its type is not known");
            return type->second;
        }

        /** The joint that a joint follows. None if there is no such joint, or it has no value: MoveIt passes over a
            fixed one, too. */
        urdf::JointConstSharedPtr followedBy(const urdf::ModelInterface &model, const urdf::Joint &joint)
        {
            const auto followed = joint.mimic ? model.getJoint(joint.mimic->joint_name) : urdf::JointConstSharedPtr();
            return followed && followed->type != urdf::Joint::FIXED ? followed : urdf::JointConstSharedPtr();
        }

        /** What a joint follows. Of a joint that itself follows another it is that one, as for MoveIt. A joint that
            follows one that there is not, or that is fixed, follows none, and a note tells of it. */
        std::optional<KinematicTree::Mimic> mimicOf(const urdf::ModelInterface &model, const urdf::Joint &joint,
                                                    std::vector<std::string> &notes)
        {
            if (!joint.mimic)
                return std::nullopt;
            KinematicTree::Mimic mimic{joint.mimic->joint_name, joint.mimic->multiplier, joint.mimic->offset};
            auto followed = followedBy(model, joint);
            if (!followed)
            {
                notes.push_back("joint '" + joint.name + "' mimics joint '" + mimic.joint + "', " +
                                (model.getJoint(mimic.joint) ? "which is fixed" : "but there is none") +
                                ": it moves by itself");
                return std::nullopt;
            }
            for (std::size_t steps = 0; steps <= model.joints_.size(); ++steps)
            {
                const auto next = followedBy(model, *followed);
                if (!next)
                    return mimic;
                mimic.offset += mimic.multiplier * followed->mimic->offset;
                mimic.multiplier *= followed->mimic->multiplier;
                mimic.joint = next->name;
                followed = next;
            }
            throw ompl::Exception("follows joints that follow each other");
        }

        KinematicTree::Joint jointOf(const urdf::ModelInterface &model, const urdf::Joint &joint,
                                     std::vector<std::string> &notes)
        {
            using Type = KinematicTree::JointType;
            KinematicTree::Joint result;
            result.name = joint.name;
            result.origin = poseOf(joint.parent_to_joint_origin_transform);
            result.type = typeOf(joint);
            result.axis = {joint.axis.x, joint.axis.y, joint.axis.z};
            if (isLimited(result.type))
            {
                if (!joint.limits)
                    throw ompl::Exception("has no limits");
                result.lower = joint.limits->lower;
                result.upper = joint.limits->upper;
            }
            // Some files fix joints and leave what they followed.
            if (result.type != Type::FIXED)
                result.mimic = mimicOf(model, joint, notes);
            return result;
        }
    }

    UrdfModel readUrdf(const std::string &file, const ArmFile::Options &options)
    {
        XmlFile xml(file, "robot");
        const pugi::xml_node robot = xml.getRoot();
        std::vector<std::string> notes = xml.leftOverFromXacro();
        for (const std::string &note : unknownElements(xml))
            notes.push_back(note);
        const std::vector<std::string> without =
            options.useVisuals ? linksWithout(xml, "collision", "visual") : linksWithout(xml, "visual", "collision");
        prune(robot, options.useVisuals);
        check(xml, robot);
        std::ostringstream text;
        robot.print(text, "", pugi::format_raw);
        const Model model(xml, text.str());

        UrdfGeometry geometry(file, options);
        const auto fail = [&](const urdf::Joint &joint, const std::string &complaint)
        { xml.fail("joint '" + joint.name + "': " + complaint); };
        const urdf::LinkConstSharedPtr root = model.get().getRoot();
        UrdfModel result{model.get().getName(), KinematicTree(root->name, geometry.bodyOf(*root)), std::move(notes)};
        std::vector<urdf::LinkConstSharedPtr> open(root->child_links.rbegin(), root->child_links.rend());
        while (!open.empty())
        {
            const urdf::LinkConstSharedPtr link = open.back();
            open.pop_back();
            const urdf::Joint &joint = *link->parent_joint;
            const std::optional<Body> body = geometry.bodyOf(*link);
            KinematicTree::Joint made;
            try
            {
                made = jointOf(model.get(), joint, result.notes);
            }
            catch (const ompl::Exception &exception)
            {
                fail(joint, exception.what());
            }
            try
            {
                result.tree.addLink(joint.parent_link_name, made, link->name, body);
            }
            catch (const ompl::Exception &exception)
            {
                xml.fail(exception.what());
            }
            open.insert(open.end(), link->child_links.rbegin(), link->child_links.rend());
        }
        try
        {
            result.tree.checkMimics();
        }
        catch (const ompl::Exception &exception)
        {
            xml.fail(exception.what());
        }
        if (!without.empty())
            result.notes.push_back(
                file + ": these links have a " +
                (options.useVisuals ? "collision geometry and no visual" : "visual and no collision geometry") +
                ", so they are not checked: " + joined(without));
        return result;
    }
}
