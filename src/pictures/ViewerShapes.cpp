#include "ViewerShapes.h"

#include "PackedArray.h"
#include "QuantizedMesh.h"

#include <algorithm>
#include <charconv>

namespace ompl_certificates
{
    using nlohmann::json;

    namespace
    {
        /** A mesh of more triangles is shown more coarsely. */
        constexpr std::size_t MAX_TRIANGLES = 80000;

        json meshJson(const QuantizedMesh &mesh)
        {
            json result{{"kind", "mesh"}, {"vertices", packed(mesh.vertices)}};
            for (int axis = 0; axis < 3; ++axis)
            {
                result["low"].push_back(mesh.low[axis]);
                result["step"].push_back(mesh.step[axis]);
            }
            // Two bytes for an index where that is enough
            const bool small = mesh.vertices.size() / 3 <= 65536;
            result["indexBytes"] = small ? 2 : 4;
            result["triangles"] = small
                                      ? packed(std::vector<std::uint16_t>(mesh.triangles.begin(), mesh.triangles.end()))
                                      : packed(mesh.triangles);
            return result;
        }

        /** A polygon by its corners, a polytope by triangles */
        json hullJson(const ConvexHull &hull, unsigned int dimension)
        {
            if (dimension == 2)
            {
                json result{{"kind", "polygon"}};
                for (const Eigen::Vector3d &vertex : hull.vertices)
                    for (const double coordinate : {vertex.x(), vertex.y()})
                        result["points"].push_back(rounded(coordinate));
                return result;
            }
            std::vector<std::array<Eigen::Vector3d, 3>> triangles;
            for (const ConvexHull::Face &face : hull.faces)
                for (std::size_t i = 2; i < face.vertices.size(); ++i)
                    triangles.push_back({hull.vertices[face.vertices[0]], hull.vertices[face.vertices[i - 1]],
                                         hull.vertices[face.vertices[i]]});
            return meshJson(QuantizedMesh(triangles, MAX_TRIANGLES));
        }

        json shapeJson(const Shape &shape, const ZInterval &zInterval)
        {
            const json radius = rounded(shape.getRadius()), length = rounded(shape.getSize().z());
            switch (shape.getKind())
            {
                case Shape::Kind::BALL:
                    return {{"kind", "ball"}, {"radius", radius}};
                case Shape::Kind::CAPSULE:
                    return {{"kind", "capsule"}, {"radius", radius}, {"length", length}};
                case Shape::Kind::CYLINDER:
                    return {{"kind", "cylinder"}, {"radius", radius}, {"length", length}};
                case Shape::Kind::MESH:
                    return meshJson(QuantizedMesh(cornersOf(*shape.getMesh(), zInterval), MAX_TRIANGLES));
                case Shape::Kind::BOX:
                    if (shape.getDimension() == 3)
                        return {{"kind", "box"},
                                {"size", {rounded(shape.getSize().x()), rounded(shape.getSize().y()), length}}};
                    break;
                case Shape::Kind::POLYTOPE:
                    break;
            }
            return hullJson(*shape.getHull(), shape.getDimension());
        }
    }

    ViewerShapes::Key ViewerShapes::keyOf(const Shape &shape, const ZInterval &zInterval)
    {
        const Eigen::Vector3d &size = shape.getSize();
        Key key{static_cast<double>(shape.getKind()),
                static_cast<double>(shape.getDimension()),
                shape.getRadius(),
                size.x(),
                size.y(),
                size.z(),
                zInterval.low,
                zInterval.high};
        const auto append = [&key](const std::vector<Eigen::Vector3d> &corners, std::size_t most)
        {
            key.push_back(static_cast<double>(corners.size()));
            for (std::size_t i = 0; i < std::min(corners.size(), most); ++i)
                key.insert(key.end(), corners[i].data(), corners[i].data() + 3);
        };
        if (shape.getKind() == Shape::Kind::POLYTOPE)
            append(shape.getHull()->vertices, shape.getHull()->vertices.size());
        // A mesh may have millions.
        if (shape.getKind() == Shape::Kind::MESH)
            append(shape.getMesh()->getVertices(), 8);
        return key;
    }

    std::size_t ViewerShapes::add(const Shape &shape, const ZInterval &zInterval)
    {
        const ZInterval interval =
            shape.getKind() == Shape::Kind::MESH && shape.getDimension() == 2 ? zInterval : ZInterval();
        std::vector<std::size_t> &indices = indices_[keyOf(shape, interval)];
        for (const std::size_t index : indices)
            if (entries_[index].shape == shape)
                return index;
        indices.push_back(entries_.size());
        entries_.push_back({shape, interval});
        return indices.back();
    }

    json ViewerShapes::toJson() const
    {
        json shapes = json::array();
        for (const Entry &entry : entries_)
            shapes.push_back(shapeJson(entry.shape, entry.zInterval));
        return shapes;
    }

    double rounded(double number)
    {
        char text[32];
        const char *end = std::to_chars(text, text + sizeof(text), static_cast<float>(number)).ptr;
        double result = 0.0;
        std::from_chars(text, end, result);
        return result;
    }

    std::array<float, 7> numbersOf(const Pose &pose, const Eigen::Vector3d &origin)
    {
        const Eigen::Vector3d position = pose.translation() - origin;
        const Eigen::Quaterniond turn(pose.linear());
        std::array<float, 7> numbers{};
        for (int i = 0; i < 7; ++i)
            numbers[static_cast<std::size_t>(i)] = static_cast<float>(i < 3 ? position[i] : turn.coeffs()[i - 3]);
        return numbers;
    }

    json poseJson(const Pose &pose, const Eigen::Vector3d &origin)
    {
        json numbers = json::array();
        for (const float number : numbersOf(pose, origin))
            numbers.push_back(rounded(static_cast<double>(number)));
        return numbers;
    }
}
