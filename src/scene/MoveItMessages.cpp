#include "MoveItMessages.h"

#include "FileUri.h"
#include "MoveItPlanes.h"
#include "ompl_certificates/scene/MeshFile.h"

#include <algorithm>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>
#include <filesystem>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t MAX_ITEMS = 5000000;

        /** The numbers of a list, or of a map of \e names */
        std::vector<double> readNumbers(const YamlNode &node, const std::vector<std::string> &names)
        {
            if (!node.isMap())
                return node.numbers(names.size());
            node.allow(names);
            std::vector<double> values;
            values.reserve(names.size());
            for (const std::string &name : names)
                values.push_back(node.at(name).number());
            return values;
        }

        Pose readPose(const YamlNode &node, const std::string &position, const std::string &rotation,
                      std::vector<std::string> *notes = nullptr)
        {
            node.allow({position, rotation});
            Pose pose = Pose::Identity();
            if (node.has(position))
                pose.translation() = readMoveItVector(node.at(position));
            if (node.has(rotation))
                pose.linear() = readMoveItRotation(node.at(rotation), notes);
            return pose;
        }

        /** A cone about z, with its tip up and the origin half way: a pyramid around it, whose base's sides touch the
            cone's. It reaches out of the cone by at most 3.1e-4 of the radius. */
        Body cone(double radius, double height)
        {
            constexpr int sides = 128;
            const double corner = radius / std::cos(M_PI / sides);
            std::vector<Eigen::Vector3d> points{{0.0, 0.0, 0.5 * height}};
            for (int i = 0; i < sides; ++i)
                points.emplace_back(corner * std::cos(2.0 * M_PI * i / sides),
                                    corner * std::sin(2.0 * M_PI * i / sides), -0.5 * height);
            return Body::convexHull(points);
        }

        /** Whether all fields of a message are empty */
        bool isEmptyMessage(const YamlNode &node)
        {
            if (!node.isMap())
                return node.isEmpty();
            const auto keys = node.keys();
            return std::all_of(keys.begin(), keys.end(),
                               [&](const std::string &key) { return node.at(key).isEmpty(); });
        }

        Body readPrimitive(const YamlNode &node)
        {
            node.allow({"type", "dimensions", "polygon"});
            refuse(node, {"polygon"});
            const YamlNode sizes = node.at("dimensions");
            const std::string type = node.at("type").text();
            if (type == "box" || type == "1")
            {
                const auto size = sizes.positives(3);
                return Body::box(size[0], size[1], size[2]);
            }
            if (type == "sphere" || type == "2")
                return Body::sphere(sizes.positives(1).front());
            if (type == "cylinder" || type == "3")
            {
                const auto size = sizes.positives(2);
                return Body::cylinder(size[1], size[0]);
            }
            if (type == "cone" || type == "4")
            {
                const auto size = sizes.positives(2);
                return sizes.orFail([&] { return cone(size[1], size[0]); });
            }
            node.at("type").fail("must be one of box, sphere, cylinder, cone, not '" + type + "'");
        }

        /** Whether an operation on an object is to add it: by its name, or as a byte in the ways in which it is
            printed */
        bool isAdd(const YamlNode &node)
        {
            // A block of binary text ends with its line.
            const std::string value = boost::algorithm::trim_copy(node.scalar());
            return value.empty() || value == "add" || value == "0" || value == "0x00" || value == "AA==" ||
                   value == std::string(1, '\0');
        }

        std::size_t readIndex(const YamlNode &node, std::size_t count)
        {
            const double value = node.number();
            if (!(value >= 0.0 && value < static_cast<double>(count) && value == std::floor(value)))
                node.fail("must be the number of a vertex, below " + std::to_string(count) + ", not " +
                          node.describe());
            return static_cast<std::size_t>(value);
        }

        Body readTriangles(const YamlNode &node)
        {
            node.allow({"vertices", "triangles"});
            std::vector<Eigen::Vector3d> vertices;
            for (const YamlNode &item : node.at("vertices").items(3, MAX_ITEMS))
                vertices.push_back(readMoveItVector(item));
            std::vector<TriangleMesh::Triangle> triangles;
            for (const YamlNode &item : node.at("triangles").items(1, MAX_ITEMS))
            {
                if (item.isMap())
                    item.allow({"vertex_indices"});
                const auto corners = (item.isMap() ? item.at("vertex_indices") : item).items(3, 3);
                TriangleMesh::Triangle triangle{};
                for (std::size_t i = 0; i < 3; ++i)
                    triangle[i] =
                        static_cast<TriangleMesh::Triangle::value_type>(readIndex(corners[i], vertices.size()));
                triangles.push_back(triangle);
            }
            return node.orFail([&] { return Body::mesh(std::make_shared<TriangleMesh>(vertices, triangles)); });
        }

        /** The mesh of a file, which robowflex writes in place of triangles */
        Body readResource(const YamlNode &node, const std::string &folder)
        {
            node.allow({"resource", "dimensions"});
            std::string name = node.at("resource").path();
            if (name.rfind("package://", 0) == 0)
                node.at("resource").fail("package:// is not supported in scenes; give a path");
            if (const auto path = pathOfFileUri(name))
                name = *path;
            Eigen::Affine3d scale = Eigen::Affine3d::Identity();
            if (node.has("dimensions"))
            {
                const auto factors = node.at("dimensions").positives(3);
                scale.linear().diagonal() = Eigen::Map<const Eigen::Vector3d>(factors.data());
            }
            const std::string path = (std::filesystem::path(folder) / name).lexically_normal().string();
            return node.at("resource").orFail([&] { return Body::mesh(MeshFile(path, true).transformed(scale)); });
        }

        Body readMesh(const YamlNode &node, const std::string &folder)
        {
            return node.has("resource") ? readResource(node, folder) : readTriangles(node);
        }

        /** Call \e add for each item of \e key with its pose. Poses may be left out together. */
        template <typename Add>
        void addShapes(const YamlNode &node, const std::string &key, const std::string &poseKey, const Pose &origin,
                       std::vector<std::string> &notes, const Add &add)
        {
            const auto shapes = moveItItems(node, key), poses = moveItItems(node, poseKey);
            if (!poses.empty() && poses.size() != shapes.size())
                node.at(poseKey).fail("must have as many items as " + key + ", " + std::to_string(shapes.size()) +
                                      ", not " + std::to_string(poses.size()));
            for (std::size_t i = 0; i < shapes.size(); ++i)
                add(shapes[i],
                    poses.empty() ? origin : Pose(origin * readPose(poses[i], "position", "orientation", &notes)));
        }

        /** The pose of an object, by default none */
        Pose readObjectPose(const YamlNode &node, std::vector<std::string> &notes)
        {
            if (!node.has("pose"))
                return Pose::Identity();
            std::vector<std::string> about;
            Pose pose = readPose(node.at("pose"), "position", "orientation", &about);
            // A message that leaves the pose to the shapes has zeros in all of it.
            if (!pose.translation().isZero(0.0))
                notes.insert(notes.end(), about.begin(), about.end());
            return pose;
        }
    }

    std::vector<YamlNode> moveItItems(const YamlNode &node, const std::string &key)
    {
        if (!node.has(key) || node.at(key).isEmpty())
            return {};
        return node.at(key).items(0, MAX_ITEMS);
    }

    std::string moveItText(const YamlNode &node, const std::string &key)
    {
        return node.has(key) && !node.at(key).isEmpty() ? node.at(key).text() : "";
    }

    std::string moveItFrameName(const YamlNode &node, const std::string &key)
    {
        // Frames had a slash at first.
        const std::string frame = moveItText(node, key);
        return frame.rfind('/', 0) == 0 ? frame.substr(1) : frame;
    }

    std::string moveItFrame(const YamlNode &node)
    {
        if (!node.has("header"))
            return "";
        node.at("header").allow({"seq", "stamp", "frame_id"});
        return moveItFrameName(node.at("header"), "frame_id");
    }

    void refuse(const YamlNode &node, const std::vector<std::string> &keys)
    {
        for (const std::string &key : keys)
            if (node.has(key) && !isEmptyMessage(node.at(key)))
                node.at(key).fail("not supported");
    }

    Eigen::Vector3d readMoveItVector(const YamlNode &node)
    {
        return Eigen::Map<const Eigen::Vector3d>(readNumbers(node, {"x", "y", "z"}).data());
    }

    Pose readMoveItPose(const YamlNode &node)
    {
        return readPose(node, "position", "orientation");
    }

    Pose readMoveItTransform(const YamlNode &node)
    {
        return readPose(node, "translation", "rotation");
    }

    Eigen::Matrix3d readMoveItRotation(const YamlNode &node, std::vector<std::string> *notes)
    {
        const auto values = readNumbers(node, {"x", "y", "z", "w"});
        const Eigen::Quaterniond rotation(values[3], values[0], values[1], values[2]);
        // What nobody filled in is no rotation for MoveIt.
        if (rotation.coeffs().isZero(0.0))
        {
            if (notes)
                notes->push_back(node.getKey() + ": all numbers are 0, which counts as no rotation");
            return Eigen::Matrix3d::Identity();
        }
        if (!(rotation.norm() >= YamlNode::MIN_SIZE))
            node.fail("must not be zero");
        return rotation.normalized().toRotationMatrix();
    }

    PlacedBody readMoveItRegion(const YamlNode &node, std::vector<std::string> &notes)
    {
        node.allow({"primitives", "primitive_poses", "meshes", "mesh_poses"});
        refuse(node, {"meshes", "mesh_poses"});
        std::vector<PlacedBody> bodies;
        addShapes(node, "primitives", "primitive_poses", Pose::Identity(), notes,
                  [&](const YamlNode &item, const Pose &at) {
                      bodies.push_back({readPrimitive(item), at});
                  });
        if (!bodies.empty())
            node.at("primitive_poses").items(1, MAX_ITEMS);
        if (bodies.size() != 1)
            node.fail("must have one primitive, not " + std::to_string(bodies.size()));
        return bodies.front();
    }

    MoveItObject readMoveItObject(const YamlNode &node, const std::string &folder, std::vector<std::string> &notes)
    {
        node.allow({"header", "pose", "id", "type", "primitives", "primitive_poses", "meshes", "mesh_poses", "planes",
                    "plane_poses", "subframe_names", "subframe_poses", "operation"});
        if (node.has("operation") && !isAdd(node.at("operation")))
            node.at("operation").fail("must be add or 0, not " + node.at("operation").describe());
        const Pose pose = readObjectPose(node, notes);
        MoveItObject object{node.at("id").text(), moveItFrame(node), pose, {}, {}};
        addShapes(node, "primitives", "primitive_poses", pose, notes,
                  [&](const YamlNode &item, const Pose &at) {
                      object.shapes.push_back({item, {readPrimitive(item), at}});
                  });
        addShapes(node, "meshes", "mesh_poses", pose, notes,
                  [&](const YamlNode &item, const Pose &at) {
                      object.shapes.push_back({item, {readMesh(item, folder), at}});
                  });
        addShapes(node, "planes", "plane_poses", pose, notes,
                  [&](const YamlNode &item, const Pose &at) {
                      object.planes.push_back({item, at * readMoveItPlane(item)});
                  });
        if (object.shapes.empty() && object.planes.empty())
            node.fail("object '" + object.name + "' has no shape");
        if (object.shapes.size() == 1 && object.planes.empty() && pose.isApprox(Pose::Identity()))
            object.pose = object.shapes.front().shape.pose;
        return object;
    }
}
