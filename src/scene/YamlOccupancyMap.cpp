#include "YamlSensed.h"

#include "ompl_certificates/scene/OccupancyMapFile.h"

namespace ompl_certificates
{
    bool readUnknownIsOccupied(const YamlNode &node)
    {
        if (!node.has("unknown"))
            return false;
        const std::string unknown = node.at("unknown").text();
        if (unknown != "free" && unknown != "occupied")
            node.at("unknown").fail("must be free or occupied, not '" + unknown + "'");
        return unknown == "occupied";
    }

    ObstaclesPtr readOccupancyMap(const YamlNode &node, unsigned int dimension)
    {
        node.allow({"type", "name", "file", "unknown"});
        if (dimension != 2)
            node.at("type").fail("an occupancy_map is for the plane, but min and max have " +
                                 std::to_string(dimension) + " coordinates");
        const YamlNode file = node.at("file");
        const bool unknownIsOccupied = readUnknownIsOccupied(node);
        return file.orFail([&] { return loadOccupancyMap(file.pathBesideFile(), unknownIsOccupied); });
    }
}
