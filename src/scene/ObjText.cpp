#include "ObjText.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::string_view BLANKS = " \t\v", LINE_ENDS("\n\r\f\0", 4), BYTE_ORDER_MARK = "\xEF\xBB\xBF";

        /** Take the next line out of \e rest. A backslash at its end joins it with the one that follows. */
        std::string takeLine(std::string_view &rest)
        {
            std::string line;
            for (;;)
            {
                const std::string_view part = rest.substr(0, rest.find_first_of(LINE_ENDS));
                rest.remove_prefix(part.size());
                rest.remove_prefix(rest.substr(0, 2) == "\r\n" ? 2 : std::min<std::size_t>(1, rest.size()));
                line += part;
                if (line.empty() || line.back() != '\\' || rest.empty())
                    return line;
                line.back() = ' ';
            }
        }

        std::size_t countWords(std::string_view line)
        {
            std::size_t count = 0;
            for (std::size_t at = line.find_first_not_of(BLANKS); at != std::string_view::npos;
                 at = line.find_first_not_of(BLANKS))
            {
                ++count;
                line.remove_prefix(at);
                line.remove_prefix(std::min(line.find_first_of(BLANKS), line.size()));
            }
            return count;
        }

        bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words)
        {
            return std::find(words.begin(), words.end(), word) != words.end();
        }
    }

    std::string plainObj(const std::string &text)
    {
        std::string_view rest = text;
        if (rest.substr(0, BYTE_ORDER_MARK.size()) == BYTE_ORDER_MARK)
            rest.remove_prefix(BYTE_ORDER_MARK.size());
        std::string plain;
        plain.reserve(text.size());
        while (!rest.empty())
        {
            const std::string whole = takeLine(rest);
            std::string_view line = whole;
            line.remove_prefix(std::min(line.find_first_not_of(BLANKS), line.size()));
            const std::string_view keyword = line.substr(0, line.find_first_of(BLANKS));
            const bool isNumbers = isOneOf(keyword, {"v", "vn", "vt", "f", "l", "p"});
            if (!isNumbers && !isOneOf(keyword, {"g", "o", "usemtl"}))
                continue;
            if (isNumbers)
                line = line.substr(0, line.find('#'));
            if (const std::size_t words = countWords(line); keyword == "v" && words != 4 && words != 5 && words != 7)
                throw std::runtime_error("a vertex has " + std::to_string(words - 1) +
                                         " coordinates, not 3, with or without a weight or a color");
            plain += line;
            plain += '\n';
        }
        if (plain.empty())
            throw std::runtime_error("it has neither vertices nor faces");
        // At the end of a line Assimp would join it with the next one, and looks for it beyond its buffer.
        std::replace(plain.begin(), plain.end(), '\\', '/');
        return plain;
    }
}
