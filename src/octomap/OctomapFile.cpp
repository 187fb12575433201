#include "OctomapFile.h"

#include "OctomapCells.h"
#include "files/WholeFile.h"

#include <algorithm>
#include <cstring>
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
            /** How many nodes there are, which messages do not tell, and how many there are at most */
            bool hasNodes{false};
            std::uint64_t nodes{std::numeric_limits<std::uint32_t>::max()};
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
                        requireMap(header, "res");
                        if (!header.hasNodes || header.nodes > std::numeric_limits<std::uint32_t>::max())
                            fail("size: must be the number of nodes, at most 4294967295");
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

            /** The nodes
                \throws ompl::Exception unless there are as many as the header says, none deeper than octomap can count,
                and nothing after them */
            MapNodes readNodes(const Header &header) const
            {
                // The number of nodes may be wrong.
                MapNodes nodes(header.resolution, std::min<std::size_t>(header.nodes, text_.size()));
                std::size_t at = header.data;
                if (header.hasNodes ? header.nodes > 0 : at < text_.size())
                {
                    const std::size_t root = nodes.addRoot();
                    // Of a binary file's root without children octomap says so.
                    nodes.setOccupied(root, header.isBinary);
                    header.isBinary ? readBinary(at, nodes, root, 0, header) : readFull(at, nodes, root, 0, header);
                }
                if (header.hasNodes && nodes.size() != header.nodes)
                    fail("size: there are " + std::to_string(nodes.size()) + " nodes, not " +
                         std::to_string(header.nodes));
                // A file may end with empty lines.
                if (header.hasNodes ? text_.find_first_not_of('\n', at) != std::string::npos : at < text_.size())
                    fail("goes on after its last node");
                return nodes;
            }

            /** Refuses other kinds of maps
                \param resolution the name of its key */
            void requireMap(const Header &header, const std::string &resolution) const
            {
                if (header.type != "OcTree" && header.type != "ColorOcTree" && header.type != "OcTreeStamped" &&
                    !(header.isBinary && header.type == "1"))
                    fail("id: must be OcTree, ColorOcTree or OcTreeStamped, not '" + header.type + "'");
                // Centers of all cells are then coordinates that shapes may have, too.
                if (!(header.resolution >= 1e-9 && header.resolution <= 1e4))
                    fail(resolution + ": must be a number from 1e-9 to 1e4");
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

            const char *take(std::size_t &at, std::size_t bytes, unsigned int depth) const
            {
                if (depth > OCTOMAP_DEPTH)
                    fail("is damaged: it has nodes deeper than " + std::to_string(OCTOMAP_DEPTH) + " levels");
                if (text_.size() - at < bytes)
                    fail("ends before its last node");
                at += bytes;
                return text_.data() + at - bytes;
            }

            /** Adds children unless there are too many: a small damaged file may tell of more than there is memory for.
                */
            std::size_t addChildren(MapNodes &nodes, std::size_t node, std::uint8_t children,
                                    const Header &header) const
            {
                const std::size_t first = nodes.addChildren(node, children);
                if (nodes.size() > header.nodes)
                    fail("size: there are more nodes than " + std::to_string(header.nodes));
                return first;
            }

            /** An inner node has two bits for each child: 00 if unknown, 01 if free, 10 if occupied, 11 if it is an
                inner node, too. */
            void readBinary(std::size_t &at, MapNodes &nodes, std::size_t node, unsigned int depth,
                            const Header &header) const
            {
                const char *const bytes = take(at, 2, depth + 1);
                const auto stateOf = [bytes](unsigned int i)
                { return static_cast<unsigned char>(bytes[i / 4]) >> (2 * (i % 4)) & 3U; };
                unsigned int children = 0;
                for (unsigned int i = 0; i < 8; ++i)
                    children |= stateOf(i) != 0 ? 1U << i : 0U;
                std::size_t child = addChildren(nodes, node, static_cast<std::uint8_t>(children), header);
                for (unsigned int i = 0; i < 8; ++i)
                {
                    const unsigned int state = stateOf(i);
                    if (state == 0)
                        continue;
                    nodes.setOccupied(child, state == 2);
                    if (state == 3)
                        readBinary(at, nodes, child, depth + 1, header);
                    ++child;
                }
            }

            /** A node has a number, which is positive or 0 if it is occupied, maybe a color, and a bit for each child.
                */
            void readFull(std::size_t &at, MapNodes &nodes, std::size_t node, unsigned int depth,
                          const Header &header) const
            {
                const std::size_t last = sizeof(float) + header.getColorBytes();
                const char *const bytes = take(at, last + 1, depth);
                float logOdds = 0.0F;
                std::memcpy(&logOdds, bytes, sizeof(float));
                nodes.setOccupied(node, logOdds >= 0.0F);
                const auto children = static_cast<std::uint8_t>(bytes[last]);
                std::size_t child = addChildren(nodes, node, children, header);
                for (unsigned int i = 0; i < 8; ++i)
                    if ((children >> i & 1U) != 0)
                        readFull(at, nodes, child++, depth + 1, header);
            }

            const std::string &text_;
            const std::string &file_;
        };
    }

    MapNodes readOctomap(const std::string &file)
    {
        const std::string content = readRegularFile(file, MOST_BYTES);
        const OctomapText text(content, file);
        return text.readNodes(text.readHeader());
    }

    MapNodes readOctomap(const OctomapMessage &message)
    {
        const std::string name = "octomap";
        const OctomapText text(message.data, name);
        Header header;
        header.isBinary = message.binary;
        header.type = message.id;
        header.resolution = message.resolution;
        text.requireMap(header, "resolution");
        return text.readNodes(header);
    }
}
