#include "XmlFile.h"

#include "files/WholeFile.h"

#include <algorithm>
#include <ompl/util/Exception.h>
#include <set>

namespace ompl_certificates
{
    namespace
    {
        /** Looks through all elements, without recursion. */
        class Walker : public pugi::xml_tree_walker
        {
        public:
            bool for_each(pugi::xml_node &node) override
            {
                deepest_ = std::max(deepest_, depth());
                // Of elements within each other the outer one counts.
                if (isOfXacro(node) && !isOfXacro(node.parent()))
                    ofXacro_.push_back(node);
                if (isLeftToOthers(node))
                    return true;
                const auto hasExpression = [](const pugi::xml_attribute &attribute)
                {
                    const std::string value = attribute.value();
                    return value.find("${") != std::string::npos || value.find("$(") != std::string::npos;
                };
                if (!expression_ && std::any_of(node.attributes().begin(), node.attributes().end(), hasExpression))
                    expression_ = node;
                return true;
            }

            int getDepth() const
            {
                return deepest_;
            }

            /** The outermost elements whose names begin with xacro: */
            const std::vector<pugi::xml_node> &getXacro() const
            {
                return ofXacro_;
            }

            /** The first element that has an expression of xacro, if any has */
            const pugi::xml_node &getExpression() const
            {
                return expression_;
            }

        private:
            static bool isOfXacro(const pugi::xml_node &node)
            {
                return std::string(node.name()).rfind("xacro:", 0) == 0;
            }

            /** Whether a node is within what other programs read, who may have expressions of their own */
            static bool isLeftToOthers(pugi::xml_node node)
            {
                static const std::set<std::string> others{"gazebo", "ros2_control", "transmission"};
                while (node && others.count(node.name()) == 0)
                    node = node.parent();
                return !node.empty();
            }

            int deepest_{0};
            std::vector<pugi::xml_node> ofXacro_;
            pugi::xml_node expression_;
        };
    }

    XmlFile::XmlFile(const std::string &file, const std::string &root) : name_(file), content_(readWholeFile(file))
    {
        const pugi::xml_parse_result result = document_.load_buffer(content_.data(), content_.size());
        if (!result)
            throw ompl::Exception(at(result.offset), std::string("not valid XML: ") + result.description());
        root_ = document_.document_element();
        if (root_.name() != root)
            fail("must begin with <" + root + ">, not <" + root_.name() + ">");
        Walker walker;
        document_.traverse(walker);
        constexpr int deepest = 64;
        if (walker.getDepth() > deepest)
            fail("has elements in elements, more than " + std::to_string(deepest) + " deep");
    }

    std::string XmlFile::at(std::ptrdiff_t offset) const
    {
        const auto end = content_.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ptrdiff_t(content_.size()));
        return name_ + ":" + std::to_string(1 + std::count(content_.begin(), end, '\n'));
    }

    std::vector<std::string> XmlFile::leftOverFromXacro() const
    {
        const std::set<std::string> definitions{"xacro:include", "xacro:macro", "xacro:property",
                                                "xacro:arg",     "xacro:if",    "xacro:unless"};
        Walker walker;
        pugi::xml_node root = root_;
        walker.for_each(root);
        root.traverse(walker);
        if (walker.getExpression())
            fail(walker.getExpression(), "is of a xacro file; expand it first");
        std::vector<std::string> notes;
        for (const pugi::xml_node &node : walker.getXacro())
        {
            if (definitions.count(node.name()) > 0)
                fail(node, "is of a xacro file; expand it first");
            notes.push_back(remark(node, "is left over from a xacro file, and ignored"));
        }
        return notes;
    }

    void XmlFile::fail(const std::string &complaint) const
    {
        throw ompl::Exception(name_, complaint);
    }

    void XmlFile::fail(const pugi::xml_node &node, const std::string &complaint) const
    {
        throw ompl::Exception(remark(node, complaint));
    }

    std::string XmlFile::remark(const pugi::xml_node &node, const std::string &text) const
    {
        return at(node.offset_debug()) + ": <" + node.name() + ">: " + text;
    }

    std::string XmlFile::attribute(const pugi::xml_node &node, const char *name) const
    {
        std::string value = node.attribute(name).value();
        if (value.empty())
            fail(node, std::string(name) + ": missing");
        return value;
    }
}
