#include "ObjText.h"

#include "MeshWords.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::string_view LINE_ENDS("\n\r\f\0", 4), BYTE_ORDER_MARK = "\xEF\xBB\xBF";
        constexpr std::size_t MOST_PARTS = 10000;

        [[noreturn]] void fail(const std::string &complaint)
        {
            throw std::runtime_error(complaint);
        }

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

        /** An index of a vertex, from 1, or backwards from the last, as -1 */
        std::string plainIndex(std::string_view word)
        {
            const bool isNegative = word.substr(0, 1) == "-";
            const std::string_view digits = word.substr(isNegative || word.substr(0, 1) == "+" ? 1 : 0);
            const std::size_t number = wholeNumber(digits, MOST_CORNERS, "the index of a vertex");
            return (isNegative ? "-" : "") + std::to_string(number);
        }

        /** The lines of a file that make up its meshes, written anew */
        class PlainObj
        {
        public:
            void add(std::string_view line)
            {
                // What is numbers may end with a comment, what is a name may contain its sign.
                MeshWords words(line), numbers(line.substr(0, line.find('#')));
                const std::string_view keyword = words.next();
                numbers.next();
                if (keyword == "v" || keyword == "vn" || keyword == "vt")
                    addNumbers(std::string(keyword), numbers);
                else if (keyword == "f" || keyword == "l" || keyword == "p")
                    addCorners(keyword, numbers);
                else if (keyword == "g" || keyword == "o" || keyword == "usemtl")
                    addName(std::string(keyword), words.next());
            }

            const std::string &getText() const
            {
                return text_;
            }

        private:
            void addNumbers(const std::string &keyword, MeshWords &words)
            {
                std::size_t count = 0;
                text_ += keyword;
                for (std::string_view word = words.next(); !word.empty(); word = words.next(), ++count)
                    text_.append(" ").append(plainNumber(word));
                text_ += '\n';
                const bool isKnown = keyword == "v"    ? count == 3 || count == 4 || count == 6
                                     : keyword == "vn" ? count == 3
                                                       : count >= 1 && count <= 3;
                if (!isKnown)
                    fail("a line '" + keyword + "' has " + std::to_string(count) + " numbers");
                // Assimp does not know textures of lines.
                if (keyword == "vt" && count == 1)
                    text_.insert(text_.size() - 1, " 0");
            }

            void addCorners(std::string_view keyword, MeshWords &words)
            {
                if (++faces_ > MOST_TRIANGLES)
                    fail("it has more than " + std::to_string(MOST_TRIANGLES) + " faces");
                text_ += keyword;
                for (std::string_view word = words.next(); !word.empty(); word = words.next())
                {
                    if (++corners_ > MOST_CORNERS)
                        fail("its faces have more than " + std::to_string(MOST_CORNERS) + " corners");
                    text_ += ' ';
                    // Vertex, texture and normal; the texture may be missing
                    for (std::size_t part = 0;; ++part)
                    {
                        const std::size_t end = std::min(word.find('/'), word.size());
                        if (part != 1 || end > 0)
                            text_ += plainIndex(word.substr(0, end));
                        if (end == word.size() || end + 1 == word.size())
                            break;
                        if (part == 2)
                            fail("the corner of a face has more than three indices");
                        text_ += '/';
                        word.remove_prefix(end + 1);
                    }
                }
                text_ += '\n';
            }

            /** Names are looked for one after the other. */
            void addName(const std::string &keyword, std::string_view name)
            {
                if (++parts_ > MOST_PARTS)
                    fail("it has more than " + std::to_string(MOST_PARTS) + " groups, objects and materials");
                text_.append(keyword).append(" ").append(name.substr(0, 100)).append("\n");
            }

            std::string text_;
            std::size_t faces_{0}, corners_{0}, parts_{0};
        };
    }

    std::string plainObj(const std::string &text)
    {
        std::string_view rest = text;
        if (rest.substr(0, BYTE_ORDER_MARK.size()) == BYTE_ORDER_MARK)
            rest.remove_prefix(BYTE_ORDER_MARK.size());
        PlainObj obj;
        while (!rest.empty())
            obj.add(takeLine(rest));
        std::string plain = obj.getText();
        if (plain.empty())
            fail("it has neither vertices nor faces");
        // At the end of a line Assimp would join it with the next one, and looks for it beyond its buffer.
        std::replace(plain.begin(), plain.end(), '\\', '/');
        return plain;
    }
}
