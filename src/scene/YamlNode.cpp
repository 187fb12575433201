#include "YamlNode.h"

#include "LineReader.h"

#include "ompl_certificates/files/Suggestion.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

namespace ompl_certificates
{
    namespace
    {
        /** \e text on one line, cut if it is long */
        std::string oneLine(std::string text)
        {
            for (char &c : text)
                if (static_cast<unsigned char>(c) < ' ' || c == 127)
                    c = ' ';
            constexpr std::size_t longest = 60;
            if (text.size() > longest)
                text = text.substr(0, longest) + "...";
            return text;
        }

        std::string format(double value)
        {
            std::ostringstream text;
            text.precision(10);
            text << value;
            return text.str();
        }

        std::string countOf(std::size_t count, const std::string &thing)
        {
            return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
        }

        /** A short list of scalars as it stands, another as what it is */
        std::string describeList(const YAML::Node &list)
        {
            constexpr std::size_t longest = 60;
            if (list.size() == 0)
                return "an empty list";
            std::string text;
            for (const auto &item : list)
            {
                if (!item.IsScalar() || text.size() > longest)
                    return "a list";
                text += (text.empty() ? "[" : ", ") + oneLine(item.Scalar());
            }
            return text + "]";
        }
    }

    YamlNode::YamlNode(const YAML::Node &node, std::string key, std::string file)
      : YamlNode(node, std::move(key), std::move(file), std::make_shared<std::vector<std::string>>(),
                 std::make_shared<std::vector<std::string>>())
    {
    }

    YamlNode::YamlNode(const YAML::Node &node, std::string key, std::string file, Lines notes, Lines paths)
      : node_(node), key_(std::move(key)), file_(std::move(file)), notes_(std::move(notes)), paths_(std::move(paths))
    {
    }

    void YamlNode::note(const std::string &remark) const
    {
        const std::string text = key_ + ": " + remark;
        if (std::find(notes_->begin(), notes_->end(), text) == notes_->end())
            notes_->push_back(text);
    }

    YamlNode YamlNode::other(const YAML::Node &node, const std::string &key) const
    {
        return {node, key, file_, notes_, paths_};
    }

    void YamlNode::fail(const std::string &complaint) const
    {
        std::string place = file_;
        if (const YAML::Mark mark = node_.Mark(); mark.line >= 0)
            place += ":" + std::to_string(mark.line + 1);
        throw ompl::Exception(place, key_.empty() ? complaint : key_ + ": " + complaint);
    }

    std::string YamlNode::describe() const
    {
        if (node_.IsMap())
            return "a map";
        if (node_.IsSequence())
            return describeList(node_);
        if (node_.IsNull())
            return "nothing";
        const std::string value = oneLine(node_.Scalar());
        if (value == "...")
            return "'...': was it cut when it was printed? ros2 topic echo has --full-length";
        return node_.Tag() == "!" || value.empty() ? "'" + value + "'" : value;
    }

    void YamlNode::requireMap() const
    {
        if (!node_.IsMap())
            fail("must be a map, not " + describe());
    }

    void YamlNode::allow(const std::vector<std::string> &keys) const
    {
        requireMap();
        std::set<std::string> seen;
        for (const auto &entry : node_)
        {
            if (!entry.first.IsScalar())
                fail("keys must be words");
            const std::string &key = entry.first.Scalar();
            const YamlNode place = other(entry.first, (key_.empty() ? "" : key_ + ".") + oneLine(key));
            if (std::find(keys.begin(), keys.end(), key) == keys.end())
                place.fail("unknown key; known here: " + joined(keys) + didYouMean(key, keys));
            if (!seen.insert(key).second)
                place.fail("given twice");
        }
    }

    std::vector<std::string> YamlNode::keys() const
    {
        requireMap();
        std::vector<std::string> keys;
        for (const auto &entry : node_)
            if (entry.first.IsScalar())
                keys.push_back(entry.first.Scalar());
        allow(keys);
        return keys;
    }

