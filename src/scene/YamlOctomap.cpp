#include "YamlSensed.h"

#ifdef OMPL_CERTIFICATES_HAVE_OCTOMAP
#include "ompl_certificates/octomap/OctomapObstacles.h"

#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        unsigned int readDepth(const YamlNode &node)
        {
            const double depth = node.number();
            if (!(depth >= 1.0 && depth <= 16.0) || depth != std::floor(depth))
                node.fail("must be a whole number from 1 to 16, not " + node.describe());
            return static_cast<unsigned int>(depth);
        }

        OctomapOptions readOptions(const YamlNode &node, unsigned int dimension)
        {
            OctomapOptions options;
            if (node.has("depth"))
                options.depth = readDepth(node.at("depth"));
            options.unknownIsOccupied = readUnknownIsOccupied(node);
            if (node.has("origin"))
                options.origin = Eigen::Map<const Eigen::Vector3d>(node.at("origin").numbers(3).data());
            if (dimension == 2)
            {
                const auto ends = node.at("heights").numbers(2);
                if (!(ends[0] < ends[1]))
                    node.at("heights").fail("its low end must be below its high one, not " +
                                            node.at("heights").describe());
                options.slice = {ends[0], ends[1]};
            }
            return options;
        }
    }

    ObstaclesPtr readOctomap(const YamlNode &node, unsigned int dimension)
    {
        std::vector<std::string> keys{"type", "name", "file", "depth", "unknown", "origin"};
        if (dimension == 2)
            keys.emplace_back("heights");
        node.allow(keys);
        const OctomapOptions options = readOptions(node, dimension);
        const YamlNode file = node.at("file");
        return file.orFail([&] { return std::make_shared<OctomapObstacles>(file.pathBesideFile(), options); });
    }
}

#else

namespace ompl_certificates
{
    ObstaclesPtr readOctomap(const YamlNode &node, unsigned int /*dimension*/)
    {
        node.fail("this program was built without octomap");
    }
}

#endif
