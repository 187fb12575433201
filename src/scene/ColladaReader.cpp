#include "MeshReaders.h"
#include "ColladaIds.h"
#include "LineReader.h"

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <map>
#include <pugixml.hpp>
#include <stdexcept>

namespace ompl_certificates
{
    namespace
    {
        using Node = pugi::xml_node;
        using NameList = std::vector<std::string_view>;

        constexpr std::size_t MOST_CONTENT_BYTES = 128U << 20U, MOST_NODES = 100000, MOST_LEVELS = 1000;
        const NameList COUNTED{"triangles", "polylist", "polygons"},
            UNCOUNTED{"tristrips", "trifans", "lines", "linestrips"};
        constexpr const char *SEMANTICS[] = {"POSITION", "NORMAL", "TEXCOORD"};

        bool isOneOf(const NameList &names, std::string_view name)
        {
            return std::find(names.begin(), names.end(), name) != names.end();
        }

        std::string_view valueOf(const Node &node, const char *attribute)
        {
            return node.attribute(attribute).value();
        }

        /** The values of a <source>, and how to find those of an index */
        struct Source
        {
            std::vector<double> values;
            std::size_t count, stride, offset, size;
        };

        /** A source, and which of the indices of a corner is of it */
        struct Input
        {
            const Source *source{nullptr};
            std::size_t offset{0}, set{0};
        };

        /** Those of each semantic */
        using Inputs = std::array<Input, 3>;

        /** A node that is still to be read, the frame of its parent, and how deep it is nested */
        struct OpenNode
        {
            Node node;
            Eigen::Affine3d parent;
            std::size_t level;
        };

        class ColladaReader
        {
        public:
            ColladaReader(std::string_view content, MeshCollector &mesh) : content_(content), mesh_(mesh)
            {
            }

            void run()
            {
                if (content_.size() > MOST_CONTENT_BYTES)
                    throw std::runtime_error("it is larger than " + std::to_string(MOST_CONTENT_BYTES >> 20U) + " MB");
                if (const auto result = document_.load_buffer(content_.data(), content_.size()); !result)
                    fail(result.offset, std::string("it is not XML: ") + result.description());
                const Node root = document_.child("COLLADA");
                if (!root)
                    throw std::runtime_error("it has no element <COLLADA>");
                ids_.read(document_);
                const Eigen::Affine3d frame = frameOf(root.child("asset"));
                const Node instance = root.child("scene").child("instance_visual_scene");
                const Node scene = instance ? require(instance, "url", "visual_scene")
                                            : root.child("library_visual_scenes").child("visual_scene");
                // Without a scene the geometries are where they are.
                for (const Node &library : root.children("library_geometries"))
                    for (const Node &geometry : library.children("geometry"))
                        for (MeshPart &part : partsOf(geometry))
                            if (!scene)
                                mesh_.add(part, frame);
                if (scene)
                    placeNodes(scene, frame);
            }

        private:
            [[noreturn]] void fail(std::ptrdiff_t offset, const std::string &complaint) const
            {
                const std::string_view before = content_.substr(0, static_cast<std::size_t>(offset));
                throw std::runtime_error("line " + std::to_string(1 + std::count(before.begin(), before.end(), '\n')) +
                                         ": " + complaint);
            }

            [[noreturn]] void fail(const Node &node, const std::string &complaint) const
            {
                fail(node.offset_debug(), std::string("<") + node.name() + "> " + complaint);
            }

            /** The element of that name whose id the attribute gives, if it is there */
            Node find(const Node &from, const char *attribute, std::string_view name) const
            {
                const std::string_view url = valueOf(from, attribute);
                if (url.substr(0, 1) != "#")
                    return {};
                const auto [node, hasOthers] = ids_.find(name, url.substr(1), readMesh_);
                if (hasOthers)
                    fail(from, "is of " + inQuotes(url) + ", but there are two <" + std::string(name) + "> of that id");
                return node;
            }

            Node require(const Node &from, const char *attribute, const std::string &name) const
            {
                const Node found = find(from, attribute, name);
                if (!found)
                    fail(from,
                         "is of the <" + name + "> " + inQuotes(valueOf(from, attribute)) + ", which is not there");
                return found;
            }

            std::size_t wholeAttribute(const Node &node, const std::string &name, std::size_t otherwise) const
            {
                const pugi::xml_attribute attribute = node.attribute(name.c_str());
                // What is counted takes a byte each.
                if (attribute && (!parseNumber(attribute.value(), otherwise) || otherwise > content_.size()))
                    fail(node, "has the " + name + " " + inQuotes(attribute.value()) + ", not a number that it can be");
                return otherwise;
            }

