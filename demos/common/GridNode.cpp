#include "common/GridNode.h"

#include "ompl_certificates/files/Suggestion.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;

namespace demos
{
    namespace
    {
        bool isControl(char c)
        {
            return std::iscntrl(static_cast<unsigned char>(c)) != 0;
        }

        std::string placeOf(const std::string &file, const YAML::Mark &mark)
        {
            return mark.is_null() ? file : file + ":" + std::to_string(mark.line + 1);
        }

        YAML::Node parse(const std::string &text, const std::string &file)
        {
            try
            {
                return YAML::Load(text);
            }
            catch (const YAML::Exception &e)
            {
                throw ompl::Exception(placeOf(file, e.mark), "not valid YAML: " + e.msg);
            }
        }
    }

    GridNode::GridNode(const std::string &text, const std::string &file) : GridNode(parse(text, file), "", file)
    {
    }

    GridNode::GridNode(const YAML::Node &node, std::string key, std::string file)
      : node_(node), key_(std::move(key)), file_(std::move(file))
    {
    }

    void GridNode::fail(const std::string &complaint) const
    {
        throw ompl::Exception(placeOf(file_, node_.Mark()), key_.empty() ? complaint : key_ + ": " + complaint);
    }

    void GridNode::failAsNo(const std::string &what) const
    {
        std::string is = node_.IsMap() ? "a map" : node_.IsSequence() ? "a list" : node_.IsNull() ? "nothing" : "";
        if (node_.IsScalar())
        {
            constexpr std::size_t longest = 60;
            is = "'" + node_.Scalar().substr(0, longest) + (node_.Scalar().size() > longest ? "...'" : "'");
            std::replace_if(is.begin(), is.end(), isControl, ' ');
        }
        fail("must be " + what + ", not " + is);
    }

    void GridNode::allow(const std::vector<std::string> &known) const
    {
        for (const std::string &key : keys())
            if (std::find(known.begin(), known.end(), key) == known.end())
                at(key).fail("unknown key; known here: " + joined(known) + didYouMean(key, known));
    }

    std::vector<std::string> GridNode::keys() const
    {
        if (!node_.IsMap())
            failAsNo("a map");
        std::vector<std::string> keys;
        for (const auto &entry : node_)
        {
            const std::string key = GridNode(entry.first, key_.empty() ? "a key" : "a key of " + key_, file_).text();
            if (std::find(keys.begin(), keys.end(), key) != keys.end())
                at(key).fail("given twice");
            keys.push_back(key);
        }
        return keys;
    }

    bool GridNode::has(const std::string &key) const
    {
        return node_.IsMap() && node_[key].IsDefined();
    }

    GridNode GridNode::at(const std::string &key) const
    {
        const std::string path = key_.empty() ? key : key_ + "." + key;
        if (!has(key))
            GridNode(node_, path, file_).fail("missing");
        return GridNode(node_[key], path, file_);
    }

    std::vector<GridNode> GridNode::items(std::size_t most) const
    {
        if (!node_.IsSequence())
            failAsNo("a list");
        if (node_.size() == 0 || node_.size() > most)
            fail("must have from 1 to " + std::to_string(most) + " items, not " + std::to_string(node_.size()));
        std::vector<GridNode> items;
        for (const auto &item : node_)
            items.push_back(GridNode(item, key_ + "[" + std::to_string(items.size()) + "]", file_));
        return items;
    }

    std::string GridNode::text() const
    {
        constexpr std::size_t longest = 100;
        if (!node_.IsScalar() || node_.Scalar().empty() || node_.Scalar().size() > longest ||
            std::any_of(node_.Scalar().begin(), node_.Scalar().end(), isControl))
            failAsNo("a text of one line and 1 to " + std::to_string(longest) + " bytes");
        return node_.Scalar();
    }

    std::string GridNode::plainName() const
    {
        const std::string name = text();
        if (!std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; }))
            failAsNo("of letters, digits and _ alone");
        return name;
    }

    double GridNode::number() const
    {
        double value = 0.0;
        // A quoted number has the tag "!" and is a text.
        if (!node_.IsScalar() || node_.Tag() == "!" || !YAML::convert<double>::decode(node_, value) ||
            !std::isfinite(value))
            failAsNo("a number");
        return value;
    }

    double GridNode::positive() const
    {
        const double value = number();
        if (!(value >= 1e-9 && value <= 1e9))
            failAsNo("from 1e-9 to 1e9");
        return value;
    }

    std::uint64_t GridNode::count(std::uint64_t least, std::uint64_t most) const
    {
        const double value = number();
        if (value != std::floor(value) || value < static_cast<double>(least) || value > static_cast<double>(most))
            failAsNo("a whole number from " + std::to_string(least) + " to " + std::to_string(most));
        return static_cast<std::uint64_t>(value);
    }

    bool GridNode::flag() const
    {
        if (!node_.IsScalar() || (node_.Scalar() != "true" && node_.Scalar() != "false"))
            failAsNo("true or false");
        return node_.Scalar() == "true";
    }
}
