#include "MeshReaders.h"
#include "LineReader.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <stdexcept>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t HEADER = 80, BEGIN = 84, FACET = 50;

        /** The next word, wherever it is, in small letters */
        std::string nextWord(LineReader &text)
        {
            std::string word(text.next());
            while (word.empty() && text.nextLine())
                word = text.next();
            std::transform(word.begin(), word.end(), word.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            return word;
        }

        void require(LineReader &text, const char *word)
        {
            if (const std::string found = nextWord(text); found != word)
                text.fail("there is " + inQuotes(found) + " where '" + word + "' should be");
        }

        /** A facet after the first word */
        void readFacet(LineReader &text, MeshPart &part)
        {
            MeshPart::Vertex vertex;
            require(text, "normal");
            for (float &coordinate : vertex.normal)
                coordinate = static_cast<float>(text.toNumber(text.next()));
            require(text, "outer");
            require(text, "loop");
            for (int corner = 0; corner < 3; ++corner)
            {
                require(text, "vertex");
                vertex.point = text.point();
                part.add(vertex);
            }
            require(text, "endloop");
            require(text, "endfacet");
            part.closeTriangle();
        }

        void readText(std::string_view content, MeshCollector &mesh)
        {
            LineReader text(content);
            for (std::string word = nextWord(text); !word.empty(); word = nextWord(text))
            {
                if (word != "solid")
                    text.fail("there is " + inQuotes(word) +
                              " where a solid should begin, and a binary file has another size");
                MeshPart part;
                part.hasNormals = true;
                // What follows in the line is a name.
                for (text.nextLine(), word = nextWord(text); word == "facet"; word = nextWord(text))
                    readFacet(text, part);
                if (word != "endsolid")
                    text.fail("there is " + inQuotes(word) + " where a facet should begin, or a solid end");
                text.nextLine();
                mesh.add(part);
            }
        }

        void readBinary(std::string_view content, MeshCollector &mesh)
        {
            MeshPart part;
            part.hasNormals = true;
            for (std::size_t begin = BEGIN; begin < content.size(); begin += FACET)
            {
                Eigen::Matrix<float, 3, 4> columns;
                std::memcpy(columns.data(), &content[begin], sizeof(float) * 12);
                for (Eigen::Index corner = 1; corner <= 3; ++corner)
                {
                    part.add({columns.col(corner).cast<double>(), columns.col(0)});
                    if (!isPoint(part.vertices.back().point))
                        throw std::runtime_error("byte " + std::to_string(begin) + ": " + NO_POINT);
                }
                part.closeTriangle();
            }
            mesh.add(part);
        }
    }

    void readStl(std::string_view content, MeshCollector &mesh)
    {
        std::uint32_t facets = 0;
        if (content.size() >= BEGIN)
            std::memcpy(&facets, &content[HEADER], sizeof(facets));
        if (content.size() == BEGIN + FACET * facets)
            readBinary(content, mesh);
        else if (content.substr(0, BEGIN).find('\0') == std::string_view::npos)
            readText(content, mesh);
        else if (content.size() < BEGIN)
            throw std::runtime_error("has " + std::to_string(content.size()) +
                                     " bytes, fewer than the header of a binary file");
        else
            throw std::runtime_error("its header tells of " + std::to_string(facets) + " facets, which take " +
                                     std::to_string(BEGIN + FACET * facets) + " bytes, but it has " +
                                     std::to_string(content.size()));
    }
}
