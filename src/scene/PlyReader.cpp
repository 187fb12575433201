#include "MeshReaders.h"
#include "CloudReaders.h"
#include "LineReader.h"

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

namespace ompl_certificates
{
    namespace
    {
        struct PlyType
        {
            std::size_t size{0};
            bool isInteger{false};
            double (*convert)(const char *bytes){nullptr};
        };

        template <typename Number>
        PlyType typeOf()
        {
            return {sizeof(Number), std::is_integral_v<Number>,
                    [](const char *bytes)
                    {
                        Number number;
                        std::memcpy(&number, bytes, sizeof(number));
                        return static_cast<double>(number);
                    }};
        }

        /** A longer list ends too early, in any file. */
        constexpr double LONGEST_LIST = std::numeric_limits<std::uint32_t>::max();

        const std::map<std::string, PlyType> TYPES{
            {"char", typeOf<std::int8_t>()},     {"int8", typeOf<std::int8_t>()},
            {"uchar", typeOf<std::uint8_t>()},   {"uint8", typeOf<std::uint8_t>()},
            {"short", typeOf<std::int16_t>()},   {"int16", typeOf<std::int16_t>()},
            {"ushort", typeOf<std::uint16_t>()}, {"uint16", typeOf<std::uint16_t>()},
            {"int", typeOf<std::int32_t>()},     {"int32", typeOf<std::int32_t>()},
            {"uint", typeOf<std::uint32_t>()},   {"uint32", typeOf<std::uint32_t>()},
            {"float", typeOf<float>()},          {"float32", typeOf<float>()},
            {"double", typeOf<double>()},        {"float64", typeOf<double>()},
        };

        /** The properties of vertices that count. In a face the list of its vertices does; all others are for
            nothing. */
        const std::vector<std::string> USES{"x", "y", "z", "nx", "ny", "nz", "s", "t", "u", "v"};
        constexpr std::size_t NORMAL = 3, TEXTURE = 6, INDICES = 10, NOTHING = 11;

        struct Property
        {
            PlyType type;
            /** The type of its length, if it is a list; else of no size */
            PlyType lengthType;
            std::size_t use;
        };

        struct Element
        {
            std::string name;
            std::size_t count;
            std::vector<Property> properties;

            bool has(std::size_t use) const
            {
                return std::any_of(properties.begin(), properties.end(),
                                   [use](const Property &property) { return property.use == use; });
            }
        };

        std::string shown(double number)
        {
            std::ostringstream stream;
            stream << std::setprecision(15) << number;
            return stream.str();
        }

        class PlyReader
        {
        public:
            /** \param needsFaces whether there must be faces; else only the vertices count */
            PlyReader(std::string_view content, bool needsFaces)
              : content_(content), text_(content), needsFaces_(needsFaces)
            {
            }

            /** \param work counts the steps of cutting polygons */
            void run(std::size_t &work)
            {
                readHeader();
                for (const Element &element : elements_)
                    // What has no properties is nowhere.
                    for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i)
                        readInstance(element, work);
                if (isText_ ? nextFullLine() : !rest_.empty())
                    fail("there is more than the header speaks of");
            }

            MeshPart takeMesh()
            {
                return std::move(part_);
            }

            std::vector<Eigen::Vector3d> takePoints()
            {
                return std::move(points_);
            }

        private:
            void readHeader()
            {
                if (!text_.nextLine() || (text_.getLine() != "ply" && text_.getLine() != "PLY"))
                    text_.fail("the first line is not 'ply'");
                std::string format;
                for (std::vector<std::string> words{"ply"}; words[0] != "end_header";)
                {
                    if (!nextFullLine())
                        text_.fail("the header has no line 'end_header'");
                    const std::string_view line = text_.getLine();
                    words.clear();
                    for (std::string_view word = text_.next(); !word.empty(); word = text_.next())
                        words.emplace_back(word);
                    if (words[0] == "format" && words.size() == 3 && format.empty())
                        format = words[1];
                    else if (words[0] != "end_header" && words[0] != "comment" && words[0] != "obj_info" &&
                             !addElement(words) && !addProperty(words))
                        text_.fail("there is " + inQuotes(line) + ", which makes no sense in this header");
                }
                isText_ = format == "ascii";
                isBigEndian_ = format == "binary_big_endian";
                if (!isText_ && !isBigEndian_ && format != "binary_little_endian")
                    text_.fail("the format is " + inQuotes(format) +
                               ", neither ascii nor binary_little_endian nor binary_big_endian");
                std::string order;
                for (const Element &element : elements_)
                    if (element.name == "face" && needsFaces_)
                        order += element.has(INDICES) ? "face " : "";
                    else if (element.name == "vertex")
                    {
                        order += element.has(0) && element.has(1) && element.has(2) ? "vertex " : "";
                        part_.hasNormals = element.has(NORMAL);
                    }
                if (!needsFaces_ && order != "vertex ")
                    text_.fail("there is not one element 'vertex', with x, y and z");
                if (needsFaces_ && order != "vertex face ")
                    text_.fail(
                        "there is not one element 'vertex', with x, y and z, and then one 'face', with a list of "
                        "whole numbers 'vertex_indices'");
                rest_ = text_.getRest();
            }

