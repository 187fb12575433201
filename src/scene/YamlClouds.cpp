#include "YamlSensed.h"

#include "YamlShapes.h"
#include "ompl_certificates/obstacles/PointCloudObstacles.h"
#include "ompl_certificates/scene/CloudFile.h"

namespace ompl_certificates
{
    namespace
    {
        PointCloud loadCloud(const YamlNode &node)
        {
            return node.orFail([&] { return ompl_certificates::loadCloud(node.pathBesideFile()); });
        }

        ZInterval readHeights(const YamlNode &node)
        {
            const auto heights = node.numbers(2);
            if (!(heights[0] <= heights[1]))
                node.fail("must be the lower height and then the upper one, not " + node.describe());
            return {heights[0], heights[1]};
        }
    }

    ObstaclesPtr readCloud(const YamlNode &node, unsigned int dimension)
    {
        std::vector<std::string> keys{"type", "name", "file", "radius", "resolution", "scale", "center"};
        if (dimension == 2)
            keys.insert(keys.end(), {"angle", "heights"});
        else
            keys.insert(keys.end(), {"rotation", "quaternion"});
        node.allow(keys);
        PointCloud cloud = loadCloud(node.at("file"));
        cloud.radius = node.at("radius").positive();
        const double scale = node.has("scale") ? node.at("scale").positive() : 1.0;
        const double cell = node.has("resolution") ? node.at("resolution").positive() : 0.0;
        const Pose pose = readPose(node, dimension, false);
        for (Eigen::Vector3d &point : cloud.points)
            point = pose * (scale * point);
        if (dimension == 2)
            cloud = sliced(std::move(cloud), node.has("heights") ? readHeights(node.at("heights")) : ZInterval());
        return node.orFail(
            [&]
            {
                if (cell > 0.0)
                    cloud = thinned(std::move(cloud), cell);
                return std::make_shared<PointCloudObstacles>(std::move(cloud), dimension);
            });
    }
}
