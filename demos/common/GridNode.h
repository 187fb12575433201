#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_GRID_NODE_
#define OMPL_CERTIFICATES_DEMOS_COMMON_GRID_NODE_

#include <cstdint>
#include <string>
#include <vector>
#include <yaml-cpp/yaml.h>

namespace demos
{
    /** \brief A node of the YAML file of a grid. What is wrong with it is thrown as an ompl::Exception of one line that
        names the file, the line, the key and the value. */
    class GridNode
    {
    public:
        /** \brief The root of \e text, the content of \e file */
        GridNode(const std::string &text, const std::string &file);

        /** \brief Complain about this node */
        [[noreturn]] void fail(const std::string &complaint) const;

        /** \brief Complain that this node must be something else, and tell what it is */
        [[noreturn]] void failAsNo(const std::string &what) const;

        /** \brief Require a map with no other keys than \e keys, and none twice */
        void allow(const std::vector<std::string> &keys) const;

        /** \brief The keys of this map, in their order, none of them twice */
        std::vector<std::string> keys() const;

        bool has(const std::string &key) const;

        /** \brief The value of \e key in this map, which must be there */
        GridNode at(const std::string &key) const;

        /** \brief The items of this list, of which there must be from 1 to \e most */
        std::vector<GridNode> items(std::size_t most) const;

        /** \brief A text of one line that is not empty */
        std::string text() const;

        /** \brief A text of letters, digits and _ alone, which can be part of a file's name */
        std::string plainName() const;

        /** \brief A number above 0 */
        double positive() const;

        /** \brief A whole number from \e least to \e most */
        std::uint64_t count(std::uint64_t least, std::uint64_t most) const;

        /** \brief true or false */
        bool flag() const;

    private:
        GridNode(const YAML::Node &node, std::string key, std::string file);

        double number() const;

        YAML::Node node_;
        std::string key_, file_;
    };
}

#endif
