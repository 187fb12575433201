#include "OctomapFile.h"

#include "OctomapCells.h"
#include "files/WholeFile.h"

#include <limits>
#include <locale>
#include <ompl/util/Exception.h>
#include <sstream>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::uintmax_t MOST_BYTES = std::uintmax_t(1) << 30U;

        const std::string BINARY_MAGIC = "# Octomap OcTree binary file", FULL_MAGIC = "# Octomap OcTree file";

        /** What octomap needs to know before it reads a map. Its readers trust what they read: a map that ends too
            early can keep them busy forever. */
        struct Header
        {
            bool isBinary{false};
            std::string type;
            double resolution{0.0};
            std::uint64_t nodes{0};
            bool hasNodes{false};
            std::size_t data{0};

            /** How many bytes of a node come after its number, which is all that counts here. Colors of ColorOcTree are
                not in a binary file. */
            std::size_t getColorBytes() const
            {
                return type == "ColorOcTree" && !isBinary ? 3 : 0;
            }
        };

        /** A stream whose numbers have points, whatever the program's locale */
        std::istringstream streamOf(const std::string &text)
        {
            std::istringstream stream(text);
            stream.imbue(std::locale::classic());
            return stream;
        }

        class OctomapText
        {
        public:
            OctomapText(const std::string &text, const std::string &file) : text_(text), file_(file)
            {
            }

            [[noreturn]] void fail(const std::string &complaint) const
            {
                throw ompl::Exception(file_, complaint);
            }

            Header readHeader() const
            {
                std::istringstream lines = streamOf(text_);
                std::string line;
                std::getline(lines, line);
                Header header;
                header.isBinary = startsWith(line, BINARY_MAGIC);
                if (!header.isBinary && !startsWith(line, FULL_MAGIC))
                    fail("is no octomap: its first line must begin with '" + BINARY_MAGIC + "' or '" + FULL_MAGIC +
                         "'");
                while (std::getline(lines, line))
                {
                    std::istringstream words = streamOf(line);
                    std::string key;
                    words >> key;
                    if (key == "data")
                    {
                        // Without a line's end there is no place behind it.
                        if (lines.eof())
                            break;
                        header.data = static_cast<std::size_t>(lines.tellg());
                        requireHeader(header);
                        return header;
                    }
                    if (key == "id")
                        words >> header.type;
                    else if (key == "res")
                        readResolution(words, header);
                    else if (key == "size")
                        header.hasNodes = static_cast<bool>(words >> header.nodes);
                }
                fail("ends before its data");
            }

            /** The nodes as octomap's OcTree reads them
                \throws ompl::Exception unless there are as many as the header says, none deeper than octomap can count,
                and nothing after them */
            std::string takeNodes(const Header &header) const
            {
                std::size_t at = header.data;
                std::uint64_t nodes = 0;
                std::string data;
                if (header.nodes > 0)
                {
                    nodes = 1;
                    header.isBinary ? walkBinary(at, nodes, 0) : walkFull(at, nodes, 0, header.getColorBytes(), data);
                }
                if (nodes != header.nodes)
                    fail("size: there are " + std::to_string(nodes) + " nodes, not " + std::to_string(header.nodes));
                if (text_.find_first_not_of('\n', at) != std::string::npos)
                    fail("goes on after its last node");
                return header.isBinary ? text_.substr(header.data) : data;
            }

        private:
            static bool startsWith(const std::string &line, const std::string &beginning)
            {
                return line.compare(0, beginning.size(), beginning) == 0;
            }

            static void readResolution(std::istream &words, Header &header)
            {
                std::string text;
                words >> text;
                std::istringstream number = streamOf(text);
                if (!(number >> header.resolution) || number.peek() != std::istringstream::traits_type::eof())
                    header.resolution = std::numeric_limits<double>::quiet_NaN();
            }

            void requireHeader(const Header &header) const
            {
                if (header.type != "OcTree" && header.type != "ColorOcTree" && header.type != "OcTreeStamped" &&
                    !(header.isBinary && header.type == "1"))
                    fail("id: must be OcTree, ColorOcTree or OcTreeStamped, not '" + header.type + "'");
                // Centers of all cells are then coordinates that shapes may have, too.
                if (!(header.resolution >= 1e-9 && header.resolution <= 1e4))
                    fail("res: must be a number from 1e-9 to 1e4");
                if (!header.hasNodes)
                    fail("size: must be the number of nodes");
            }

            const char *take(std::size_t &at, std::size_t bytes, unsigned int depth) const
            {
                if (depth > OCTOMAP_DEPTH)
                    fail("is damaged: it has nodes deeper than " + std::to_string(OCTOMAP_DEPTH) + " levels");
                if (text_.size() - at < bytes)
                    fail("ends before its last node");
                at += bytes;
                return text_.data() + at - bytes;
            }

            /** An inner node has two bits for each child: 00 if unknown, 11 if it is an inner node, too. */
            void walkBinary(std::size_t &at, std::uint64_t &nodes, unsigned int depth) const
            {
                const char *const bytes = take(at, 2, depth + 1);
                for (unsigned int i = 0; i < 8; ++i)
                {
                    const unsigned int child = static_cast<unsigned char>(bytes[i / 4]) >> (2 * (i % 4)) & 3U;
                    nodes += child != 0 ? 1 : 0;
                    if (child == 3)
                        walkBinary(at, nodes, depth + 1);
                }
            }

            /** A node has a number, maybe a color, and a bit for each child. All but colors goes to \e data. */
            void walkFull(std::size_t &at, std::uint64_t &nodes, unsigned int depth, std::size_t colorBytes,
                          std::string &data) const
            {
                const char *const bytes = take(at, sizeof(float) + colorBytes + 1, depth);
                const char last = bytes[sizeof(float) + colorBytes];
                const auto children = static_cast<unsigned char>(last);
                data.append(bytes, sizeof(float)).push_back(last);
                for (unsigned int i = 0; i < 8; ++i)
                    if ((children >> i & 1U) != 0)
                    {
                        ++nodes;
                        walkFull(at, nodes, depth + 1, colorBytes, data);
                    }
            }

            const std::string &text_;
            const std::string &file_;
        };
    }

    std::unique_ptr<octomap::OcTree> readOctomap(const std::string &file)
    {
        const std::string content = readRegularFile(file, MOST_BYTES);
        const OctomapText text(content, file);
        const Header header = text.readHeader();
        const std::string nodes = text.takeNodes(header);
        auto map = std::make_unique<octomap::OcTree>(header.resolution);
        if (header.nodes == 0)
            return map;
        std::istringstream data = streamOf(nodes);
        if (header.isBinary)
            map->readBinaryData(data);
        else
            map->readData(data);
        if (map->size() != header.nodes)
            text.fail("octomap cannot read it");
        return map;
    }
}
