#ifndef OMPL_CERTIFICATES_TESTS_OCTOMAP_RANDOM_MAPS_
#define OMPL_CERTIFICATES_TESTS_OCTOMAP_RANDOM_MAPS_

#include "support/Random.h"

#include <memory>
#include <octomap/OcTree.h>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief A map of free and occupied blocks and unknown cells, within 16 cells of the origin */
        inline std::unique_ptr<octomap::OcTree> randomMap(Random &random, double resolution)
        {
            auto map = std::make_unique<octomap::OcTree>(resolution);
            const auto key = [](int i) { return static_cast<octomap::key_type>(32768 + i); };
            for (unsigned int blocks = 1 + random.below(12); blocks > 0; --blocks)
            {
                int low[3], high[3];
                for (int axis = 0; axis < 3; ++axis)
                {
                    low[axis] = static_cast<int>(random.below(28)) - 16;
                    high[axis] = low[axis] + 1 + static_cast<int>(random.below(random.chance(0.3) ? 1 : 8));
                }
                const bool occupied = random.chance(0.4);
                for (int x = low[0]; x < high[0]; ++x)
                    for (int y = low[1]; y < high[1]; ++y)
                        for (int z = low[2]; z < high[2]; ++z)
                            map->updateNode(octomap::OcTreeKey(key(x), key(y), key(z)), occupied);
            }
            if (random.chance(0.7))
                map->prune();
            return map;
        }

        /** \brief Inserts a scan of a wall or of nothing, as a sensor in free space sees it */
        inline void scan(Random &random, octomap::OcTree &map)
        {
            octomap::Pointcloud points;
            const Eigen::Vector3d sensor = random.point(3, 3.0), middle = random.point(3, 3.0);
            for (int i = 0; i < 40; ++i)
            {
                const Eigen::Vector3d point = middle + random.point(3, 0.8);
                points.push_back(static_cast<float>(point.x()), static_cast<float>(point.y()),
                                 static_cast<float>(point.z()));
            }
            map.insertPointCloud(points,
                                 octomap::point3d(static_cast<float>(sensor.x()), static_cast<float>(sensor.y()),
                                                  static_cast<float>(sensor.z())));
        }
    }
}

#endif
