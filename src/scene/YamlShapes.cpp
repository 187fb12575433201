#include "YamlShapes.h"

#include "ompl_certificates/files/Suggestion.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t MAX_SHAPES = 1000;

        Eigen::Vector3d pointOf(const std::vector<double> &values)
        {
            return {values[0], values[1], values.size() > 2 ? values[2] : 0.0};
        }

        Body makeBox(const YamlNode &node, const std::vector<double> &size)
        {
            return node.orFail(
                [&] { return size.size() == 2 ? Body::box(size[0], size[1]) : Body::box(size[0], size[1], size[2]); });
        }

        Body readHull(const YamlNode &node, unsigned int dimension)
        {
            const auto items = node.items(dimension + 1, MAX_HULL_POINTS);
            std::vector<Eigen::Vector3d> points;
            for (const YamlNode &item : items)
            {
                const Eigen::Vector3d point = pointOf(item.numbers(dimension));
                if (std::find(points.begin(), points.end(), point) != points.end())
                    item.fail("given twice");
                points.push_back(point);
            }
            const Shape shape = node.orFail([&] { return Shape::polytope(dimension, points); });
            const auto &corners = shape.getHull()->vertices;
            for (std::size_t i = 0; i < points.size(); ++i)
                if (std::find(corners.begin(), corners.end(), points[i]) == corners.end())
                    items[i].fail(
                        "is not a corner of the convex hull; make a body that is not convex of several shapes");
            if (dimension == 3)
                return Body::convexHull(points);
            std::vector<Eigen::Vector2d> outline;
            outline.reserve(points.size());
            for (const Eigen::Vector3d &point : points)
                outline.emplace_back(point.head<2>());
            return Body::convexHull(outline);
        }

        /** What a shape is for. The center of an obstacle and of a zone must be given. */
        enum class Use
        {
            OBSTACLE,
            ZONE,
            ROBOT,
            PART
        };

        /** \param own the keys that are the type's own */
        void allowKeys(const YamlNode &node, unsigned int dimension, Use use, std::vector<std::string> own)
        {
            own.insert(own.begin(), "type");
            own.push_back("center");
            if (use == Use::OBSTACLE)
                own.emplace_back("name");
            if (dimension == 2)
                own.push_back("angle");
            else
                own.insert(own.end(), {"rotation", "quaternion"});
            node.allow(own);
        }

        PlacedBody readPlaced(const YamlNode &node, unsigned int dimension, YamlMeshes &meshes, Use use);

        Body readShapes(const YamlNode &list, unsigned int dimension, YamlMeshes &meshes)
        {
            std::vector<PlacedBody> bodies;
            for (const YamlNode &item : list.items(1, MAX_SHAPES))
                bodies.push_back(readPlaced(item, dimension, meshes, Use::PART));
            return Body::join(bodies);
        }

        PlacedBody readPlaced(const YamlNode &node, unsigned int dimension, YamlMeshes &meshes, Use use)
        {
            const bool planar = dimension == 2, placed = use == Use::OBSTACLE || use == Use::ZONE;
            const YamlNode typeNode = node.at("type");
            const std::string type = typeNode.text();
            const auto place = [&](const Body &body) { return PlacedBody{body, readPose(node, dimension, placed)}; };
            if (type == "box")
            {
                allowKeys(node, dimension, use, {"size"});
                const auto size = node.at("size").positives(dimension);
                return place(makeBox(node.at("size"), size));
            }
            if (type == (planar ? "disc" : "sphere"))
            {
                allowKeys(node, dimension, use, {"radius"});
                const double radius = node.at("radius").positive();
                return place(planar ? Body::disc(radius) : Body::sphere(radius));
            }
            if (type == "capsule" || (type == "cylinder" && !planar))
            {
                allowKeys(node, dimension, use, {"radius", "length"});
                const double radius = node.at("radius").positive(), length = node.at("length").positive();
                if (type == "cylinder")
                    return place(Body::cylinder(radius, length));
                return place(planar ? Body::planarCapsule(radius, length) : Body::capsule(radius, length));
            }
            if (type == (planar ? "polygon" : "polytope"))
            {
                allowKeys(node, dimension, use, {"vertices"});
                return {readHull(node.at("vertices"), dimension), readPose(node, dimension, false)};
            }
            if (type == "compound" && use != Use::PART)
            {
                allowKeys(node, dimension, use, {"shapes"});
                return {readShapes(node.at("shapes"), dimension, meshes), readPose(node, dimension, false)};
            }
            if (type == "mesh")
            {
                // In the plane a turn other than about z is one of the mesh, before it is placed.
                std::vector<std::string> own{"file", "scale", "reference", "keep_axes"};
                if (planar)
                    own.insert(own.end(), {"rotation", "quaternion"});
                allowKeys(node, dimension, use, own);
                const Eigen::Matrix3d rotation = planar ? readRotation(node) : Eigen::Matrix3d::Identity();
                return {meshes.read(node, dimension, rotation), readPose(node, dimension, false)};
            }
            std::vector<std::string> known =
                planar ? std::vector<std::string>{"box", "disc", "capsule", "polygon", "mesh"}
                       : std::vector<std::string>{"box", "sphere", "capsule", "cylinder", "polytope", "mesh"};
            if (use != Use::PART)
                known.emplace_back("compound");
            if (use == Use::OBSTACLE)
                known.insert(known.end(), {"cloud", "octomap"});
            if (use == Use::OBSTACLE && planar)
                known.emplace_back("occupancy_map");
            typeNode.fail("must be one of " + joined(known) + " in " + std::to_string(dimension) +
                          " dimensions, not '" + type + "'" + didYouMean(type, known));
        }
    }

    double readAngle(const YamlNode &node)
    {
        const double angle = node.number();
        if (std::abs(angle) > 2.0 * M_PI)
            node.note(ANGLE_NOTE);
        return angle;
    }

    double readDistance(const YamlNode &node)
    {
        const double distance = node.number();
        if (distance < 0.0)
            node.fail("must not be negative, not " + node.describe());
        return distance;
    }

    double readPadding(const YamlNode &node)
    {
        return node.has("padding") ? readDistance(node.at("padding")) : 0.0;
    }

    Eigen::Matrix3d readRotation(const YamlNode &node)
    {
        if (node.has("rotation") && node.has("quaternion"))
            node.at("quaternion").fail("give either a rotation or a quaternion");
        if (node.has("rotation"))
        {
            const YamlNode rotation = node.at("rotation");
            rotation.allow({"axis", "angle"});
            const Eigen::Vector3d axis = pointOf(rotation.at("axis").numbers(3));
            if (!(axis.norm() >= YamlNode::MIN_SIZE))
                rotation.at("axis").fail("must not be zero");
            return Eigen::AngleAxisd(readAngle(rotation.at("angle")), axis.normalized()).toRotationMatrix();
        }
        if (node.has("quaternion"))
        {
            const auto q = node.at("quaternion").numbers(4);
            const Eigen::Quaterniond quaternion(q[3], q[0], q[1], q[2]);
            if (!(quaternion.norm() >= YamlNode::MIN_SIZE))
                node.at("quaternion").fail("must not be zero");
            return quaternion.normalized().toRotationMatrix();
        }
        return Eigen::Matrix3d::Identity();
    }

    Pose readFrame(const YamlNode &node)
    {
        Pose pose = Pose::Identity();
        if (node.has("position"))
            pose.translation() = pointOf(node.at("position").numbers(3));
        pose.linear() = readRotation(node);
        return pose;
    }

    Pose readPose(const YamlNode &node, unsigned int dimension, bool needsCenter)
    {
        Pose pose = Pose::Identity();
        if (needsCenter || node.has("center"))
            pose.translation() = pointOf(node.at("center").numbers(dimension));
        if (dimension == 3)
            pose.linear() = readRotation(node);
        else if (node.has("angle"))
            pose.linear() = planarPose(0.0, 0.0, readAngle(node.at("angle"))).linear();
        return pose;
    }

    PlacedBody readObstacle(const YamlNode &node, unsigned int dimension, YamlMeshes &meshes)
    {
        return readPlaced(node, dimension, meshes, Use::OBSTACLE);
    }

    std::vector<PlacedBody> readZones(const YamlNode &list, unsigned int dimension, YamlMeshes &meshes)
    {
        std::vector<PlacedBody> zones;
        for (const YamlNode &item : list.items(1, MAX_SHAPES))
            zones.push_back(readPlaced(item, dimension, meshes, Use::ZONE));
        return zones;
    }

    Body readShape(const YamlNode &node, unsigned int dimension, YamlMeshes &meshes)
    {
        // A point robot is the paper's simplest; as an obstacle a point would be missed by every discrete check.
        if (node.at("type").text() == "point")
        {
            node.allow({"type"});
            return dimension == 2 ? Body::disc(0.0) : Body::sphere(0.0);
        }
        const PlacedBody placed = readPlaced(node, dimension, meshes, Use::ROBOT);
        if (placed.pose.matrix() == Pose::Identity().matrix())
            return placed.body;
        return Body::join({placed});
    }

    Body readBody(const YamlNode &node, unsigned int dimension, YamlMeshes &meshes)
    {
        if (node.has("shape") && node.has("shapes"))
            node.at("shapes").fail("give either shape or shapes");
        if (node.has("shapes"))
            return readShapes(node.at("shapes"), dimension, meshes);
        return readShape(node.at("shape"), dimension, meshes);
    }
}