            template <typename Number>
            std::vector<Number> numbersOf(const Node &node) const
            {
                std::vector<Number> numbers;
                for (const Node &child : node.children())
                    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
                        for (LineReader text(child.value()); text.nextLine();)
                            for (std::string_view word = text.next(); !word.empty(); word = text.next())
                                if (!parseNumber(word, numbers.emplace_back()))
                                    fail(node, "has " + inQuotes(word) + ", which is not a number for it");
                return numbers;
            }

            /** What a geometry is made of, which is read once */
            std::vector<MeshPart> &partsOf(const Node &geometry)
            {
                const auto [entry, isNew] = parts_.try_emplace(geometry);
                const Node mesh = geometry.child("mesh");
                readMesh_ = mesh;
                if (mesh.next_sibling("mesh") || mesh.child("vertices").next_sibling("vertices"))
                    fail(geometry, "has several <mesh> or <vertices>");
                for (const Node &primitive : mesh.children())
                    if (isNew && (isOneOf(COUNTED, primitive.name()) || isOneOf(UNCOUNTED, primitive.name())))
                        readPrimitive(primitive, entry->second);
                return entry->second;
            }

            void readPrimitive(const Node &primitive, std::vector<MeshPart> &parts)
            {
                Inputs inputs;
                const std::size_t stride = primitive.child("p") ? readInputs(primitive, inputs) : 1;
                MeshPart part;
                part.hasNormals = inputs[1].source != nullptr;
                std::size_t faces = 0;
                for (const Node &list : primitive.children("p"))
                    faces += addFaces(primitive, cornersOf(list, inputs, stride), part);
                // Of strips and lines some programs state another count.
                if (const std::size_t count = wholeAttribute(primitive, "count", 0);
                    count != faces && isOneOf(COUNTED, primitive.name()))
                    fail(primitive, "has " + std::to_string(faces) + " faces, not " + std::to_string(count));
                if (!part.vertices.empty())
                    parts.push_back(std::move(part));
            }

            /** \return the number of indices of each corner */
            std::size_t readInputs(const Node &primitive, Inputs &inputs)
            {
                std::size_t stride = 1, vertices = 0;
                for (const Node &input : primitive.children("input"))
                {
                    const std::size_t offset = wholeAttribute(input, "offset", 0);
                    stride = std::max(stride, offset + 1);
                    addInput(input, offset, inputs);
                    if (valueOf(input, "semantic") != "VERTEX")
                        continue;
                    ++vertices;
                    for (const Node &shared : require(input, "source", "vertices").children("input"))
                        addInput(shared, offset, inputs);
                }
                if (vertices != 1 || !inputs[0].source)
                    fail(primitive, "has not one input VERTEX of an input POSITION");
                return stride;
            }

            /** Of several sets of textures the lowest counts. */
            void addInput(const Node &input, std::size_t offset, Inputs &inputs)
            {
                const std::size_t set = wholeAttribute(input, "set", 0);
                for (std::size_t i = 0; i < inputs.size(); ++i)
                    if (valueOf(input, "semantic") == SEMANTICS[i])
                    {
                        if (i == 0 && inputs[0].source)
                            fail(input, "is a second POSITION");
                        if (!inputs[i].source || set < inputs[i].set)
                            inputs[i] = {&sourceOf(input, i == 0), offset, set};
                    }
            }

            const Source &sourceOf(const Node &input, bool isOfPoints)
            {
                const Node element = require(input, "source", "source"),
                           accessor = element.child("technique_common").child("accessor");
                std::string names;
                std::size_t parameters = 0;
                for (const Node &parameter : accessor.children("param"))
                {
                    names.append(valueOf(parameter, "name")).append(" ");
                    ++parameters;
                    if (valueOf(parameter, "type") == "float4x4")
                        fail(accessor, "is of matrices");
                }
                if (isOfPoints && names.substr(0, 6) != "X Y Z ")
                    fail(element, "is of positions without X, Y and Z");
                const auto [entry, isNew] = sources_.try_emplace(element);
                Source &source = entry->second;
                if (!isNew)
                    return source;
                const Node array = require(accessor ? accessor : element, "source", "float_array");
                source = {numbersOf<double>(array), wholeAttribute(accessor, "count", 0),
                          wholeAttribute(accessor, "stride", 1), wholeAttribute(accessor, "offset", 0),
                          std::min<std::size_t>(parameters, 3)};
                if (wholeAttribute(array, "count", 0) != source.values.size())
                    fail(array, "has " + std::to_string(source.values.size()) + " numbers, not its count");
                const std::size_t last = source.offset + (source.count - 1) * source.stride + parameters;
                if (source.count > 0 && last > source.values.size())
                    fail(accessor, "goes beyond the values of its <float_array>");
                return source;
            }

