#include "LineReader.h"

#include "MeshPart.h"

#include <algorithm>
#include <stdexcept>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::string_view BYTE_ORDER_MARK = "\xEF\xBB\xBF";

        bool isBlank(char c)
        {
            return c == ' ' || (c >= '\t' && c <= '\r');
        }
    }

    LineReader::LineReader(std::string_view text, bool isObj) : rest_(text), isObj_(isObj)
    {
        if (rest_.substr(0, BYTE_ORDER_MARK.size()) == BYTE_ORDER_MARK)
            rest_.remove_prefix(BYTE_ORDER_MARK.size());
    }

    bool LineReader::nextLine()
    {
        bool isJoined = true;
        while (isJoined)
        {
            isJoined = isObj_ && !line_.empty() && line_.back() == '\\';
            if (rest_.empty())
            {
                line_ = {};
                return false;
            }
            const auto end = std::find_if(rest_.begin(), rest_.end(), [](char c) { return c == '\n' || c == '\r'; });
            line_ = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
            rest_.remove_prefix(line_.size());
            rest_.remove_prefix(rest_.substr(0, 2) == "\r\n" ? 2 : std::min<std::size_t>(1, rest_.size()));
            ++number_;
        }
        return true;
    }

    std::string_view LineReader::next()
    {
        for (;;)
        {
            const auto begin = std::find_if_not(line_.begin(), line_.end(), isBlank);
            auto end = std::find_if(begin, line_.end(), isBlank);
            if (isObj_ && end == line_.end() && end != begin && end[-1] == '\\')
                --end;
            std::string_view word =
                line_.substr(static_cast<std::size_t>(begin - line_.begin()), static_cast<std::size_t>(end - begin));
            line_.remove_prefix(static_cast<std::size_t>(end - line_.begin()));
            if (const std::size_t comment = word.find('#'); isObj_ && comment != std::string_view::npos)
            {
                // A comment may go on in the next line as well.
                line_ = line_.substr(line_.empty() ? 0 : line_.find_last_not_of('\\') + 1);
                return word.substr(0, comment);
            }
            if (!word.empty() || line_.empty())
                return word;
            // Nothing but a backslash is left.
            line_ = {};
            nextLine();
        }
    }

    double LineReader::toNumber(std::string_view word) const
    {
        double number;
        if (!parseNumber(word, number))
            fail("there is " + inQuotes(word) + ", not a number");
        return number;
    }

    Eigen::Vector3d LineReader::point()
    {
        Eigen::Vector3d point;
        for (double &coordinate : point)
        {
            const std::string_view word = next();
            coordinate = toNumber(word);
            if (!isPoint(Eigen::Vector3d::Constant(coordinate)))
                fail("there is " + inQuotes(word) + ", not a finite number of at most 1e9");
        }
        return point;
    }

    void LineReader::fail(const std::string &complaint) const
    {
        throw std::runtime_error("line " + std::to_string(number_) + ": " + complaint);
    }

    std::string inQuotes(std::string_view word)
    {
        std::string shown(word.substr(0, 40));
        std::replace_if(
            shown.begin(), shown.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
        return "'" + shown + "'";
    }
}
