#ifndef OMPL_CERTIFICATES_SCENE_OCCUPANCY_MAP_FILE_
#define OMPL_CERTIFICATES_SCENE_OCCUPANCY_MAP_FILE_

#include "ompl_certificates/obstacles/CellObstacles.h"

#include <memory>
#include <string>

namespace ompl_certificates
{
    /** \brief The occupied cells of a map as ROS's map_server has it

        A YAML file names an image (.png, .pgm, .pbm or .ppm), its resolution, the origin of its lower left corner, and
        the thresholds. Each pixel is a square cell of the plane. Dark ones are occupied, or bright ones if \c negate is 1.
        Missing thresholds are those of map_server, 0.65 and 0.25. Pixels that are not wholly opaque are unknown in the
        mode \c scale; in the mode \c trinary opacity counts as a fourth color, as there.
        \param file the YAML file; the image is relative to its folder
        \param unknownIsOccupied whether cells between the thresholds are obstacles, too. Outside the map all is free.
        \throws ompl::Exception that names the file, and the key or the line: if it or the image cannot be read or is
        damaged, if the mode is \c raw, if the origin has an angle, or if the image has an edge of more than 32768
        pixels
        Cost: some 10 ns per pixel. */
    std::shared_ptr<const CellObstacles> loadOccupancyMap(const std::string &file, bool unknownIsOccupied = false);
}

#endif