            std::vector<MeshPart::Vertex> cornersOf(const Node &list, const Inputs &inputs, std::size_t stride)
            {
                const auto indices = numbersOf<std::uint32_t>(list);
                if ((corners_ += indices.size() / stride) > MOST_CORNERS)
                    fail(list, "is of more than " + std::to_string(MOST_CORNERS) + " corners");
                if (indices.size() % stride != 0)
                    fail(list, "has " + std::to_string(indices.size()) + " numbers, for corners of " +
                                   std::to_string(stride));
                std::vector<MeshPart::Vertex> corners;
                for (std::size_t i = 0; i < indices.size(); i += stride)
                {
                    Eigen::Matrix3d columns = Eigen::Matrix3d::Zero();
                    for (std::size_t k = 0; k < inputs.size(); ++k)
                        if (const Source *source = inputs[k].source)
                        {
                            const std::size_t index = indices[i + inputs[k].offset];
                            if (index >= source->count)
                                fail(list, "has the index " + std::to_string(index) + " of one of " +
                                               std::to_string(source->count) + " in " + SEMANTICS[k]);
                            std::copy_n(source->values.data() + source->offset + index * source->stride, source->size,
                                        columns.col(static_cast<Eigen::Index>(k)).data());
                        }
                    if (!isPoint(columns.col(0)))
                        fail(list, NO_POINT);
                    corners.push_back({columns.col(0), columns.col(1).cast<float>(), columns.col(2).cast<float>()});
                }
                return corners;
            }

            /** Add the faces of one <p>. \return their number */
            std::size_t addFaces(const Node &primitive, const std::vector<MeshPart::Vertex> &corners, MeshPart &part)
            {
                const std::string_view kind = primitive.name();
                std::vector<std::uint32_t> face, sizes;
                std::size_t end = 0;
                if (kind == "polylist")
                    sizes = numbersOf<std::uint32_t>(primitive.child("vcount"));
                else if (kind == "triangles")
                    sizes.assign(corners.size() / 3, 3);
                else if (kind == "polygons")
                    sizes.assign(1, static_cast<std::uint32_t>(corners.size()));
                for (const std::uint32_t size : sizes)
                {
                    face.clear();
                    for (std::size_t last = end + size; end < last && end < corners.size(); ++end)
                        face.push_back(part.add(corners[end]));
                    if (face.size() < size)
                        fail(primitive, "has fewer corners than its faces need");
                    part.addPolygon(face, mesh_.work);
                }
                if (isOneOf(COUNTED, kind) && end != corners.size())
                    fail(primitive, "has more corners than its faces need");
                if (kind == "lines" || kind == "linestrips")
                    for (const MeshPart::Vertex &corner : corners)
                        part.loose.push_back(part.add(corner));
                else if (!isOneOf(COUNTED, kind))
                    for (std::size_t i = 2; i < corners.size(); ++i)
                    {
                        const bool isFan = kind == "trifans";
                        part.add(corners[isFan ? 0 : i - 2 + i % 2]);
                        part.add(corners[isFan ? i - 1 : i - 1 - i % 2]);
                        part.add(corners[i]);
                        part.closeTriangle();
                    }
                return sizes.size();
            }

            /** From the file's frame to meters, with the y axis up */
            Eigen::Affine3d frameOf(const Node &asset) const
            {
                const Node unit = asset.child("unit"), axis = asset.child("up_axis");
                double meters = 1.0;
                if (unit.attribute("meter") && !(parseNumber(valueOf(unit, "meter"), meters) && meters > 0.0))
                    fail(unit, "is of " + inQuotes(valueOf(unit, "meter")) + " meters");
                const std::string text = axis ? axis.text().get() : "Y_UP";
                const std::string up = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()), 4);
                Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
                if (up == "X_UP")
                    rotation << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
                else if (up == "Z_UP")
                    rotation << 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0;
                else if (up != "Y_UP")
                    fail(axis, "is " + inQuotes(text));
                Eigen::Affine3d frame = Eigen::Affine3d::Identity();
                frame.linear() =
                    mesh_.keepsAxes ? Eigen::Matrix3d(meters * Eigen::Matrix3d::Identity()) : meters * rotation;
                return frame;
            }