            /** \return whether \e words are an element, of which there can be so many. Triangle strips are not
                supported. */
            bool addElement(const std::vector<std::string> &words)
            {
                std::size_t count;
                // Each takes at least a byte.
                if (words[0] != "element" || words.size() != 3 || !parseNumber(words[2], count) ||
                    count > content_.size() || (words[1] == "tristrips" && count > 0))
                    return false;
                elements_.push_back({words[1], count, {}});
                return true;
            }

            /** \return whether \e words are a property that the last element does not have yet */
            bool addProperty(const std::vector<std::string> &words)
            {
                const bool isList = words.size() == 5 && words[1] == "list";
                if (words[0] != "property" || elements_.empty() || (words.size() != 3 && !isList))
                    return false;
                const auto type = TYPES.find(words[words.size() - 2]), length = TYPES.find(words[isList ? 2 : 1]);
                if (type == TYPES.end() || length == TYPES.end() || (isList && !length->second.isInteger))
                    return false;
                Element &element = elements_.back();
                std::size_t use = NOTHING;
                const auto found = std::find(USES.begin(), USES.end(), boost::algorithm::to_lower_copy(words.back()));
                if (element.name == "vertex" && !isList && found != USES.end())
                    use = static_cast<std::size_t>(found - USES.begin());
                if (element.name == "face" && isList && type->second.isInteger &&
                    (words.back() == "vertex_indices" || words.back() == "vertex_index"))
                    use = INDICES;
                if (use != NOTHING && element.has(use))
                    return false;
                element.properties.push_back({type->second, isList ? length->second : PlyType(), use});
                return true;
            }

            /** Go to the next line that is not empty. \return whether there is one */
            bool nextFullLine()
            {
                while (text_.nextLine())
                    if (text_.getLine().find_first_not_of(" \t\v\f") != std::string_view::npos)
                        return true;
                return false;
            }

            void readInstance(const Element &element, std::size_t &work)
            {
                if (isText_ && !nextFullLine())
                    fail("it ends before the last " + inQuotes(element.name));
                double values[NOTHING + 1] = {};
                std::vector<std::uint32_t> corners;
                for (const Property &property : element.properties)
                {
                    const double length = property.lengthType.size > 0 ? value(property.lengthType) : 1.0;
                    if (!(length >= 0.0 && length == std::floor(length)))
                        fail("there is a list of length " + shown(length));
                    const auto count = static_cast<std::uint32_t>(std::min(length, LONGEST_LIST));
                    for (std::uint32_t i = 0; i < count; ++i)
                    {
                        const double index = values[property.use] = value(property.type);
                        if (property.use != INDICES || !needsFaces_)
                            continue;
                        if (!(index >= 0.0 && index < static_cast<double>(part_.vertices.size()) &&
                              index == std::floor(index)))
                            fail("there is the index " + shown(index) + " of one of " +
                                 std::to_string(part_.vertices.size()) + " vertices");
                        corners.push_back(static_cast<std::uint32_t>(index));
                    }
                }
                if (isText_ && !text_.next().empty())
                    fail("there are more numbers than the element " + inQuotes(element.name) + " and its lists need");
                if (element.name == "face" && needsFaces_)
                    part_.addPolygon(corners, work);
                if (element.name != "vertex")
                    return;
                const Eigen::Vector3d point(values), normal(values + NORMAL),
                    texture(values[TEXTURE] + values[TEXTURE + 2], values[TEXTURE + 1] + values[TEXTURE + 3], 0.0);
                // Clouds have such where nothing was seen.
                if (!needsFaces_ && !point.allFinite())
                    return;
                if (!isPoint(point))
                    fail(NO_POINT);
                if (needsFaces_)
                    part_.add({point, normal.cast<float>(), texture.cast<float>()});
                else
                    points_.push_back(point);
            }

            double value(const PlyType &type)
            {
                if (isText_)
                {
                    const std::string_view word = text_.next();
                    if (word.empty())
                        fail("there are fewer numbers than the element and its lists need");
                    return text_.toNumber(word);
                }
                if (rest_.size() < type.size)
                    fail("it ends before the elements that the header speaks of, or within a list");
                char bytes[sizeof(double)];
                std::memcpy(bytes, rest_.data(), type.size);
                if (isBigEndian_)
                    std::reverse(bytes, bytes + type.size);
                rest_.remove_prefix(type.size);
                return type.convert(bytes);
            }

            /** Complain about a line, or what is before a byte. */
            [[noreturn]] void fail(const std::string &complaint) const
            {
                if (isText_)
                    text_.fail(complaint);
                throw std::runtime_error("byte " + std::to_string(content_.size() - rest_.size()) + ": " + complaint);
            }

            std::string_view content_, rest_;
            LineReader text_;
            const bool needsFaces_;
            MeshPart part_;
            /** Without faces, of which there may be more than corners of a mesh */
            std::vector<Eigen::Vector3d> points_;
            std::vector<Element> elements_;
            bool isText_{true}, isBigEndian_{false};
        };
    }

    void readPly(std::string_view content, MeshCollector &mesh)
    {
        PlyReader reader(content, true);
        reader.run(mesh.work);
        MeshPart part = reader.takeMesh();
        mesh.add(part);
    }

    std::vector<Eigen::Vector3d> readPlyPoints(std::string_view content)
    {
        std::size_t work = 0;
        PlyReader reader(content, false);
        reader.run(work);
        return reader.takePoints();
    }
}
