#include "MeshReaders.h"
#include "MeshText.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <stdexcept>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t HEADER = 80, BEGIN = 84, FACET = 50;

        class TextReader
        {
        public:
            TextReader(std::string_view content, MeshCollector &mesh) : text_(content), mesh_(mesh)
            {
            }

            void run()
            {
                for (std::string word = next(); !word.empty(); word = next())
                {
                    if (word != "solid")
                        text_.fail("there is " + inQuotes(word) + " where a solid should begin");
                    // What follows in the line is a name.
                    text_.nextLine();
                    MeshPart part;
                    part.hasNormals = true;
                    for (word = next(); word == "facet"; word = next())
                        readFacet(part);
                    if (word != "endsolid")
                        text_.fail("there is " + inQuotes(word) + " where a facet should begin, or a solid end");
                    text_.nextLine();
                    mesh_.add(part);
                }
            }

        private:
            /** The next word, wherever it is, in small letters */
            std::string next()
            {
                std::string_view word = text_.next();
                while (word.empty() && text_.nextLine())
                    word = text_.next();
                std::string lower(word);
                std::transform(lower.begin(), lower.end(), lower.begin(),
                               [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
                return lower;
            }

            void require(const char *word)
            {
                if (const std::string found = next(); found != word)
                    text_.fail("there is " + inQuotes(found) + " where '" + word + "' should be");
            }

            void readFacet(MeshPart &part)
            {
                MeshPart::Vertex vertex;
                require("normal");
                for (float &coordinate : vertex.normal)
                    coordinate = static_cast<float>(text_.toNumber(text_.next()));
                require("outer");
                require("loop");
                for (int corner = 0; corner < 3; ++corner)
                {
                    require("vertex");
                    vertex.point = text_.point();
                    part.addVertex(vertex);
                }
                require("endloop");
                require("endfacet");
                const auto end = static_cast<std::uint32_t>(part.size());
                part.addTriangle(end - 3, end - 2, end - 1);
            }

            MeshText text_;
            MeshCollector &mesh_;
        };

        /** Little-endian, as the machines that this is built for */
        std::uint32_t facetsOf(std::string_view content)
        {
            std::uint32_t count;
            std::memcpy(&count, &content[HEADER], sizeof(count));
            return count;
        }

        void readBinary(std::string_view content, MeshCollector &mesh)
        {
            MeshPart part;
            part.hasNormals = true;
            for (std::size_t begin = BEGIN; begin < content.size(); begin += FACET)
            {
                float numbers[12];
                std::memcpy(numbers, &content[begin], sizeof(numbers));
                MeshPart::Vertex vertex;
                vertex.normal = Eigen::Map<const Eigen::Vector3f>(numbers);
                for (std::size_t corner = 1; corner <= 3; ++corner)
                {
                    vertex.point = Eigen::Map<const Eigen::Vector3f>(numbers + 3 * corner).cast<double>();
                    if (!(vertex.point.cwiseAbs().maxCoeff() <= MOST_COORDINATE))
                        throw std::runtime_error("byte " + std::to_string(begin) + ": facet " +
                                                 std::to_string((begin - BEGIN) / FACET) +
                                                 " has a coordinate that is not a finite number of at most 1e9");
                    part.addVertex(vertex);
                }
                const auto end = static_cast<std::uint32_t>(part.size());
                part.addTriangle(end - 3, end - 2, end - 1);
            }
            mesh.add(part);
        }
    }

    void readStl(std::string_view content, MeshCollector &mesh)
    {
        if (content.size() >= BEGIN && content.size() == BEGIN + FACET * facetsOf(content))
            readBinary(content, mesh);
        else
            TextReader(content, mesh).run();
    }
}
