#include "CloudReaders.h"
#include "LineReader.h"
#include "MeshPart.h"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace ompl_certificates
{
    namespace
    {
        bool isComment(std::string_view line)
        {
            const std::size_t first = line.find_first_not_of(" \t\r\v\f");
            return first == std::string_view::npos || line[first] == '#' || line.substr(first, 2) == "//";
        }

        using Words = std::vector<std::string_view>;

        /** Which columns are x, y and z, and how many have names */
        struct Columns
        {
            std::array<std::size_t, 3> of{0, 1, 2};
            std::size_t named{0};

            std::size_t getLast() const
            {
                return *std::max_element(of.begin(), of.end());
            }
        };

        /** The words of the line, but no more than \e most */
        Words wordsOf(LineReader &text, std::size_t most = SIZE_MAX)
        {
            Words words;
            for (std::string_view word = text.next(); !word.empty(); word = text.next())
            {
                words.push_back(word);
                if (words.size() == most)
                    break;
            }
            return words;
        }

        bool isUnit(std::string_view text)
        {
            return !text.empty() && (text.front() == '(' || text.front() == '[');
        }

        /** x, y or z, which may be quoted, and followed by a unit: "X (m)" in a file of commas is X_(m) here. Else 3 */
        std::size_t axisOf(std::string_view word)
        {
            std::string name = boost::algorithm::to_lower_copy(std::string(word));
            boost::algorithm::erase_all(name, "\"");
            // Commas with blanks behind them, where only blanks count
            boost::algorithm::trim_right_if(name, boost::algorithm::is_any_of(","));
            if (name.empty() || name[0] < 'x' || name[0] > 'z')
                return 3;
            const std::string_view rest =
                std::string_view(name).substr(std::min(name.find_first_not_of('_', 1), name.size()));
            return name.size() == 1 || isUnit(rest) ? static_cast<std::size_t>(name[0] - 'x') : 3;
        }

        /** Reads the names of columns; none if x, y and z are not among \e words, once each
            \param complaining complains if one of them is there twice; may be null */
        std::optional<Columns> findColumns(const Words &words, const LineReader *complaining)
        {
            Columns columns;
            std::array<int, 3> found{};
            for (const std::string_view word : words)
            {
                // A unit behind a name stands alone where blanks are between the columns.
                if (isUnit(word) && columns.named > 0)
                    continue;
                if (const std::size_t axis = axisOf(word); axis < 3)
                {
                    columns.of[axis] = columns.named;
                    ++found[axis];
                }
                ++columns.named;
            }
            for (std::size_t axis = 0; axis < 3 && complaining; ++axis)
                if (found[axis] > 1)
                    complaining->fail(std::string(1, "xyz"[axis]) + " is named twice");
            return found == std::array<int, 3>{1, 1, 1} ? std::optional(columns) : std::nullopt;
        }

        /** What a comment may name, as numpy writes it: without the sign that begins it, and what ends with a colon */
        Words namesOf(LineReader &comment)
        {
            Words words = wordsOf(comment);
            if (words.empty())
                return words;
            words[0].remove_prefix(std::min(words[0].find_first_not_of("#/"), words[0].size()));
            const auto isName = [](std::string_view word) { return !word.empty() && word.back() != ':'; };
            words.erase(words.begin(), std::find_if(words.begin(), words.end(), isName));
            return words;
        }

        /** Appends a line of fields between commas as words between blanks. A field that is missing becomes no number,
            so that others keep their columns, and blanks within one become underscores. */
        void appendWords(std::string_view line, std::string &text)
        {
            constexpr const char *blanks = " \t";
            const bool hasComma = line.find(',') != std::string_view::npos;
            if (!isComment(line))
                line = line.substr(0, std::min(line.find(" #"), line.find("\t#")));
            if (isComment(line) && !line.empty())
            {
                // Its sign may stand by itself.
                const std::size_t sign = std::min(line.find_first_not_of(" \t#/"), line.size());
                text.append(line.substr(0, sign));
                line.remove_prefix(sign);
            }
            if (!hasComma)
            {
                text.append(line);
                return;
            }
            for (bool isLast = false; !isLast;)
            {
                const std::size_t end = line.find(',');
                isLast = end == std::string_view::npos;
                std::string field(line.substr(0, end));
                boost::algorithm::trim_if(field, boost::algorithm::is_any_of(blanks));
                std::replace_if(field.begin(), field.end(), boost::algorithm::is_any_of(blanks), '_');
                // What is between commas is no unit of another field.
                text += (field.empty() ? "nan" : isUnit(field) ? '_' + field : field) + ' ';
                line.remove_prefix(isLast ? line.size() : end + 1);
            }
        }

        bool isCount(std::string_view word)
        {
            return std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
        }

        /** The largest number of all for one that is too large */
        std::uint64_t toCount(std::string_view digits)
        {
            std::uint64_t count = 0;
            const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
            return error == std::errc() && end == digits.data() + digits.size() ? count : UINT64_MAX;
        }
    }

    std::vector<Eigen::Vector3d> readXyz(std::string_view content)
    {
        std::vector<Eigen::Vector3d> points;
        Columns columns;
        Words comment;  // The last one before the points that names x, y and z
        bool isFirst = true;
        std::uint64_t rows = 0, told = 0;  // Rows of points, and how many the first line tells of
        LineReader text(content);
        while (text.nextLine())
        {
            if (isComment(text.getLine()))
            {
                if (const Words names = rows == 0 ? namesOf(text) : Words(); findColumns(names, nullptr))
                    comment = names;
                continue;
            }
            const bool mayBeHeader = std::exchange(isFirst, false);
            const Words words = wordsOf(text, rows == 0           ? SIZE_MAX
                                              : columns.named > 0 ? columns.named + 1
                                                                  : columns.getLast() + 1);
            if (mayBeHeader && words.size() == 1 && isCount(words[0]))
            {
                told = toCount(words[0]);
                continue;
            }
            if (const auto header = mayBeHeader ? findColumns(words, &text) : std::nullopt)
            {
                columns = *header;
                continue;
            }
            // A comment may tell of anything. It names the columns if it has as many words.
            if (rows == 0 && columns.named == 0 && comment.size() >= words.size())
                if (const auto header = findColumns(comment, nullptr); header && header->named == words.size())
                    columns.of = header->of;
            // Where numbers have decimal commas, each becomes two.
            if (double more = 0.0; columns.named > 0 && words.size() > columns.named &&
                                   parseNumber(words[columns.named], more) && std::isfinite(more))
                text.fail("there are more numbers than the first line names columns");
            ++rows;
            Eigen::Vector3d point;
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                if (columns.of[axis] >= words.size())
                    text.fail(std::string("there is no ") + "xyz"[axis] + ": the line has " +
                              std::to_string(words.size()) + " of " +
                              std::to_string(columns.named > 0 ? columns.named : columns.getLast() + 1) + " numbers");
                const std::string_view word = words[columns.of[axis]];
                if (word.find(',') != std::string_view::npos)
                    text.fail("there is " + inQuotes(word) + ": commas are only between the columns of .csv files");
                point[static_cast<Eigen::Index>(axis)] = text.toNumber(word);
            }
            if (!point.allFinite())
                continue;
            if (!isPoint(point))
                text.fail("a point has a coordinate beyond 1e9");
            points.push_back(point);
        }
        if (rows < told)
            text.fail("ends after " + std::to_string(rows) + " of " + std::to_string(told) + " points");
        return points;
    }

    std::vector<Eigen::Vector3d> readCsv(std::string_view content)
    {
        std::string text;
        text.reserve(content.size());
        while (!content.empty())
        {
            const std::size_t end = std::min(content.find_first_of("\r\n"), content.size());
            appendWords(content.substr(0, end), text);
            text.append(content.substr(end, 1));
            content.remove_prefix(std::min(end + 1, content.size()));
        }
        return readXyz(text);
    }
}
