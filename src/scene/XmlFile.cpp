#include "XmlFile.h"

#include "files/WholeFile.h"

#include <algorithm>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        /** Looks through all elements, without recursion. */
        class Walker : public pugi::xml_tree_walker
        {
        public:
            explicit Walker(std::string prefix) : prefix_(std::move(prefix))
            {
            }

            bool for_each(pugi::xml_node &node) override
            {
                deepest_ = std::max(deepest_, depth());
                found_ =
                    found_ || (!prefix_.empty() && std::string(node.name()).compare(0, prefix_.size(), prefix_) == 0);
                return true;
            }

            int getDepth() const
            {
                return deepest_;
            }

            bool isFound() const
            {
                return found_;
            }

        private:
            std::string prefix_;
            int deepest_{0};
            bool found_{false};
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
        Walker walker("");
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

    bool XmlFile::hasPrefix(const std::string &prefix) const
    {
        Walker walker(prefix);
        pugi::xml_node root = root_;
        return root.traverse(walker) && walker.isFound();
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
