#include "PlyText.h"

#include "MeshWords.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t MOST_HEADER = 100000;

        struct Type
        {
            std::size_t size;
            bool isInteger, isSigned;
        };

        struct Property
        {
            /** The line of the header without the name */
            std::string line;
            std::string name;
            Type type;
            /** The type of its length, if it is a list; else of no size */
            Type lengthType;
        };

        struct Element
        {
            std::string name;
            std::size_t count;
            std::vector<Property> properties;
        };

        struct Header
        {
            std::string format;
            std::vector<Element> elements;
            /** Where the data begins */
            std::size_t end;
        };

        [[noreturn]] void fail(const std::string &complaint)
        {
            throw std::runtime_error(complaint);
        }

        Type typeOf(const std::string &name)
        {
            static const std::map<std::string, Type> types{
                {"char", {1, true, true}},     {"int8", {1, true, true}},     {"uchar", {1, true, false}},
                {"uint8", {1, true, false}},   {"short", {2, true, true}},    {"int16", {2, true, true}},
                {"ushort", {2, true, false}},  {"uint16", {2, true, false}},  {"int", {4, true, true}},
                {"int32", {4, true, true}},    {"uint", {4, true, false}},    {"uint32", {4, true, false}},
                {"float", {4, false, true}},   {"float32", {4, false, true}}, {"double", {8, false, true}},
                {"float64", {8, false, true}},
            };
            const auto found = types.find(name);
            if (found == types.end())
                fail("its header has a property of type '" + name.substr(0, 30) + "'");
            return found->second;
        }

        bool isWholeNumber(std::string_view word)
        {
            return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
        }

        Property propertyOf(const std::vector<std::string> &words)
        {
            std::string line;
            for (std::size_t i = 0; i + 1 < words.size(); ++i)
                line += words[i] + " ";
            if (words.size() == 3)
                return {line, words[2], typeOf(words[1]), {}};
            if (words.size() != 5 || words[1] != "list")
                fail("its header has a property that is neither a value nor a list");
            Property property{line, words[4], typeOf(words[3]), typeOf(words[2])};
            if (!property.lengthType.isInteger)
                fail("its header has a list whose length is no whole number but a " + words[2]);
            return property;
        }

        void checkVertices(const Element &vertices)
        {
            if (vertices.count > MOST_CORNERS)
                fail("it has more than " + std::to_string(MOST_CORNERS) + " vertices");
            for (const char *const axis : {"x", "y", "z"})
                if (std::count_if(vertices.properties.begin(), vertices.properties.end(),
                                  [&](const Property &property)
                                  { return property.name == axis && property.lengthType.size == 0; }) != 1)
                    fail(std::string("its header has an element 'vertex' without one property '") + axis + "'");
        }

        /** One list of vertices; Assimp believes that those of the texture fit to it, so all others get another name. */
        void checkFaces(Element &faces)
        {
            std::size_t lists = 0;
            for (Property &property : faces.properties)
                if (property.name == "vertex_indices" || property.name == "vertex_index")
                {
                    ++lists;
                    if (property.lengthType.size == 0 || !property.type.isInteger)
                        fail("its header has faces whose vertices are not a list of whole numbers");
                }
                else
                    property.name = "nothing";
            if (lists != 1)
                fail("its header has an element 'face' without one list 'vertex_indices'");
            if (faces.count > MOST_TRIANGLES)
                fail("it has more than " + std::to_string(MOST_TRIANGLES) + " faces");
        }

        /** Drop what is not of the mesh. */
        void keepMesh(std::vector<Element> &elements)
        {
            const auto named = [&](const char *name)
            { return [name](const Element &element) { return element.name == name; }; };
            const auto isMesh = [&](const Element &element)
            { return element.name == "vertex" || element.name == "face"; };
            const auto count = [&](const char *name)
            { return std::count_if(elements.begin(), elements.end(), named(name)); };
            elements.erase(std::remove_if(elements.begin(), elements.end(),
                                          [&](const Element &element)
                                          { return element.count == 0 && !isMesh(element); }),
                           elements.end());
            // Of a strip Assimp keeps the last triangle.
            if (count("tristrips") > 0)
                fail("its header has triangle strips, which are not supported: it needs faces");
            while (!elements.empty() && !isMesh(elements.back()))
                elements.pop_back();
            if (!std::all_of(elements.begin(), elements.end(), isMesh))
                fail("its header has other elements before those of vertices and faces");
            if (count("vertex") != 1 || count("face") != 1)
                fail("its header has not one element of vertices and one of faces");
            for (Element &element : elements)
                element.name == "vertex" ? checkVertices(element) : checkFaces(element);
        }

        Header readHeader(const std::string &text)
        {
            Header header;
            for (std::size_t at = 0;;)
            {
                const std::size_t end = text.find('\n', at);
                if (end == std::string::npos)
                    fail("its header has no line 'end_header'");
                std::istringstream stream(text.substr(at, end - at));
                std::vector<std::string> words;
                for (std::string word; stream >> word;)
                    words.push_back(word);
                const bool isFirst = at == 0;
                at = end + 1;
                if (isFirst && (words.size() != 1 || (words[0] != "ply" && words[0] != "PLY")))
                    fail("its first line is not 'ply'");
                // Assimp's time for a header grows with its square, and one of a megabyte it cannot read.
                if (at > MOST_HEADER)
                    fail("its header is longer than " + std::to_string(MOST_HEADER) + " bytes");
                if (isFirst || words.empty() || words[0] == "comment" || words[0] == "obj_info")
                    continue;
                for (const std::string &word : words)
                    if (!std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isgraph(c) != 0; }))
                        fail("its header has characters that cannot be printed");
                if (words[0] == "format" && words.size() == 3 && header.format.empty())
                    header.format = words[1];
                else if (words[0] == "element" && words.size() == 3)
                {
                    // Each takes at least a byte.
                    if (!isWholeNumber(words[2]) || words[2].size() > 15 || std::stoull(words[2]) > text.size())
                        fail("it says that it has " + words[2].substr(0, 30) + " of '" + words[1].substr(0, 30) +
                             "', in " + std::to_string(text.size()) + " bytes");
                    header.elements.push_back({words[1], std::stoull(words[2]), {}});
                }
                else if (words[0] == "property" && !header.elements.empty())
                    header.elements.back().properties.push_back(propertyOf(words));
                else if (words[0] == "end_header" && words.size() == 1)
                {
                    header.end = at;
                    break;
                }
                else
                    fail("its header has a line '" + words[0].substr(0, 30) + "' that makes no sense there");
            }
            keepMesh(header.elements);
            return header;
        }

        /** Add to the corners of all faces. */
        void addCorners(std::size_t &corners, std::size_t values)
        {
            if ((corners += values) > MOST_CORNERS)
                fail("its lists have more than " + std::to_string(MOST_CORNERS) + " values");
        }

        /** \e line, written anew */
        std::string plainLine(const Element &element, std::string_view line, std::size_t &corners)
        {
            MeshWords words(line);
            std::string plain;
            const auto take = [&](const Type &type)
            {
                const std::string_view word = words.next();
                if (word.empty())
                    fail("a line has fewer numbers than its element and its lists need");
                const std::size_t sign = type.isSigned && word[0] == '-' ? 1 : 0;
                if (type.isInteger)
                    wholeNumber(word.substr(sign), (std::size_t(1) << (8 * type.size - (type.isSigned ? 1 : 0))) - 1,
                                "a number of its type");
                plain.append(type.isInteger ? std::string(word) : plainNumber(word)).append(" ");
            };
            for (const Property &property : element.properties)
            {
                std::size_t values = 1;
                if (property.lengthType.size > 0)
                {
                    // However long: the line ends, and so this does, where numbers are lacking.
                    values = wholeNumber(words.next(), line.size(), "the length of a list");
                    plain.append(std::to_string(values)).append(" ");
                    addCorners(corners, values);
                }
                for (; values > 0; --values)
                    take(property.type);
            }
            if (!words.next().empty())
                fail("a line has more numbers than its element and its lists need");
            return plain + "\n";
        }

        /** The lines of the elements */
        std::string plainLines(const Header &header, const std::string &text)
        {
            constexpr std::string_view lineEnds("\n\r\f\0", 4);
            std::string_view rest = std::string_view(text).substr(header.end);
            std::string lines;
            std::size_t corners = 0;
            for (const Element &element : header.elements)
                for (std::size_t i = 0; i < element.count;)
                {
                    if (rest.empty())
                        fail("it ends after " + std::to_string(i) + " of its " + std::to_string(element.count) + " '" +
                             element.name + "'");
                    const std::string_view line = rest.substr(0, rest.find_first_of(lineEnds));
                    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
                    if (MeshWords(line).next().empty())
                        continue;
                    lines += plainLine(element, line, corners);
                    ++i;
                }
            return lines;
        }

        /** The length of a list that is at \e bytes */
        std::size_t lengthAt(const char *bytes, const Type &type, bool isBigEndian)
        {
            std::size_t length = 0;
            for (std::size_t i = 0; i < type.size; ++i)
                length = length << 8U | static_cast<unsigned char>(bytes[isBigEndian ? i : type.size - 1 - i]);
            if (type.isSigned && (length >> (8 * type.size - 1)) != 0)
                fail("there is a list of negative length");
            return length;
        }

        /** Some versions of Assimp take a first byte that is an end of a line for the header's, and leave it out. */
        bool isMistaken(const Header &header, const std::string &text)
        {
            return header.format != "ascii" && text.compare(header.end, 1, "\n") == 0;
        }

        /** The bytes of the elements; where Assimp would be mistaken, with one more before each of the first kind */
        std::string plainBytes(const Header &header, const std::string &text)
        {
            std::string bytes;
            bytes.reserve(text.size());
            std::size_t at = header.end, corners = 0;
            const auto pass = [&](std::size_t count, std::size_t size)
            {
                if (count > (text.size() - at) / size)
                    fail("it ends before the elements that its header speaks of, or within a list");
                at += count * size;
            };
            for (const Element &element : header.elements)
                for (std::size_t i = 0; i < element.count; ++i)
                {
                    const std::size_t first = at;
                    for (const Property &property : element.properties)
                    {
                        std::size_t values = 1;
                        if (const Type &type = property.lengthType; type.size > 0)
                        {
                            const std::size_t before = at;
                            pass(1, type.size);
                            values = lengthAt(&text[before], type, header.format == "binary_big_endian");
                        }
                        pass(values, property.type.size);
                        if (property.lengthType.size > 0)
                            addCorners(corners, values);
                    }
                    if (&element == &header.elements.front() && isMistaken(header, text))
                        bytes += ' ';
                    bytes.append(text, first, at - first);
                }
            return bytes;
        }
    }

    std::string plainPly(const std::string &text)
    {
        const Header header = readHeader(text);
        std::string plain = "ply\nformat " + header.format + " 1.0\n";
        for (const Element &element : header.elements)
        {
            plain += "element " + element.name + " " + std::to_string(element.count) + "\n";
            if (&element == &header.elements.front() && isMistaken(header, text))
                plain += "property uchar nothing\n";
            for (const Property &property : element.properties)
                plain += property.line + property.name + "\n";
        }
        plain += "end_header\n";
        if (header.format == "ascii")
            return plain + plainLines(header, text);
        if (header.format == "binary_little_endian" || header.format == "binary_big_endian")
            return plain + plainBytes(header, text);
        fail("its format is neither ascii nor binary_little_endian nor binary_big_endian");
    }
}
