#include "ColladaDocument.h"

#include <algorithm>
#include <stdexcept>

namespace ompl_certificates
{
    ColladaDocument::ColladaDocument(std::string_view content) : content_(content)
    {
        constexpr std::size_t most = 128U << 20U;
        if (content_.size() > most)
            throw std::runtime_error("it is larger than " + std::to_string(most >> 20U) + " MB");
        if (const auto result = document_.load_buffer(content_.data(), content_.size()); !result)
            fail(result.offset, std::string("it is not XML: ") + result.description());
        if (!getRoot())
            throw std::runtime_error("it has no element <COLLADA>");
        ids_.read(document_);
    }

    void ColladaDocument::fail(std::ptrdiff_t offset, const std::string &complaint) const
    {
        const std::string_view before = content_.substr(0, static_cast<std::size_t>(offset));
        throw std::runtime_error("line " + std::to_string(1 + std::count(before.begin(), before.end(), '\n')) + ": " +
                                 complaint);
    }

    void ColladaDocument::fail(const Node &node, const std::string &complaint) const
    {
        fail(node.offset_debug(), std::string("<") + node.name() + "> " + complaint);
    }

    ColladaDocument::Node ColladaDocument::find(const Node &from, const char *attribute, std::string_view name) const
    {
        const std::string_view url = valueOf(from, attribute);
        if (url.substr(0, 1) != "#")
            return {};
        const auto [node, hasOthers] = ids_.find(name, url.substr(1), mesh_);
        if (hasOthers)
            fail(from, "is of " + inQuotes(url) + ", but there are two <" + std::string(name) + "> of that id");
        return node;
    }

    ColladaDocument::Node ColladaDocument::require(const Node &from, const char *attribute,
                                                   const std::string &name) const
    {
        const Node found = find(from, attribute, name);
        if (!found)
            fail(from, "is of the <" + name + "> " + inQuotes(valueOf(from, attribute)) + ", which is not there");
        return found;
    }

    std::size_t ColladaDocument::wholeAttribute(const Node &node, const std::string &name, std::size_t otherwise) const
    {
        const pugi::xml_attribute attribute = node.attribute(name.c_str());
        // What is counted takes a byte each.
        if (attribute && (!parseNumber(attribute.value(), otherwise) || otherwise > content_.size()))
            fail(node, "has the " + name + " " + inQuotes(attribute.value()) + ", not a number that it can be");
        return otherwise;
    }
}
