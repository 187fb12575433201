#include "ColladaCheck.h"

#include "MeshWords.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t MOST_NODES = 100000, MOST_SEARCHES = 1000, MOST_INPUTS = 16, MOST_COORDINATES = 100000000;
        constexpr std::string_view SEMANTICS[] = {"VERTEX",     "POSITION", "NORMAL",      "COLOR",   "TEXCOORD",
                                                  "TEXTANGENT", "TANGENT",  "TEXBINORMAL", "BINORMAL"};

        [[noreturn]] void fail(const std::string &complaint)
        {
            throw std::runtime_error(complaint);
        }

        std::string_view attributeOf(const pugi::xml_node &node, const char *name)
        {
            return node.attribute(name).value();
        }

        std::vector<std::size_t> numbersOf(const pugi::xml_node &node, std::size_t bytes)
        {
            const std::string what = std::string("a number of <") + node.name() + ">";
            std::vector<std::size_t> numbers;
            MeshWords words(node.text().get());
            for (std::string_view word = words.next(); !word.empty(); word = words.next())
                numbers.push_back(wholeNumber(word, bytes, what));
            return numbers;
        }

        /** Whether all that the primitives of meshes refer to is there. Assimp looks no further than at the indices. */
        class GeometryCheck
        {
        public:
            explicit GeometryCheck(std::size_t bytes) : bytes_(bytes)
            {
            }

            void run(const pugi::xml_node &root)
            {
                forEachMesh(root, &GeometryCheck::collect);
                forEachMesh(root, &GeometryCheck::check);
            }

        private:
            void forEachMesh(const pugi::xml_node &root, void (GeometryCheck::*visit)(const pugi::xml_node &))
            {
                for (const pugi::xml_node &library : root.children("library_geometries"))
                    for (const pugi::xml_node &geometry : library.children())
                        if (const pugi::xml_node mesh = geometry.child("mesh"))
                            (this->*visit)(mesh);
            }

            std::size_t number(const pugi::xml_node &node, const char *name, std::size_t otherwise) const
            {
                const pugi::xml_attribute attribute = node.attribute(name);
                return attribute ? wholeNumber(attribute.value(), bytes_,
                                               std::string("the ") + name + " of <" + node.name() + ">")
                                 : otherwise;
            }

            void collect(const pugi::xml_node &mesh)
            {
                for (const pugi::xml_node &source : mesh.children("source"))
                {
                    if (!sources_.insert(attributeOf(source, "id")).second)
                        fail("two <source>s have the id '" + std::string(attributeOf(source, "id")) + "'");
                    std::string names;
                    for (const pugi::xml_node &parameter :
                         source.child("technique_common").child("accessor").children())
                        names.append(parameter.attribute("name").value()).append(" ");
                    if (names == "X Y Z ")
                        points_.insert(attributeOf(source, "id"));
                    for (const pugi::xml_node &array : source.children("float_array"))
                        if (!sizes_.emplace(attributeOf(array, "id"), number(array, "count", 0)).second)
                            fail("two <float_array>s have the id '" + std::string(attributeOf(array, "id")) + "'");
                }
            }

            void check(const pugi::xml_node &mesh)
            {
                for (const pugi::xml_node &source : mesh.children("source"))
                    for (const pugi::xml_node &technique : source.children("technique_common"))
                        for (const pugi::xml_node &accessor : technique.children())
                            checkAccessor(accessor);
                const pugi::xml_node vertices = mesh.child("vertices");
                if (mesh.next_sibling("mesh") || vertices.next_sibling("vertices"))
                    fail("a <geometry> has several <mesh> or <vertices>");
                for (const pugi::xml_node &primitive : mesh.children())
                    if (const std::string_view name = primitive.name(); name != "source" && name != "vertices")
                    {
                        if (countInputs(vertices, "POSITION") != 1)
                            fail("the <vertices> of a <mesh> have not one input POSITION");
                        std::string_view position =
                            attributeOf(vertices.find_child_by_attribute("input", "semantic", "POSITION"), "source");
                        position.remove_prefix(position.empty() ? 0 : 1);
                        if (points_.count(position) == 0)
                            fail("the POSITION of a <mesh> is of something without X, Y and Z");
                        checkPrimitive(primitive, vertices);
                    }
            }

            void checkAccessor(const pugi::xml_node &accessor) const
            {
                std::string_view source = attributeOf(accessor, "source");
                source.remove_prefix(source.empty() ? 0 : 1);
                const std::size_t count = number(accessor, "count", 0), stride = number(accessor, "stride", 1),
                                  offset = number(accessor, "offset", 0);
                std::size_t parameters = 0;
                for (const pugi::xml_node &parameter : accessor.children())
                {
                    ++parameters;
                    if (attributeOf(parameter, "type") == "float4x4")
                        fail("an <accessor> of a mesh is of matrices");
                }
                if (parameters > 4)
                    fail("an <accessor> of a mesh has more than 4 parameters");
                const auto array = sizes_.find(source);
                if (count > 0 && array == sizes_.end())
                    fail("an <accessor> is of '" + std::string(source.substr(0, 30)) + "', which is no <float_array>");
                if (count > 0 && offset + (count - 1) * stride + std::max<std::size_t>(parameters, 1) > array->second)
                    fail("an <accessor> goes beyond the values of its <float_array>");
            }

            void checkPrimitive(const pugi::xml_node &primitive, const pugi::xml_node &vertices)
            {
                std::size_t inputs = 0, stride = 1;
                for (const pugi::xml_node &of : {vertices, primitive})
                    for (const pugi::xml_node &input : of.children("input"))
                    {
                        ++inputs;
                        number(input, "set", 0);
                        if (const std::string_view semantic = attributeOf(input, "semantic");
                            std::find(std::begin(SEMANTICS), std::end(SEMANTICS), semantic) == std::end(SEMANTICS))
                            fail("an <input> is a '" + std::string(attributeOf(input, "semantic").substr(0, 20)) +
                                 "', which is not supported");
                        stride = std::max(stride, number(input, "offset", 0) + 1);
                    }
                const std::string element = std::string("<") + primitive.name() + ">";
                if (inputs > MOST_INPUTS || stride > MOST_INPUTS)
                    fail("a " + element + " has more than " + std::to_string(MOST_INPUTS) + " inputs");
                if (countInputs(primitive, "VERTEX") != 1 || countInputs(primitive, "POSITION") != 0)
                    fail("a " + element + " has not one input VERTEX, or one POSITION");
                coordinates_ += 3 * inputs * (countIndices(primitive, stride) / stride);
                if (coordinates_ > MOST_COORDINATES)
                    fail("it has more than " + std::to_string(MOST_COORDINATES) + " coordinates");
            }

            /** The number of indices in all <p>, which has to be what the other elements and attributes say */
            std::size_t countIndices(const pugi::xml_node &primitive, std::size_t stride) const
            {
                const std::string_view kind = primitive.name();
                const std::size_t count = number(primitive, "count", 0);
                std::size_t lists = 0, indices = 0;
                for (const pugi::xml_node &list : primitive.children("p"))
                {
                    ++lists;
                    indices += numbersOf(list, bytes_).size();
                }
                const auto require = [&](bool condition)
                {
                    if (!condition)
                        fail("a <" + std::string(kind) + "> of " + std::to_string(count) + " has " +
                             std::to_string(indices) + " numbers in " + std::to_string(lists) + " <p>");
                };
                require(count > 0 || indices == 0);
                require(2 * count * stride <= bytes_);
                if (kind == "triangles" || kind == "polylist")
                {
                    require(lists <= 1);
                    require(indices == stride * (kind == "triangles" ? 3 * count : cornersOf(primitive, count)));
                }
                if (kind == "polygons")
                    require(lists == count);
                return indices;
            }

            static std::size_t countInputs(const pugi::xml_node &node, std::string_view semantic)
            {
                std::size_t count = 0;
                for (const pugi::xml_node &input : node.children("input"))
                    count += attributeOf(input, "semantic") == semantic ? 1 : 0;
                return count;
            }

            std::size_t cornersOf(const pugi::xml_node &polylist, std::size_t count) const
            {
                const pugi::xml_node vcount = polylist.child("vcount");
                if (count > 0 && (!vcount || vcount.next_sibling("vcount")))
                    fail("a <polylist> has not one <vcount>");
                const std::vector<std::size_t> sizes = numbersOf(vcount, bytes_);
                if (sizes.size() != count)
                    fail("the <vcount> of a <polylist> has other than " + std::to_string(count) + " numbers");
                std::size_t corners = 0;
                for (const std::size_t size : sizes)
                    if ((corners += size) > bytes_)
                        fail("in <vcount> there are more corners than bytes");
                return corners;
            }

            std::size_t bytes_;
            std::set<std::string_view> sources_;
            /** The sources that have X, Y and Z */
            std::set<std::string_view> points_;
            /** The number of values of each <float_array> */
            std::map<std::string_view, std::size_t> sizes_;
            /** What Assimp makes of the indices: all attributes of each corner */
            std::size_t coordinates_{0};
        };

        /** How large a scene becomes once its <instance_node>s are replaced by the nodes that they name, which Assimp does by
            calling itself, however deep and often that is, and in a ring. */
        class Expansion
        {
        public:
            void run(const pugi::xml_node &root)
            {
                for (const pugi::xml_node &library : root.children())
                    for (const pugi::xml_node &child : library.children())
                    {
                        const std::string_view name = child.name();
                        if (name == "node" || name == "visual_scene")
                            library_.emplace(attributeOf(child, "id"), child);
                        if (name == "visual_scene")
                            addNames(child);
                        if (name == "geometry")
                        {
                            const auto parts = child.child("mesh").children();
                            const auto count = static_cast<std::size_t>(std::distance(parts.begin(), parts.end()));
                            if (!geometries_.emplace(attributeOf(child, "id"), count + 1).second)
                                fail("two <geometry> have the id '" + std::string(attributeOf(child, "id")) + "'");
                        }
                    }
                for (const pugi::xml_node &library : root.children("library_visual_scenes"))
                    for (const pugi::xml_node &scene : library.children())
                        measure(scene, 0);
            }

        private:
            struct Size
            {
                std::size_t nodes{0}, depth{0};
                bool isOpen{true};
            };

            void addNames(const pugi::xml_node &node)
            {
                for (const char *const key : {"id", "name"})
                    if (const pugi::xml_attribute attribute = node.attribute(key))
                        named_.emplace(attribute.value(), node);
                for (const pugi::xml_node &child : node.children("node"))
                    addNames(child);
            }

            /** The id of what an instance is of. What Assimp does not find it leaves out. */
            template <typename Map>
            static std::string_view idOf(const pugi::xml_node &instance, const Map &first, const Map &second)
            {
                const std::string_view url = attributeOf(instance, "url"), id = url.substr(url.empty() ? 0 : 1);
                if (url.substr(0, 1) != "#" || first.count(id) + second.count(id) == 0)
                    fail("it has an <" + std::string(instance.name()) + "> of '" + std::string(url.substr(0, 30)) +
                         "', which is not there");
                return id;
            }

            Size measure(const pugi::xml_node &node, std::size_t above)
            {
                const auto [known, isNew] = sizes_.try_emplace(node);
                if (!isNew && known->second.isOpen)
                    fail("its nodes are instances of each other in a ring");
                if (!isNew)
                    return known->second;
                Size size;
                const auto take = [&](const Size &part)
                {
                    size.nodes += part.nodes;
                    size.depth = std::max(size.depth, part.depth);
                    if (above + size.depth >= MOST_COLLADA_LEVELS)
                        fail("its nodes are nested in more than " + std::to_string(MOST_COLLADA_LEVELS) + " levels");
                    if (size.nodes >= MOST_NODES)
                        fail("it has more than " + std::to_string(MOST_NODES) + " nodes and parts");
                };
                take({1, 0, false});
                for (const pugi::xml_node &child : node.children("node"))
                    take(measure(child, above + 1));
                for (const pugi::xml_node &instance : node.children("instance_geometry"))
                    take({geometries_.at(idOf(instance, geometries_, {})), 0, false});
                for (const pugi::xml_node &instance : node.children("instance_node"))
                {
                    // Assimp looks in the library first, and then, all over the scene, for the first node that has this
                    // name or id.
                    const std::string_view id = idOf(instance, library_, named_);
                    const bool isInLibrary = library_.count(id) > 0;
                    if (!isInLibrary && ++searches_ > MOST_SEARCHES)
                        fail("it has more than " + std::to_string(MOST_SEARCHES) +
                             " instances outside of its libraries");
                    const auto [first, last] = (isInLibrary ? library_ : named_).equal_range(id);
                    for (auto target = first; target != last; ++target)
                        take(measure(target->second, above + 1));
                }
                ++size.depth;
                size.isOpen = false;
                return sizes_[node] = size;
            }

            std::multimap<std::string_view, pugi::xml_node> library_, named_;
            /** The parts of each */
            std::map<std::string_view, std::size_t> geometries_;
            std::map<pugi::xml_node, Size> sizes_;
            std::size_t searches_{0};
        };
    }

    void checkCollada(const pugi::xml_node &root, std::size_t bytes)
    {
        GeometryCheck(bytes).run(root);
        Expansion().run(root);
    }
}
