#include "ColladaText.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t MOST_LEVELS = 1000, MOST_NODES = 1000000;
        constexpr std::string_view DIGITS = "0123456789", SPACES = " \t\r\n";

        [[noreturn]] void fail(const std::string &complaint)
        {
            throw std::runtime_error(complaint);
        }

        /** Whether a number is at most \e bytes: each thing that is counted takes a byte of the file. */
        bool isPossible(std::string_view digits, std::size_t bytes)
        {
            return digits.size() <= 15 && std::stoull(std::string(digits)) <= bytes;
        }

        void checkCounts(const pugi::xml_node &node, std::size_t bytes)
        {
            for (const pugi::xml_attribute &attribute : node.attributes())
            {
                if (std::strcmp(attribute.name(), "count") != 0)
                    continue;
                const std::string_view value = attribute.value();
                if (value.empty() || value.find_first_not_of(DIGITS) != std::string_view::npos)
                    fail("count=\"" + std::string(value.substr(0, 10)) + "\" is not a number");
                if (!isPossible(value, bytes))
                    fail("it says that it has " + std::string(value.substr(0, 30)) + " of something, in " +
                         std::to_string(bytes) + " bytes");
            }
        }

        /** What the numbers that are the content of \e node add up to */
        std::size_t sumOf(const pugi::xml_node &node, std::size_t bytes)
        {
            std::size_t sum = 0;
            for (std::string_view rest = node.text().get(); !rest.empty();)
            {
                if (const std::size_t spaces = rest.find_first_not_of(SPACES); spaces > 0)
                {
                    rest.remove_prefix(std::min(spaces, rest.size()));
                    continue;
                }
                const std::size_t digits = std::min(rest.find_first_not_of(DIGITS), rest.size());
                const std::string_view word = rest.substr(0, rest.find_first_of(SPACES)),
                                       number = rest.substr(0, digits);
                if (digits == 0 || !isPossible(number, bytes))
                    fail("in <" + std::string(node.name()) + "> there is '" + std::string(word.substr(0, 10)) +
                         "', not a number that can be");
                sum += std::stoull(std::string(number));
                rest.remove_prefix(digits);
            }
            return sum;
        }

        /** How large a scene becomes once its <instance_node>s are replaced by the nodes that they name, which Assimp does by
            calling itself, however deep and often that is, and in a ring. */
        class Expansion
        {
        public:
            void add(const pugi::xml_node &node)
            {
                if (std::strcmp(node.parent().name(), "visual_scene") == 0)
                    roots_.push_back(node);
                if (std::strcmp(node.parent().name(), "library_nodes") == 0)
                    library_.emplace(node.attribute("id").value(), node);
                for (const char *const key : {"id", "name"})
                    if (const pugi::xml_attribute attribute = node.attribute(key))
                        named_.emplace(attribute.value(), node);
            }

            void check()
            {
                std::size_t nodes = 0;
                for (const pugi::xml_node &root : roots_)
                    if ((nodes += measure(root, 0).nodes) > MOST_NODES)
                        fail("it has more than " + std::to_string(MOST_NODES) + " nodes");
            }

        private:
            struct Size
            {
                std::size_t nodes{0}, depth{0};
                bool isOpen{true};
            };

            Size measure(const pugi::xml_node &node, std::size_t above)
            {
                const auto [known, isNew] = sizes_.try_emplace(node);
                if (!isNew && known->second.isOpen)
                    fail("its nodes are instances of each other in a ring");
                if (!isNew)
                    return known->second;
                Size size;
                const auto take = [&](const Size &part)
                {
                    size.nodes += part.nodes;
                    size.depth = std::max(size.depth, part.depth);
                    if (above + size.depth >= MOST_LEVELS)
                        fail("its nodes are nested in more than " + std::to_string(MOST_LEVELS) + " levels");
                    if (size.nodes >= MOST_NODES)
                        fail("it has more than " + std::to_string(MOST_NODES) + " nodes");
                };
                take({1, 0, false});
                for (const pugi::xml_node &child : node.children("node"))
                    take(measure(child, above + 1));
                for (const pugi::xml_node &instance : node.children("instance_node"))
                {
                    std::string_view url = instance.attribute("url").value();
                    url.remove_prefix(url.empty() || url[0] != '#' ? 0 : 1);
                    // Assimp looks in the library first, and then for the first node that has this name or id.
                    const auto &among = library_.count(url) > 0 ? library_ : named_;
                    const auto [first, last] = among.equal_range(url);
                    for (auto target = first; target != last; ++target)
                        take(measure(target->second, above + 1));
                }
                ++size.depth;
                size.isOpen = false;
                return sizes_[node] = size;
            }

            std::vector<pugi::xml_node> roots_;
            std::multimap<std::string_view, pugi::xml_node> library_, named_;
            std::map<pugi::xml_node, Size> sizes_;
        };

        /** Show what skins and morphs are made of, without bones and movement, of which Assimp believes every index. */
        void leaveBonesOut(pugi::xml_document &document)
        {
            class Skins : public pugi::xml_tree_walker
            {
            public:
                bool for_each(pugi::xml_node &node) override
                {
                    if (static_cast<std::size_t>(depth()) >= MOST_LEVELS)
                        fail("its elements are nested in more than " + std::to_string(MOST_LEVELS) + " levels");
                    if (std::strcmp(node.name(), "instance_controller") == 0)
                        shown.push_back(node);
                    if (std::strcmp(node.name(), "controller") == 0)
                        for (const pugi::xml_node &child : node.children())
                            if (const pugi::xml_attribute source = child.attribute("source"))
                                sources.emplace(std::string("#") + node.attribute("id").value(), source.value());
                    return true;
                }

                std::vector<pugi::xml_node> shown;
                std::map<std::string, std::string> sources;
            } skins;
            document.traverse(skins);
            for (pugi::xml_node &node : skins.shown)
            {
                std::string url = node.attribute("url").value();
                // The skin of a morph, at most
                for (int i = 0; i < 2 && skins.sources.count(url) > 0; ++i)
                    url = skins.sources[url];
                node.set_name("instance_geometry");
                node.attribute("url").set_value(url.c_str());
            }
            pugi::xml_node root = document.document_element();
            for (const char *const name : {"library_controllers", "library_animations", "library_animation_clips"})
                while (root.remove_child(name))
                    continue;
        }

        class Check : public pugi::xml_tree_walker
        {
        public:
            explicit Check(std::size_t bytes) : bytes_(bytes)
            {
            }

            bool for_each(pugi::xml_node &node) override
            {
                const std::string_view name = node.name();
                checkCounts(node, bytes_);
                if (name == "node")
                    expansion_.add(node);
                // Assimp reads from nowhere where an accessor is of an empty array.
                if (name == "float_array" && node.attribute("count").as_ullong() == 0 && hasAccessor(node.parent()))
                    fail("a <float_array> is empty that is made use of");
                // What is no number Assimp tries to read for ever.
                if (name == "p")
                    sumOf(node, bytes_);
                if (name == "vcount" && sumOf(node, bytes_) > bytes_)
                    fail("in <vcount> there are more than there are bytes");
                return true;
            }

            void finish()
            {
                expansion_.check();
            }

        private:
            bool hasAccessor(const pugi::xml_node &source)
            {
                const auto [known, isNew] = accessors_.try_emplace(source);
                if (isNew)
                    known->second = static_cast<bool>(source.find_node(
                        [](const pugi::xml_node &node) {
                            return std::strcmp(node.name(), "accessor") == 0 && node.attribute("count").as_ullong() > 0;
                        }));
                return known->second;
            }

            std::size_t bytes_;
            Expansion expansion_;
            /** Whether a source has one; looked for once */
            std::map<pugi::xml_node, bool> accessors_;
        };
    }

    std::string plainCollada(const std::string &text)
    {
        pugi::xml_document document;
        if (const auto result = document.load_buffer(text.data(), text.size(), pugi::parse_full); !result)
            fail(std::string("it is not XML: ") + result.description());
        leaveBonesOut(document);
        Check check(text.size());
        document.traverse(check);
        check.finish();
        std::ostringstream plain;
        document.save(plain, "", pugi::format_raw);
        return plain.str();
    }
}