            Eigen::Affine3d transformOf(const Node &node) const
            {
                static const std::map<std::string_view, std::size_t> counts{
                    {"matrix", 16}, {"rotate", 4}, {"scale", 3}, {"translate", 3}, {"skew", 0}, {"lookat", 0}};
                Eigen::Affine3d transform = Eigen::Affine3d::Identity();
                for (const Node &step : node.children())
                {
                    const auto count = counts.find(step.name());
                    if (count == counts.end())
                        continue;
                    if (count->second == 0)
                        fail(step, "is not supported");
                    const auto numbers = numbersOf<double>(step);
                    if (numbers.size() != count->second)
                        fail(step, "has " + std::to_string(numbers.size()) + " numbers, not " +
                                       std::to_string(count->second));
                    const Eigen::Vector3d first(numbers.data());
                    if (count->first == "matrix")
                        transform = transform * matrixOf(step, numbers);
                    else if (count->first == "translate")
                        transform.translate(first);
                    else if (count->first == "scale")
                        transform.scale(first);
                    else if (first.norm() > 0.0)
                        transform.rotate(Eigen::AngleAxisd(numbers[3] * boost::math::constants::degree<double>(),
                                                           first.normalized()));
                }
                return transform;
            }

            /** In the order of Assimp: of the nodes below a node the last one comes first. */
            void placeNodes(const Node &scene, const Eigen::Affine3d &frame)
            {
                std::vector<OpenNode> open{{scene, frame, 0}};
                for (std::size_t count = 0; !open.empty();)
                {
                    const auto [node, parent, level] = open.back();
                    open.pop_back();
                    if (level > MOST_LEVELS)
                        fail(node, "is nested in more than " + std::to_string(MOST_LEVELS) + " levels, or in a ring");
                    const Eigen::Affine3d transform = parent * transformOf(node);
                    for (const std::string name : {"instance_geometry", "instance_controller", "node", "instance_node"})
                        for (const Node &child : node.children(name.c_str()))
                        {
                            if (++count > MOST_NODES)
                                fail(child, "is one of more than " + std::to_string(MOST_NODES));
                            if (name == "node" || name == "instance_node")
                                open.push_back({name == "node" ? child : nodeOf(child), transform, level + 1});
                            else
                            {
                                Eigen::Affine3d place = transform;
                                for (MeshPart &part : partsOf(geometryOf(child, place)))
                                    mesh_.add(part, place);
                            }
                        }
                }
            }

            /** A node of the library, or else any other, or a scene */
            Node nodeOf(const Node &instance) const
            {
                for (const char *name : {ColladaIds::LIBRARY, "visual_scene"})
                    if (const Node node = find(instance, "url", name))
                        return node;
                return require(instance, "url", "node");
            }

            /** The geometry of an instance, which may be that of a skin, or of the skin of a morph
                \param place where the instance is; for a skin set to where its geometry is */
            Node geometryOf(const Node &instance, Eigen::Affine3d &place) const
            {
                Node from = instance;
                for (const char *attribute : {"url", "source"})
                    if (const Node controller = find(from, attribute, "controller"))
                    {
                        from = controller.child("skin") ? controller.child("skin") : controller.child("morph");
                        if (const Node bind = from.child("bind_shape_matrix"))
                            place = place * matrixOf(bind, numbersOf<double>(bind));
                    }
                const Node geometry = require(from, from == instance ? "url" : "source", "geometry");
                for (const char *other : {"convex_mesh", "spline", "brep"})
                    if (geometry.child(other))
                        fail(geometry.child(other), "is not supported: only a <mesh> is");
                return geometry;
            }

            /** The transform that 16 numbers are, row by row */
            Eigen::Affine3d matrixOf(const Node &node, const std::vector<double> &numbers) const
            {
                if (numbers.size() != 16)
                    fail(node, "has " + std::to_string(numbers.size()) + " numbers, not 16");
                const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> rows(numbers.data());
                if (!rows.row(3).isApprox(Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0), 1e-6))
                    fail(node, "must end with the row 0 0 0 1");
                Eigen::Affine3d matrix = Eigen::Affine3d::Identity();
                matrix.affine() = rows.topRows<3>();
                return matrix;
            }

            std::string_view content_;
            MeshCollector &mesh_;
            pugi::xml_document document_;
            ColladaIds ids_;
            /** The mesh that is read */
            Node readMesh_;
            std::map<Node, Source> sources_;
            std::size_t corners_{0};
            std::map<Node, std::vector<MeshPart>> parts_;
        };
    }

    void readCollada(std::string_view content, MeshCollector &mesh)
    {
        ColladaReader(content, mesh).run();
    }
}
