#ifndef OMPL_CERTIFICATES_SCENE_YAML_NODE_
#define OMPL_CERTIFICATES_SCENE_YAML_NODE_

#include <memory>
#include <ompl/util/Exception.h>
#include <string>
#include <vector>
#include <yaml-cpp/yaml.h>

namespace ompl_certificates
{
    /** \brief A node of a YAML file that knows its place. Whatever is wrong with it is thrown as an ompl::Exception of
        one line that names the file, the line, the key and the value. */
    class YamlNode
    {
    public:
        /** \brief No coordinate or size may be larger, so that squares and products stay meaningful */
        static constexpr double MAX_NUMBER = 1e9;

        /** \brief No size may be smaller, unless it is zero where that is allowed */
        static constexpr double MIN_SIZE = 1e-9;

        /** \brief Node \e node of \e file at the path \e key, such as robots[1].shape */
        YamlNode(const YAML::Node &node, std::string key, std::string file);

        YamlNode(const YamlNode &) = default;

        /** \brief Not assigned: yaml-cpp would then change the document. */
        YamlNode &operator=(const YamlNode &) = delete;

        ~YamlNode() = default;

        /** \brief Note what may surprise about this node, once; see getNotes() */
        void note(const std::string &remark) const;

        /** \brief What was noted about this node and all others of its file */
        const std::vector<std::string> &getNotes() const
        {
            return *notes_;
        }

        /** \brief The paths that pathBesideFile() returned, for this node and all others of its file */
        const std::vector<std::string> &getPaths() const
        {
            return *paths_;
        }

        /** \brief Complain about this node
            \throws ompl::Exception always */
        [[noreturn]] void fail(const std::string &complaint) const;

        /** \brief What \e make returns. What it throws is wrong with this node.
            \throws ompl::Exception as fail(), if \e make throws one */
        template <typename Make>
        decltype(auto) orFail(const Make &make) const
        {
            try
            {
                return make();
            }
            catch (const ompl::Exception &exception)
            {
                fail(exception.what());
            }
        }

        /** \brief The path of the node */
        const std::string &getKey() const
        {
            return key_;
        }

        /** \brief The node as text for messages, on one line and not long */
        std::string describe() const;

        /** \brief Whether the node is a map */
        bool isMap() const
        {
            return node_.IsMap();
        }

        /** \brief Whether the node is a list */
        bool isList() const
        {
            return node_.IsSequence();
        }

        /** \brief Whether there is nothing, an empty text, or a list or a map of nothing */
        bool isEmpty() const
        {
            return node_.IsNull() || (node_.IsScalar() ? node_.Scalar().empty() : node_.size() == 0);
        }

        /** \brief Require a map with no other keys than \e keys, and none twice */
        void allow(const std::vector<std::string> &keys) const;

        /** \brief The keys of this map, in their order, none of them twice */
        std::vector<std::string> keys() const;

        /** \brief Whether this map has \e key */
        bool has(const std::string &key) const;

        /** \brief The value of \e key in this map, which must be there */
        YamlNode at(const std::string &key) const;

        /** \brief The items of this list, which must be from \e least to \e most */
        std::vector<YamlNode> items(std::size_t least, std::size_t most) const;

        /** \brief The text of a scalar as it stands, which may be empty or of any characters */
        std::string scalar() const;

        /** \brief A text of one line that is not empty */
        std::string text() const;

        /** \brief The path of a file or of a folder: a text that may be as long as systems allow */
        std::string path() const;

        /** \brief path(), relative to the folder of the file that the node is in */
        std::string pathBesideFile() const;

        /** \brief true or false */
        bool boolean() const;

        /** \brief A finite number, no larger than MAX_NUMBER */
        double number() const;

        /** \brief A number from MIN_SIZE to MAX_NUMBER */
        double positive() const;

        /** \brief A list of \e count numbers */
        std::vector<double> numbers(std::size_t count) const;

        /** \brief A list of \e count positive numbers */
        std::vector<double> positives(std::size_t count) const;

    private:
        using Lines = std::shared_ptr<std::vector<std::string>>;

        YamlNode(const YAML::Node &node, std::string key, std::string file, Lines notes, Lines paths);

        /** \brief A node of this file, at the path \e key */
        YamlNode other(const YAML::Node &node, const std::string &key) const;

        void requireMap() const;
        std::string textUpTo(std::size_t longest) const;

        YAML::Node node_;
        std::string key_;
        std::string file_;
        Lines notes_, paths_;
    };
}

#endif
