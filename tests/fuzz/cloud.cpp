// Point clouds: the first byte chooses the kind of file, the rest is its content.
#include "FuzzFile.h"

#include "ompl_certificates/obstacles/PointCloudObstacles.h"
#include "ompl_certificates/scene/CloudFile.h"

using namespace ompl_certificates;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const char *const names[] = {"cloud.pcd", "cloud.ply", "cloud.xyz", "cloud.csv"};
    if (size == 0)
        return 0;
    return fuzz::run(
        [&]
        {
            const std::string file = fuzz::folder().write(names[data[0] % 4], fuzz::textOf(data + 1, size - 1));
            const PointCloud cloud = loadCloud(file);
            for (const unsigned int dimension : {2U, 3U})
            {
                const PointCloudObstacles obstacles(cloud, dimension);
                obstacles.clearance(Eigen::Vector3d::Zero());
            }
        });
}