    bool YamlNode::has(const std::string &key) const
    {
        requireMap();
        return node_[key].IsDefined();
    }

    YamlNode YamlNode::at(const std::string &key) const
    {
        const std::string path = (key_.empty() ? "" : key_ + ".") + key;
        if (!has(key))
            other(node_, path).fail("missing");
        return other(node_[key], path);
    }

    std::vector<YamlNode> YamlNode::items(std::size_t least, std::size_t most) const
    {
        if (!node_.IsSequence())
            fail("must be a list, not " + describe());
        if (node_.size() < least || node_.size() > most)
            fail("must have " +
                 (least == most ? countOf(most, "item")
                                : "from " + std::to_string(least) + " to " + countOf(most, "item")) +
                 ", not " + std::to_string(node_.size()));
        std::vector<YamlNode> items;
        items.reserve(node_.size());
        for (const auto &item : node_)
            items.push_back(other(item, key_ + "[" + std::to_string(items.size()) + "]"));
        return items;
    }

    std::string YamlNode::text() const
    {
        return textUpTo(100);
    }

    std::string YamlNode::path() const
    {
        return textUpTo(4095);
    }

    std::string YamlNode::pathBesideFile() const
    {
        paths_->push_back((std::filesystem::path(file_).parent_path() / path()).lexically_normal().string());
        return paths_->back();
    }

    std::string YamlNode::scalar() const
    {
        if (node_.IsNull())
            return "";
        if (!node_.IsScalar())
            fail("must be a text, not " + describe());
        return node_.Scalar();
    }

    std::string YamlNode::textUpTo(std::size_t longest) const
    {
        if (!node_.IsScalar())
            fail("must be a text, not " + describe());
        const std::string &value = node_.Scalar();
        const auto isControl = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 127; };
        if (value.empty() || value.size() > longest || std::any_of(value.begin(), value.end(), isControl))
            fail("must be a text of one line and 1 to " + std::to_string(longest) + " bytes, not '" + oneLine(value) +
                 "'");
        return value;
    }

    bool YamlNode::boolean() const
    {
        // All spellings of YAML's core schema; Python writes True.
        const std::string value = text();
        const bool isTrue = value == "true" || value == "True" || value == "TRUE";
        if (!isTrue && value != "false" && value != "False" && value != "FALSE")
            fail("must be true or false, not " + describe());
        return isTrue;
    }

    double YamlNode::number() const
    {
        double value = 0.0;
        const auto isNumber = [&]
        {
            // By itself yaml-cpp goes by the program's locale, which may have decimal commas. It knows .inf and .nan.
            return parseNumber(node_.Scalar(), value) ||
                   (YAML::convert<double>::decode(node_, value) && !std::isfinite(value));
        };
        // A quoted number has the tag "!" and is a text.
        if (!node_.IsScalar() || node_.Tag() == "!" || !isNumber())
            fail("must be a number, not " + describe());
        if (!std::isfinite(value) || std::abs(value) > MAX_NUMBER)
            fail("must be a finite number of at most " + format(MAX_NUMBER) + ", not " + describe());
        return value;
    }

    double YamlNode::positive() const
    {
        const double value = number();
        if (!(value > 0.0))
            fail("must be positive, not " + format(value));
        if (value < MIN_SIZE)
            fail("must be at least " + format(MIN_SIZE) + ", not " + format(value));
        return value;
    }

    std::vector<double> YamlNode::numbers(std::size_t count) const
    {
        if (!node_.IsSequence() || node_.size() != count)
            fail("must be a list of " + countOf(count, "number") + ", not " +
                 (node_.IsSequence() ? "of " + std::to_string(node_.size()) : describe()));
        std::vector<double> values;
        for (const YamlNode &item : items(count, count))
            values.push_back(item.number());
        return values;
    }

    std::vector<double> YamlNode::positives(std::size_t count) const
    {
        numbers(count);
        std::vector<double> values;
        for (const YamlNode &item : items(count, count))
            values.push_back(item.positive());
        return values;
    }
}
