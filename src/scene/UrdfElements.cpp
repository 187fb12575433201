#include "UrdfElements.h"

#include <map>
#include <set>

namespace ompl_certificates
{
    namespace
    {
        using Names = std::set<std::string>;

        /** What an element may have. Programs know more of sensors and dynamics, which are not looked into. */
        struct Known
        {
            Names elements, attributes;
        };

        const std::map<std::string, Known> &knownElements()
        {
            static const Names pose{"origin",   "geometry", "name", "verbose", "contact_coefficients",
                                    "material", "surface"};
            static const std::map<std::string, Known> known{
                {"link",
                 {{"inertial", "visual", "collision", "contact", "contact_coefficients", "collision_checking",
                   "self_collision_checking", "sensor", "gazebo", "plugin", "kinematic", "gravity", "selfCollide",
                   "self_collide"},
                  {"name", "type", "concave"}}},
                {"joint",
                 {{"origin", "parent", "child", "axis", "limit", "mimic", "dynamics", "calibration",
                   "safety_controller", "physics", "hardwareInterface", "actuator", "gazebo", "sensor",
                   "joint_properties", "disable_collisions"},
                  {"name", "type"}}},
                {"collision", {pose, {"name", "group", "concave"}}},
                {"visual", {pose, {"name", "group"}}},
                {"geometry", {{"box", "cylinder", "sphere", "mesh", "capsule"}, {"name"}}},
                {"origin", {{}, {"xyz", "rpy", "quat_xyzw"}}},
                {"axis", {{}, {"xyz"}}},
                {"parent", {{}, {"link"}}},
                {"child", {{}, {"link"}}}};
            return known;
        }

        /** What may be there many times; of all else the first counts */
        const Names MANY{"visual",
                         "collision",
                         "material",
                         "contact",
                         "sensor",
                         "gazebo",
                         "plugin",
                         "hardwareInterface",
                         "actuator",
                         "contact_coefficients",
                         "disable_collisions",
                         "verbose",
                         "collision_checking",
                         "self_collision_checking"};

        bool isOfAnotherProgram(const std::string &name)
        {
            return name.find(':') != std::string::npos;
        }

        /** Notes on one element and those in it that are known */
        void note(const XmlFile &urdf, const pugi::xml_node &node, std::vector<std::string> &notes)
        {
            const auto known = knownElements().find(node.name());
            if (known == knownElements().end())
                return;
            for (const pugi::xml_attribute attribute : node.attributes())
                if (known->second.attributes.count(attribute.name()) == 0 && !isOfAnotherProgram(attribute.name()))
                    notes.push_back(urdf.remark(node, std::string("has an attribute '") + attribute.name() +
                                                          "' that URDF does not know: it is ignored"));
            Names seen;
            for (const pugi::xml_node child : node.children())
            {
                if (child.type() != pugi::node_element || isOfAnotherProgram(child.name()))
                    continue;
                if (known->second.elements.count(child.name()) == 0)
                    notes.push_back(urdf.remark(child, "is not known in a '" + std::string(node.name()) +
                                                           "' of URDF: it is ignored"));
                // Of all shapes within a geometry one counts.
                else if (const std::string kind = std::string(node.name()) == "geometry" ? "shape" : child.name();
                         MANY.count(child.name()) == 0 && !seen.insert(kind).second)
                    notes.push_back(urdf.remark(child, "is the second " + kind + " of its '" + node.name() +
                                                           "': the first one counts, and this is ignored"));
                note(urdf, child, notes);
            }
        }
    }

    std::vector<std::string> unknownElements(const XmlFile &urdf)
    {
        std::vector<std::string> notes;
        for (const char *const name : {"link", "joint"})
            for (const pugi::xml_node node : urdf.getRoot().children(name))
                note(urdf, node, notes);
        // One mistake of a program is in each link.
        constexpr std::size_t most = 10;
        if (notes.size() > most)
        {
            notes.resize(most);
            notes.push_back(urdf.getName() + ": there are more such elements and attributes");
        }
        return notes;
    }

    std::vector<std::string> linksWithout(const XmlFile &urdf, const char *has, const char *lacks)
    {
        std::vector<std::string> names;
        for (const pugi::xml_node link : urdf.getRoot().children("link"))
            if (link.child(has) && !link.child(lacks))
                names.emplace_back(link.attribute("name").value());
        return names;
    }
}
