// Octomaps: the first byte chooses how the map is taken, the rest is a .bt or .ot file.
#include "FuzzFile.h"

#include "ompl_certificates/geometry/Body.h"
#include "ompl_certificates/octomap/OctomapObstacles.h"

using namespace ompl_certificates;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size == 0)
        return 0;
    return fuzz::run(
        [&]
        {
            OctomapOptions options;
            options.unknownIsOccupied = (data[0] & 1U) != 0;
            options.depth = 1U + (data[0] >> 1U & 15U);
            const bool isPlanar = (data[0] & 32U) != 0;
            if (isPlanar)
                options.slice = ZInterval{-0.5, 0.5};
            const std::string file = fuzz::folder().write("map", fuzz::textOf(data + 1, size - 1));
            const OctomapObstacles obstacles(file, options);
            obstacles.clearance(Eigen::Vector3d::Zero());
            obstacles.collides(isPlanar ? Body::box(0.5, 0.5) : Body::box(0.5, 0.5, 0.5), Pose::Identity());
        });
}
