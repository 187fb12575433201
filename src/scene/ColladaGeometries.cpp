#include "ColladaGeometries.h"

#include <algorithm>

namespace ompl_certificates
{
    namespace
    {
        using NameList = std::vector<std::string_view>;

        const NameList COUNTED{"triangles", "polylist", "polygons"},
            UNCOUNTED{"tristrips", "trifans", "lines", "linestrips"};
        constexpr const char *SEMANTICS[] = {"POSITION", "NORMAL", "TEXCOORD"};

        bool isOneOf(const NameList &names, std::string_view name)
        {
            return std::find(names.begin(), names.end(), name) != names.end();
        }
    }

    std::vector<MeshPart> &ColladaGeometries::partsOf(const Node &geometry)
    {
        const auto [entry, isNew] = parts_.try_emplace(geometry);
        const Node mesh = geometry.child("mesh");
        document_.setMesh(mesh);
        if (mesh.next_sibling("mesh") || mesh.child("vertices").next_sibling("vertices"))
            document_.fail(geometry, "has several <mesh> or <vertices>");
        for (const Node &primitive : mesh.children())
            if (isNew && (isOneOf(COUNTED, primitive.name()) || isOneOf(UNCOUNTED, primitive.name())))
                readPrimitive(primitive, entry->second);
        return entry->second;
    }

    void ColladaGeometries::readPrimitive(const Node &primitive, std::vector<MeshPart> &parts)
    {
        Inputs inputs;
        const std::size_t stride = primitive.child("p") ? readInputs(primitive, inputs) : 1;
        MeshPart part;
        part.hasNormals = inputs[1].source != nullptr;
        std::size_t faces = 0;
        for (const Node &list : primitive.children("p"))
            faces += addFaces(primitive, cornersOf(list, inputs, stride), part);
        // Of strips and lines some programs state another count.
        if (const std::size_t count = document_.wholeAttribute(primitive, "count", 0);
            count != faces && isOneOf(COUNTED, primitive.name()))
            document_.fail(primitive, "has " + std::to_string(faces) + " faces, not " + std::to_string(count));
        if (!part.vertices.empty())
            parts.push_back(std::move(part));
    }

    std::size_t ColladaGeometries::readInputs(const Node &primitive, Inputs &inputs)
    {
        std::size_t stride = 1, vertices = 0;
        for (const Node &input : primitive.children("input"))
        {
            const std::size_t offset = document_.wholeAttribute(input, "offset", 0);
            stride = std::max(stride, offset + 1);
            addInput(input, offset, inputs);
            if (ColladaDocument::valueOf(input, "semantic") != "VERTEX")
                continue;
            ++vertices;
            for (const Node &shared : document_.require(input, "source", "vertices").children("input"))
                addInput(shared, offset, inputs);
        }
        if (vertices != 1 || !inputs[0].source)
            document_.fail(primitive, "has not one input VERTEX of an input POSITION");
        return stride;
    }

    void ColladaGeometries::addInput(const Node &input, std::size_t offset, Inputs &inputs)
    {
        const std::size_t set = document_.wholeAttribute(input, "set", 0);
        for (std::size_t i = 0; i < inputs.size(); ++i)
            if (ColladaDocument::valueOf(input, "semantic") == SEMANTICS[i])
            {
                if (i == 0 && inputs[0].source)
                    document_.fail(input, "is a second POSITION");
                if (!inputs[i].source || set < inputs[i].set)
                    inputs[i] = {&sourceOf(input, i == 0), offset, set};
            }
    }

    const ColladaGeometries::Source &ColladaGeometries::sourceOf(const Node &input, bool isOfPoints)
    {
        const Node element = document_.require(input, "source", "source"),
                   accessor = element.child("technique_common").child("accessor");
        std::string names;
        std::size_t parameters = 0;
        for (const Node &parameter : accessor.children("param"))
        {
            names.append(ColladaDocument::valueOf(parameter, "name")).append(" ");
            ++parameters;
            if (ColladaDocument::valueOf(parameter, "type") == "float4x4")
                document_.fail(accessor, "is of matrices");
        }
        if (isOfPoints && names.substr(0, 6) != "X Y Z ")
            document_.fail(element, "is of positions without X, Y and Z");
        const auto [entry, isNew] = sources_.try_emplace(element);
        Source &source = entry->second;
        if (!isNew)
            return source;
        const Node array = document_.require(accessor ? accessor : element, "source", "float_array");
        source = {document_.numbersOf<double>(array), document_.wholeAttribute(accessor, "count", 0),
                  document_.wholeAttribute(accessor, "stride", 1), document_.wholeAttribute(accessor, "offset", 0),
                  std::min<std::size_t>(parameters, 3)};
        if (document_.wholeAttribute(array, "count", 0) != source.values.size())
            document_.fail(array, "has " + std::to_string(source.values.size()) + " numbers, not its count");
        const std::size_t last = source.offset + (source.count - 1) * source.stride + parameters;
        if (source.count > 0 && last > source.values.size())
            document_.fail(accessor, "goes beyond the values of its <float_array>");
        return source;
    }

    std::vector<MeshPart::Vertex> ColladaGeometries::cornersOf(const Node &list, const Inputs &inputs,
                                                               std::size_t stride)
    {
        const auto indices = document_.numbersOf<std::uint32_t>(list);
        if ((corners_ += indices.size() / stride) > MOST_CORNERS)
            document_.fail(list, "is of more than " + std::to_string(MOST_CORNERS) + " corners");
        if (indices.size() % stride != 0)
            document_.fail(list, "has " + std::to_string(indices.size()) + " numbers, for corners of " +
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
                        document_.fail(list, "has the index " + std::to_string(index) + " of one of " +
                                                 std::to_string(source->count) + " in " + SEMANTICS[k]);
                    std::copy_n(source->values.data() + source->offset + index * source->stride, source->size,
                                columns.col(static_cast<Eigen::Index>(k)).data());
                }
            if (!isPoint(columns.col(0)))
                document_.fail(list, NO_POINT);
            corners.push_back({columns.col(0), columns.col(1).cast<float>(), columns.col(2).cast<float>()});
        }
        return corners;
    }

    std::size_t ColladaGeometries::addFaces(const Node &primitive, const std::vector<MeshPart::Vertex> &corners,
                                            MeshPart &part)
    {
        const std::string_view kind = primitive.name();
        std::vector<std::uint32_t> face, sizes;
        std::size_t end = 0;
        if (kind == "polylist")
            sizes = document_.numbersOf<std::uint32_t>(primitive.child("vcount"));
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
                document_.fail(primitive, "has fewer corners than its faces need");
            part.addPolygon(face, work_);
        }
        if (isOneOf(COUNTED, kind) && end != corners.size())
            document_.fail(primitive, "has more corners than its faces need");
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
}
