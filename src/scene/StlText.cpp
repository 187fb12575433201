#include "StlText.h"

#include "MeshWords.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string_view>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t HEADER = 80, BEGIN = 84, FACET = 50, MOST_SOLIDS = 10000;

        [[noreturn]] void fail(const std::string &complaint)
        {
            throw std::runtime_error(complaint);
        }

        void checkFacets(std::size_t count)
        {
            if (count > MOST_TRIANGLES)
                fail("it has more than " + std::to_string(MOST_TRIANGLES) + " facets");
        }

        /** The number of facets that a file states, if it is binary */
        std::size_t facetsOf(const std::string &text)
        {
            std::size_t count = 0;
            for (std::size_t i = BEGIN; i > HEADER; --i)
                count = count << 8U | static_cast<unsigned char>(text[i - 1]);
            return count;
        }

        bool isBinary(const std::string &text)
        {
            return text.size() >= BEGIN && text.size() == BEGIN + FACET * facetsOf(text);
        }

        /** Follows the words of a file, and writes them anew. */
        class PlainStl
        {
        public:
            explicit PlainStl(std::string_view text) : words_(text)
            {
            }

            std::string run()
            {
                std::string word = next();
                if (word.empty())
                    fail("it is empty");
                for (std::size_t solids = 1, facets = 0; !word.empty(); word = next(), ++solids)
                {
                    if (word != "solid")
                        fail("there is '" + word.substr(0, 20) + "' where a solid should begin");
                    if (solids > MOST_SOLIDS)
                        fail("it has more than " + std::to_string(MOST_SOLIDS) + " solids");
                    skipName();
                    plain_ += "solid s\n";
                    for (word = next(); word == "facet"; word = next(), checkFacets(++facets))
                        takeFacet();
                    if (word != "endsolid")
                        fail("there is '" + word.substr(0, 20) + "' where a facet should begin, or a solid end");
                    skipName();
                    plain_ += "endsolid s\n";
                }
                return plain_;
            }

        private:
            /** The next word, in small letters */
            std::string next()
            {
                std::string word(words_.next());
                std::transform(word.begin(), word.end(), word.begin(),
                               [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
                return word;
            }

            /** What follows in the line is a name. */
            void skipName()
            {
                std::string_view rest = words_.getRest();
                rest.remove_prefix(std::min(rest.find_first_of("\r\n"), rest.size()));
                words_ = MeshWords(rest);
            }

            void take(const char *word)
            {
                if (const std::string found = next(); found != word)
                    fail("there is '" + found.substr(0, 20) + "' where '" + word + "' should be");
                plain_.append(word).append(" ");
            }

            void takePoint()
            {
                for (int axis = 0; axis < 3; ++axis)
                    plain_.append(plainNumber(words_.next())).append(axis < 2 ? " " : "\n");
            }

            void takeFacet()
            {
                plain_ += "facet ";
                take("normal");
                takePoint();
                take("outer");
                take("loop");
                plain_ += '\n';
                for (int corner = 0; corner < 3; ++corner)
                {
                    take("vertex");
                    takePoint();
                }
                take("endloop");
                plain_ += '\n';
                take("endfacet");
                plain_ += '\n';
            }

            MeshWords words_;
            std::string plain_;
        };
    }

    std::string plainStl(const std::string &text)
    {
        if (!isBinary(text))
            return PlainStl(text).run();
        checkFacets(facetsOf(text));
        // What the header says is nothing, but Assimp may take it for a color, a text, or another order of bytes.
        std::string plain = text;
        plain.replace(0, HEADER, HEADER, ' ');
        return plain;
    }
}
