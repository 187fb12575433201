#include "ompl_certificates/octomap/OctomapObstacles.h"

#include "OctomapCells.h"
#include "OctomapFile.h"

namespace ompl_certificates
{
    OctomapObstacles::OctomapObstacles(const octomap::OcTree &map, const OctomapOptions &options)
      : CellObstacles(map.getResolution(), cellsOf(map, options), options.slice ? 2 : 3, options.origin)
    {
    }

    OctomapObstacles::OctomapObstacles(const std::string &file, const OctomapOptions &options)
      : OctomapObstacles(readOctomap(file), options)
    {
    }

    OctomapObstacles::OctomapObstacles(const OctomapMessage &message, const OctomapOptions &options)
      : OctomapObstacles(readOctomap(message), options)
    {
    }

    OctomapObstacles::OctomapObstacles(const MapNodes &map, const OctomapOptions &options)
      : CellObstacles(map.getResolution(), cellsOf(map, options), options.slice ? 2 : 3, options.origin)
    {
    }
}
