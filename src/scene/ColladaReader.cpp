#include "MeshReaders.h"
#include "MeshText.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <limits>
#include <map>
#include <numeric>
#include <pugixml.hpp>
#include <stdexcept>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t MOST_NODES = 100000, MOST_LEVELS = 1000, MOST_CONTROLLERS = 3;

        /** The values of a <source>, and how to find those of an index */
        struct Source
        {
            std::vector<double> values;
            std::size_t count, stride, offset, size;

            Eigen::Vector3d at(std::size_t index) const
            {
                Eigen::Vector3d point = Eigen::Vector3d::Zero();
                for (std::size_t i = 0; i < size; ++i)
                    point[static_cast<Eigen::Index>(i)] = values[offset + index * stride + i];
                return point;
            }
        };

        /** A source, and which of the indices of a corner is of it */
        struct Input
        {
            const Source *source{nullptr};
            std::size_t offset{0};
        };

        struct Inputs
        {
            Input position, normal, texture;
            /** The lowest set of textures counts. */
            std::size_t textureSet{std::numeric_limits<std::size_t>::max()};
            /** The number of indices of each corner */
            std::size_t stride{1};
        };

        using Elements = std::multimap<std::pair<std::string_view, std::string_view>, pugi::xml_node>;

        /** Finds all elements that have some attribute, by their name and its value. */
        class AttributeWalker : public pugi::xml_tree_walker
        {
        public:
            AttributeWalker(const char *attribute, Elements &elements) : attribute_(attribute), elements_(elements)
            {
            }

            bool for_each(pugi::xml_node &node) override
            {
                if (const pugi::xml_attribute attribute = node.attribute(attribute_))
                    elements_.emplace(std::make_pair(node.name(), attribute.value()), node);
                return true;
            }

        private:
            const char *attribute_;
            Elements &elements_;
        };

        class ColladaReader
        {
        public:
            ColladaReader(std::string_view content, MeshCollector &mesh) : content_(content), mesh_(mesh)
            {
            }

            void run()
            {
                if (const auto result = document_.load_buffer(content_.data(), content_.size()); !result)
                    fail(result.offset, std::string("it is not XML: ") + result.description());
                const pugi::xml_node root = document_.child("COLLADA");
                if (!root)
                    throw std::runtime_error("it has no element <COLLADA>");
                AttributeWalker ids("id", ids_), names("name", names_);
                document_.traverse(ids);
                document_.traverse(names);
                for (const pugi::xml_node &library : root.children("library_geometries"))
                    for (const pugi::xml_node &geometry : library.children("geometry"))
                        partsOf(geometry);
                const Eigen::Affine3d frame = frameOf(root.child("asset"));
                if (const pugi::xml_node scene = sceneOf(root))
                    return placeNodes(scene, frame);
                for (auto &[geometry, parts] : parts_)
                    for (MeshPart &part : parts)
                        mesh_.add(part, frame);
            }

        private:
            [[noreturn]] void fail(std::ptrdiff_t offset, const std::string &complaint) const
            {
                const auto end = std::min<std::size_t>(static_cast<std::size_t>(offset), content_.size());
                const auto ends = std::count(content_.begin(), content_.begin() + static_cast<std::ptrdiff_t>(end), '\n');
                throw std::runtime_error("line " + std::to_string(ends + 1) + ": " + complaint);
            }

            [[noreturn]] void fail(const pugi::xml_node &element, const std::string &complaint) const
            {
                fail(element.offset_debug(), std::string("<") + element.name() + "> " + complaint);
            }

            /** The element of some name that an attribute refers to, if it is there */
            pugi::xml_node find(const pugi::xml_node &from, const char *attribute, std::string_view name) const
            {
                const std::string_view url = from.attribute(attribute).value();
                if (url.substr(0, 1) != "#")
                    return {};
                const auto [first, last] = ids_.equal_range({name, url.substr(1)});
                if (first != last && std::next(first) != last)
                    fail(from, "is of " + inQuotes(url) + ", and there are two <" + std::string(name) + "> of this id");
                return first != last ? first->second : pugi::xml_node();
            }

            pugi::xml_node require(const pugi::xml_node &from, const char *attribute, std::string_view name) const
            {
                const pugi::xml_node found = find(from, attribute, name);
                if (!found)
                    fail(from, "is of " + inQuotes(from.attribute(attribute).value()) + ", a <" + std::string(name) +
                                   "> that is not there");
                return found;
            }

            std::size_t toWhole(const pugi::xml_node &element, std::string_view word, const std::string &what) const
            {
                long long number;
                // Whatever is counted takes a byte.
                if (!parseWhole(word, number) || number < 0 || static_cast<std::size_t>(number) > content_.size())
                    fail(element, "has the " + what + " " + inQuotes(word) + ", not a whole number that makes sense");
                return static_cast<std::size_t>(number);
            }

            std::size_t wholeAttribute(const pugi::xml_node &element, const char *name, std::size_t otherwise) const
            {
                const pugi::xml_attribute attribute = element.attribute(name);
                return attribute ? toWhole(element, attribute.value(), name) : otherwise;
            }

            template <typename Visit>
            static void forEachWord(const pugi::xml_node &element, const Visit &visit)
            {
                for (const pugi::xml_node &child : element.children())
                    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
                        for (MeshText text(child.value()); text.nextLine();)
                            for (std::string_view word = text.next(); !word.empty(); word = text.next())
                                visit(word);
            }

            std::vector<double> numbersOf(const pugi::xml_node &element) const
            {
                std::vector<double> numbers;
                forEachWord(element,
                            [&](std::string_view word)
                            {
                                if (!parseNumber(word, numbers.emplace_back()))
                                    fail(element, "has " + inQuotes(word) + ", which is not a number");
                            });
                return numbers;
            }

            std::vector<std::size_t> wholesOf(const pugi::xml_node &element) const
            {
                std::vector<std::size_t> numbers;
                forEachWord(element,
                            [&](std::string_view word) { numbers.push_back(toWhole(element, word, "number")); });
                return numbers;
            }

            const Source &sourceOf(const pugi::xml_node &input)
            {
                const pugi::xml_node element = require(input, "source", "source");
                const auto [entry, isNew] = sources_.try_emplace(element);
                Source &source = entry->second;
                if (!isNew)
                    return source;
                const pugi::xml_node accessor = element.child("technique_common").child("accessor");
                const pugi::xml_node array = require(accessor ? accessor : element, "source", "float_array");
                source.values = numbersOf(array);
                if (const std::size_t count = wholeAttribute(array, "count", 0); count != source.values.size())
                    fail(array, "has " + std::to_string(source.values.size()) + " numbers, not " +
                                    std::to_string(count));
                source.count = wholeAttribute(accessor, "count", 0);
                source.stride = wholeAttribute(accessor, "stride", 1);
                source.offset = wholeAttribute(accessor, "offset", 0);
                std::size_t parameters = 0;
                std::string names;
                for (const pugi::xml_node &parameter : accessor.children("param"))
                {
                    ++parameters;
                    names.append(parameter.attribute("name").value()).append(" ");
                    if (std::string_view(parameter.attribute("type").value()) == "float4x4")
                        fail(accessor, "is of matrices");
                }
                source.size = std::min<std::size_t>(parameters, 3);
                if (source.count > 0 && source.offset + (source.count - 1) * source.stride +
                                                std::max<std::size_t>(parameters, 1) > source.values.size())
                    fail(accessor, "goes beyond the values of its <float_array>");
                if (std::string_view(input.attribute("semantic").value()) == "POSITION" && names.rfind("X Y Z ", 0) != 0)
                    fail(accessor, "is of positions without X, Y and Z");
                return source;
            }

            void addInput(const pugi::xml_node &input, std::size_t offset, Inputs &inputs)
            {
                const std::string_view semantic = input.attribute("semantic").value();
                if (semantic == "POSITION" && inputs.position.source)
                    fail(input, "is a second POSITION");
                if (semantic == "POSITION")
                    inputs.position = {&sourceOf(input), offset};
                if (semantic == "NORMAL" && !inputs.normal.source)
                    inputs.normal = {&sourceOf(input), offset};
                if (const std::size_t set = wholeAttribute(input, "set", 0);
                    semantic == "TEXCOORD" && set < inputs.textureSet)
                {
                    inputs.texture = {&sourceOf(input), offset};
                    inputs.textureSet = set;
                }
            }

            Inputs inputsOf(const pugi::xml_node &primitive)
            {
                Inputs inputs;
                std::size_t vertices = 0;
                for (const pugi::xml_node &input : primitive.children("input"))
                {
                    const std::size_t offset = wholeAttribute(input, "offset", 0);
                    inputs.stride = std::max(inputs.stride, offset + 1);
                    if (std::string_view(input.attribute("semantic").value()) != "VERTEX")
                    {
                        addInput(input, offset, inputs);
                        continue;
                    }
                    ++vertices;
                    for (const pugi::xml_node &shared : require(input, "source", "vertices").children("input"))
                        addInput(shared, offset, inputs);
                }
                if (vertices != 1 || !inputs.position.source)
                    fail(primitive, "has not one input VERTEX with an input POSITION");
                return inputs;
            }

            std::vector<MeshPart::Vertex> cornersOf(const pugi::xml_node &list, const Inputs &inputs) const
            {
                const std::vector<std::size_t> indices = wholesOf(list);
                if (indices.size() % inputs.stride != 0)
                    fail(list, "has " + std::to_string(indices.size()) + " numbers, but each corner has " +
                                   std::to_string(inputs.stride));
                std::vector<MeshPart::Vertex> corners(indices.size() / inputs.stride);
                for (std::size_t i = 0; i < corners.size(); ++i)
                {
                    const auto at = [&](const Input &input) -> Eigen::Vector3d
                    {
                        if (!input.source)
                            return Eigen::Vector3d::Zero();
                        const std::size_t index = indices[i * inputs.stride + input.offset];
                        if (index >= input.source->count)
                            fail(list, "has the index " + std::to_string(index) + " of one of " +
                                           std::to_string(input.source->count));
                        return input.source->at(index);
                    };
                    corners[i] = {at(inputs.position), at(inputs.normal).cast<float>(), at(inputs.texture).cast<float>()};
                    if (!(corners[i].point.cwiseAbs().maxCoeff() <= MOST_COORDINATE))
                        fail(list, "has a vertex whose coordinates are not finite numbers of at most 1e9");
                }
                return corners;
            }

            std::vector<MeshPart> &partsOf(const pugi::xml_node &geometry)
            {
                const auto [entry, isNew] = parts_.try_emplace(geometry);
                const pugi::xml_node mesh = geometry.child("mesh");
                if (isNew && (mesh.next_sibling("mesh") || mesh.child("vertices").next_sibling("vertices")))
                    fail(geometry, "has several <mesh> or <vertices>");
                if (isNew)
                    for (const pugi::xml_node &primitive : mesh.children())
                        for (const char *name : {"triangles", "polylist", "polygons", "tristrips", "trifans", "lines", "linestrips"})
                            if (std::string_view(primitive.name()) == name)
                                readPrimitive(primitive, entry->second);
                return entry->second;
            }

            void readPrimitive(const pugi::xml_node &primitive, std::vector<MeshPart> &parts)
            {
                const std::string_view kind = primitive.name();
                const Inputs inputs = primitive.child("p") ? inputsOf(primitive) : Inputs();
                MeshPart part;
                part.hasNormals = inputs.normal.source != nullptr;
                std::size_t faces = 0;
                for (const pugi::xml_node &list : primitive.children("p"))
                    faces += addFaces(primitive, cornersOf(list, inputs), part);
                // Of strips and lines some programs state another count.
                if (const std::size_t count = wholeAttribute(primitive, "count", 0);
                    count != faces && (kind == "triangles" || kind == "polylist" || kind == "polygons"))
                    fail(primitive, "has " + std::to_string(faces) + " faces, not " + std::to_string(count));
                if (part.size() > 0)
                    parts.push_back(std::move(part));
            }

            /** Add the faces of one <p>. \return their number */
            std::size_t addFaces(const pugi::xml_node &primitive, const std::vector<MeshPart::Vertex> &corners,
                                 MeshPart &part)
            {
                const std::string_view kind = primitive.name();
                const auto addFace = [&](const std::vector<std::size_t> &numbers)
                {
                    std::vector<std::uint32_t> face;
                    for (const std::size_t number : numbers)
                        face.push_back(part.addVertex(corners[number]));
                    part.addPolygon(face, mesh_.work);
                };
                if (kind == "lines" || kind == "linestrips")
                    for (const MeshPart::Vertex &corner : corners)
                        part.use(part.addVertex(corner), MeshPart::LINE);
                for (std::size_t i = 2; kind == "trifans" && i < corners.size(); ++i)
                    addFace({0, i - 1, i});
                for (std::size_t i = 2; kind == "tristrips" && i < corners.size(); ++i)
                    addFace({i - 2 + i % 2, i - 1 - i % 2, i});
                std::vector<std::size_t> sizes;
                if (kind == "triangles")
                    sizes.assign(corners.size() / 3, 3);
                if (kind == "polylist")
                    sizes = wholesOf(primitive.child("vcount"));
                if (kind == "polygons")
                    sizes.assign(1, corners.size());
                std::size_t end = 0;
                for (const std::size_t size : sizes)
                {
                    std::vector<std::size_t> numbers(std::min(size, corners.size() - end));
                    std::iota(numbers.begin(), numbers.end(), end);
                    addFace(numbers);
                    if ((end += size) > corners.size())
                        break;
                }
                if (!sizes.empty() && end != corners.size())
                    fail(primitive, "has " + std::to_string(corners.size()) + " corners, other than its faces need");
                return sizes.size();
            }

            /** The scene that the file names, or else its first one, if it has any */
            pugi::xml_node sceneOf(const pugi::xml_node &root) const
            {
                if (const pugi::xml_node instance = root.child("scene").child("instance_visual_scene"))
                    return require(instance, "url", "visual_scene");
                return root.child("library_visual_scenes").child("visual_scene");
            }

            /** From the file's frame to meters, with the y axis up */
            Eigen::Affine3d frameOf(const pugi::xml_node &asset) const
            {
                Eigen::Affine3d frame = Eigen::Affine3d::Identity();
                const pugi::xml_node unit = asset.child("unit"), axis = asset.child("up_axis");
                if (const pugi::xml_attribute meter = unit.attribute("meter"))
                {
                    double scale;
                    if (!parseNumber(meter.value(), scale) || !(scale > 0.0))
                        fail(unit, "is of " + inQuotes(meter.value()) + " meters");
                    frame.scale(scale);
                }
                std::string up = "Y_UP";
                forEachWord(axis, [&up](std::string_view word) { up = word; });
                const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                                      z = Eigen::Vector3d::UnitZ();
                Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
                if (up == "X_UP")
                    rotation << y, -x, z;
                else if (up == "Z_UP")
                    rotation << x, -z, y;
                else if (up != "Y_UP")
                    fail(axis, "is " + inQuotes(up));
                return Eigen::Affine3d(frame.matrix() * Eigen::Affine3d(rotation).matrix());
            }

            Eigen::Affine3d transformOf(const pugi::xml_node &node) const
            {
                Eigen::Affine3d transform = Eigen::Affine3d::Identity();
                for (const pugi::xml_node &step : node.children())
                {
                    const std::string_view name = step.name();
                    if (name == "skew" || name == "lookat")
                        fail(step, "is not supported");
                    const std::size_t count = name == "matrix" ? 16
                                              : name == "rotate" ? 4
                                              : name == "translate" || name == "scale" ? 3
                                              : 0;
                    if (count == 0)
                        continue;
                    const std::vector<double> numbers = numbersOf(step);
                    if (numbers.size() != count)
                        fail(step, "has " + std::to_string(numbers.size()) + " numbers, not " + std::to_string(count));
                    const Eigen::Vector3d first(numbers.data());
                    if (name == "matrix")
                        transform = transform * Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(numbers.data());
                    else if (name == "translate")
                        transform.translate(first);
                    else if (name == "scale")
                        transform.scale(first);
                    else if (!first.isZero(0.0))
                        transform.rotate(Eigen::AngleAxisd(numbers[3] * boost::math::constants::degree<double>(),
                                                           first.normalized()));
                }
                return transform;
            }

            struct Place
            {
                pugi::xml_node node;
                Eigen::Affine3d frame;
                std::size_t level;
            };

            /** The order is Assimp's: of the nodes below a node the last one comes first. */
            void placeNodes(const pugi::xml_node &scene, const Eigen::Affine3d &frame)
            {
                std::vector<Place> open{{scene, frame, 0}};
                std::size_t count = 0;
                const auto countOne = [&](const pugi::xml_node &node)
                {
                    if (++count > MOST_NODES)
                        fail(node, "makes more than " + std::to_string(MOST_NODES) + " nodes and geometries");
                };
                while (!open.empty())
                {
                    const auto [node, parent, level] = open.back();
                    open.pop_back();
                    if (level > MOST_LEVELS)
                        fail(node, "is nested in more than " + std::to_string(MOST_LEVELS) +
                                       " levels, or an instance of itself");
                    const Eigen::Affine3d transform = parent * transformOf(node);
                    for (const char *name : {"instance_geometry", "instance_controller"})
                        for (const pugi::xml_node &instance : node.children(name))
                        {
                            countOne(instance);
                            for (MeshPart &part : partsOf(geometryOf(instance)))
                                mesh_.add(part, transform);
                        }
                    for (const char *name : {"node", "instance_node"})
                        for (const pugi::xml_node &child : node.children(name))
                        {
                            countOne(child);
                            open.push_back({name[0] == 'n' ? child : nodeOf(child), transform, level + 1});
                        }
                }
            }

            /** A node may be named by its id or, in some files, by its name. */
            pugi::xml_node nodeOf(const pugi::xml_node &instance) const
            {
                for (const char *name : {"node", "visual_scene"})
                    if (const pugi::xml_node node = find(instance, "url", name))
                        return node;
                const std::string_view url = instance.attribute("url").value();
                const auto named = names_.find({"node", url.substr(url.empty() ? 0 : 1)});
                return named != names_.end() ? named->second : require(instance, "url", "node");
            }

            /** The geometry of an instance, or what its skin or morph is made of */
            pugi::xml_node geometryOf(const pugi::xml_node &instance) const
            {
                pugi::xml_node from = instance;
                const char *attribute = "url";
                for (std::size_t i = 0; i < MOST_CONTROLLERS; ++i)
                {
                    if (const pugi::xml_node geometry = find(from, attribute, "geometry"))
                        return geometry;
                    const pugi::xml_node controller = find(from, attribute, "controller");
                    if (!controller)
                        break;
                    from = controller.child("skin") ? controller.child("skin") : controller.child("morph");
                    attribute = "source";
                }
                return require(from, attribute, "geometry");
            }

            std::string_view content_;
            MeshCollector &mesh_;
            pugi::xml_document document_;
            /** The elements by their name and id, or their name and name */
            Elements ids_, names_;
            std::map<pugi::xml_node, Source> sources_;
            std::map<pugi::xml_node, std::vector<MeshPart>> parts_;
        };
    }

    void readCollada(std::string_view content, MeshCollector &mesh)
    {
        ColladaReader(content, mesh).run();
    }
}
