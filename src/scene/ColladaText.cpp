#include "ColladaText.h"

#include "ColladaCheck.h"
#include "MeshWords.h"

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ompl_certificates
{
    namespace
    {
        [[noreturn]] void fail(const std::string &complaint)
        {
            throw std::runtime_error(complaint);
        }

        using Names = std::vector<std::string_view>;

        bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names)
        {
            return std::find(names.begin(), names.end(), name) != names.end();
        }

        bool isTransformation(std::string_view name)
        {
            return isOneOf(name, {"matrix", "rotate", "scale", "translate"});
        }

        /** What makes up a mesh and where it is, and in what order Assimp has to see it: what refers after what is referred
            to. Of all else, such as materials, cameras, bones and movement, it believes every index. */
        const Names &partsOf(std::string_view name)
        {
            static const Names primitive{"input", "p"};
            static const std::map<std::string_view, Names> parts{
                {"COLLADA", {"asset", "library_geometries", "library_nodes", "library_visual_scenes", "scene"}},
                {"asset", {"unit", "up_axis"}},
                {"library_geometries", {"geometry"}},
                {"geometry", {"mesh"}},
                {"mesh",
                 {"source", "vertices", "lines", "linestrips", "polygons", "polylist", "triangles", "tristrips"}},
                {"source", {"float_array", "technique_common"}},
                {"technique_common", {"accessor"}},
                {"accessor", {"param"}},
                {"vertices", {"input"}},
                {"lines", primitive},
                {"linestrips", primitive},
                {"polygons", primitive},
                {"polylist", {"input", "vcount", "p"}},
                {"triangles", primitive},
                {"tristrips", primitive},
                {"library_nodes", {"node"}},
                {"library_visual_scenes", {"visual_scene"}},
                {"visual_scene", {"node"}},
                {"scene", {"instance_visual_scene"}},
            };
            static const Names none;
            const auto found = parts.find(name);
            return found != parts.end() ? found->second : none;
        }

        /** Copies what is of the meshes. Skins and morphs become the meshes that they are made of. */
        class Copy
        {
        public:
            explicit Copy(const pugi::xml_node &root)
            {
                for (const pugi::xml_node &library : root.children("library_controllers"))
                    for (const pugi::xml_node &controller : library.children("controller"))
                        for (const pugi::xml_node &child : controller.children())
                            if (const pugi::xml_attribute source = child.attribute("source"))
                                sources_.emplace(std::string("#") + controller.attribute("id").value(), source.value());
            }

            void copy(const pugi::xml_node &from, pugi::xml_node to, std::size_t level = 0) const
            {
                if (level >= MOST_COLLADA_LEVELS)
                    fail("its elements are nested in more than " + std::to_string(MOST_COLLADA_LEVELS) + " levels");
                for (const char *const name : {"id", "name", "url", "source", "semantic", "offset", "set", "count",
                                               "stride", "type", "meter", "version"})
                    if (const pugi::xml_attribute attribute = from.attribute(name))
                        to.append_attribute(name).set_value(attribute.value());
                std::string text;
                for (const pugi::xml_node &child : from.children())
                    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
                        text += child.value();
                if (!text.empty())
                    to.text().set(plainContent(from.name(), text).c_str());
                if (std::strcmp(from.name(), "node") == 0)
                    return copyNode(from, to, level);
                if (from.child("trifans"))
                    fail("it has <trifans>, which are not supported");
                if (const pugi::xml_attribute meter = to.attribute("meter"))
                    if (const std::string number = plainNumber(meter.value());
                        !(std::strtod(number.c_str(), nullptr) > 0.0))
                        fail("its <unit> is of " + number.substr(0, 20) + " meters");
                for (const std::string_view part : partsOf(from.name()))
                    for (const pugi::xml_node &child : from.children(part.data()))
                        copy(child, to.append_child(part.data()), level + 1);
            }

        private:
            /** The content of an element, of numbers if it is not an axis */
            static std::string plainContent(std::string_view element, const std::string &text)
            {
                std::string content;
                MeshWords words(text);
                if (element == "up_axis")
                {
                    content = words.next();
                    if (content != "X_UP" && content != "Y_UP" && content != "Z_UP")
                        fail("its <up_axis> is '" + content.substr(0, 20) + "'");
                }
                else if (element == "float_array" || isTransformation(element))
                    for (std::string_view word = words.next(); !word.empty(); word = words.next())
                        content.append(plainNumber(word)).append(" ");
                else if (element == "p" || element == "vcount")
                    content = text;
                return content;
            }

            /** Here the order counts: transformations are applied one after the other. */
            void copyNode(const pugi::xml_node &from, pugi::xml_node &to, std::size_t level) const
            {
                for (const pugi::xml_node &child : from.children())
                    if (const std::string_view name = child.name();
                        isOneOf(name, {"node", "instance_geometry", "instance_node"}) || isTransformation(name))
                        copy(child, to.append_child(child.name()), level + 1);
                    else if (name == "skew" || name == "lookat")
                        fail("it has a <" + std::string(name) + ">, which is not supported");
                    else if (name == "instance_controller")
                    {
                        std::string url = child.attribute("url").value();
                        // The skin of a morph, at most
                        for (int i = 0; i < 2 && sources_.count(url) > 0; ++i)
                            url = sources_.at(url);
                        to.append_child("instance_geometry").append_attribute("url").set_value(url.c_str());
                    }
            }

            std::map<std::string, std::string> sources_;
        };
    }

    std::string plainCollada(const std::string &text)
    {
        pugi::xml_document document, plain;
        if (const auto result = document.load_buffer(text.data(), text.size(), pugi::parse_full); !result)
            fail(std::string("it is not XML: ") + result.description());
        const pugi::xml_node given = document.child("COLLADA");
        if (!given)
            fail("it has no element <COLLADA>");
        pugi::xml_node root = plain.append_child("COLLADA");
        Copy(given).copy(given, root);
        document.reset();
        checkCollada(root, text.size());
        std::ostringstream stream;
        plain.save(stream, "", pugi::format_raw);
        return stream.str();
    }
}
