#ifndef OMPL_CERTIFICATES_SCENE_XML_FILE_
#define OMPL_CERTIFICATES_SCENE_XML_FILE_

#include <pugixml.hpp>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief An XML file with one kind of root element, and complaints that name it */
    class XmlFile
    {
    public:
        /** \brief Read \e file, whose root must be called \e root
            \throws ompl::Exception if it cannot be read, is not valid XML or is nested too deep */
        XmlFile(const std::string &file, const std::string &root);

        /** \brief The root element */
        pugi::xml_node getRoot() const
        {
            return root_;
        }

        /** \brief The file */
        const std::string &getName() const
        {
            return name_;
        }

        /** \brief Notes on elements that xacro has left in the file, which ROS ignores, too
            \throws ompl::Exception if the file was never expanded: it has expressions or definitions of xacro */
        std::vector<std::string> leftOverFromXacro() const;

        /** \brief Complain about the file
            \throws ompl::Exception always */
        [[noreturn]] void fail(const std::string &complaint) const;

        /** \brief Complain about \e node, naming its line
            \throws ompl::Exception always */
        [[noreturn]] void fail(const pugi::xml_node &node, const std::string &complaint) const;

        /** \brief A remark about \e node, naming file and line */
        std::string remark(const pugi::xml_node &node, const std::string &text) const;

        /** \brief An attribute that must be there and not be empty */
        std::string attribute(const pugi::xml_node &node, const char *name) const;

    private:
        std::string at(std::ptrdiff_t offset) const;

        std::string name_, content_;
        pugi::xml_document document_;
        pugi::xml_node root_;
    };
}

#endif
