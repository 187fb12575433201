#include "CloudReaders.h"
#include "LineReader.h"
#include "MeshPart.h"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/case_conv.hpp>
#include <cctype>
#include <charconv>
#include <cstdint>
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

        /** Which words of a line are x, y and z */
        using Columns = std::array<std::size_t, 3>;

        /** Reads the names of columns
            \return whether x, y and z are among \e words */
        bool findColumns(const std::vector<std::string_view> &words, const LineReader &text, Columns &columns)
        {
            std::array<int, 3> found{};
            for (std::size_t i = 0; i < words.size(); ++i)
            {
                std::string name = boost::algorithm::to_lower_copy(std::string(words[i]));
                name.erase(std::remove(name.begin(), name.end(), '"'), name.end());
                const std::size_t axis = name == "x" ? 0 : name == "y" ? 1 : name == "z" ? 2 : 3;
                if (axis < 3)
                {
                    columns[axis] = i;
                    ++found[axis];
                }
            }
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (found[axis] > 1)
                    text.fail(std::string(1, "xyz"[axis]) + " is named twice");
            return found == std::array<int, 3>{1, 1, 1};
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
        std::vector<std::string_view> words;
        Columns columns{0, 1, 2};
        std::size_t named = 0;  // How many columns the first line names
        bool isFirst = true;
        std::uint64_t rows = 0, told = 0;  // Rows of points, and how many the first line tells of
        LineReader text(content);
        while (text.nextLine())
        {
            if (isComment(text.getLine()))
                continue;
            const bool mayBeHeader = std::exchange(isFirst, false);
            words.clear();
            const std::size_t most = mayBeHeader ? SIZE_MAX
                                     : named > 0 ? named + 1
                                                 : 1 + *std::max_element(columns.begin(), columns.end());
            for (std::string_view word = text.next(); !word.empty(); word = text.next())
            {
                words.push_back(word);
                if (words.size() == most)
                    break;
            }
            if (mayBeHeader && words.size() == 1 && isCount(words[0]))
            {
                told = toCount(words[0]);
                continue;
            }
            if (mayBeHeader && findColumns(words, text, columns))
            {
                named = words.size();
                continue;
            }
            // Where numbers have decimal commas, each becomes two.
            if (double more = 0.0;
                named > 0 && words.size() > named && parseNumber(words[named], more) && std::isfinite(more))
                text.fail("there are more numbers than the first line names columns");
            ++rows;
            Eigen::Vector3d point;
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                if (columns[axis] >= words.size())
                    text.fail(std::string("there is no ") + "xyz"[axis] + ": the line has " +
                              std::to_string(words.size()) + " of " + std::to_string(named > 0 ? named : 3) +
                              " numbers");
                const std::string_view word = words[columns[axis]];
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
        // A value that is missing is no number, so that others keep their columns.
        std::string text;
        text.reserve(content.size());
        bool isMissing = true, hasComma = false;
        const auto endField = [&] { text += isMissing ? " nan " : " "; };
        for (const char c : content)
        {
            const bool isEnd = c == '\n' || c == '\r';
            if (c == ',' || (isEnd && hasComma))
                endField();
            if (c != ',')
                text += c;
            if (c == ',' || isEnd)
                isMissing = true;
            else if (c != ' ' && c != '\t')
                isMissing = false;
            hasComma = c == ',' || (hasComma && !isEnd);
        }
        if (hasComma)
            endField();
        return readXyz(text);
    }
}
