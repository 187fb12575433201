#include "MoveItOctomap.h"

#include "MoveItMessages.h"

#ifdef OMPL_CERTIFICATES_HAVE_OCTOMAP
#include "ompl_certificates/octomap/OctomapMessage.h"
#include "ompl_certificates/octomap/OctomapObstacles.h"
#endif

#include <cmath>

namespace ompl_certificates
{
    namespace
    {
#ifdef OMPL_CERTIFICATES_HAVE_OCTOMAP
        /** Bytes as numbers, with or without a sign */
        std::string readBytes(const YamlNode &node)
        {
            // yaml-cpp takes some 650 bytes of memory for each.
            constexpr std::size_t most = 5000000;
            std::string bytes;
            for (const YamlNode &item : node.items(0, most))
            {
                const double value = item.number();
                if (!(value >= -128.0 && value <= 255.0 && value == std::floor(value)))
                    item.fail("must be a byte, from -128 to 255, not " + item.describe());
                bytes.push_back(static_cast<char>(static_cast<int>(value)));
            }
            return bytes;
        }

        std::shared_ptr<const CellObstacles> readMap(const YamlNode &node, const Eigen::Vector3d &origin)
        {
            OctomapMessage message;
            message.binary = node.at("binary").boolean();
            message.id = node.at("id").text();
            message.resolution = node.at("resolution").positive();
            message.data = readBytes(node.at("data"));
            OctomapOptions options;
            options.origin = origin;
            return node.orFail([&] { return std::make_shared<OctomapObstacles>(message, options); });
        }
#else
        std::shared_ptr<const CellObstacles> readMap(const YamlNode &node, const Eigen::Vector3d & /*origin*/)
        {
            node.fail("this program was built without octomap");
        }
#endif
    }

    std::shared_ptr<const CellObstacles> readMoveItOctomap(const YamlNode &node, const MoveItFrames &frames)
    {
        node.allow({"header", "origin", "octomap"});
        if (!node.has("octomap"))
            return nullptr;
        const YamlNode map = node.at("octomap");
        map.allow({"header", "binary", "id", "resolution", "data"});
        if (!map.has("data") || map.at("data").isEmpty())
            return nullptr;
        Pose pose = readMoveItFrame(node, frames);
        if (node.has("origin"))
            pose = pose * readMoveItPose(node.at("origin"));
        // A map is large, so this is stricter than of other poses.
        if (!pose.linear().isApprox(Eigen::Matrix3d::Identity(), 1e-9))
            node.fail("a map that is turned is not supported");
        return readMap(map, pose.translation());
    }
}
