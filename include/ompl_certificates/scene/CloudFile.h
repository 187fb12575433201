#ifndef OMPL_CERTIFICATES_SCENE_CLOUD_FILE_
#define OMPL_CERTIFICATES_SCENE_CLOUD_FILE_

#include "ompl_certificates/geometry/PointCloud.h"

#include <string>

namespace ompl_certificates
{
    /** \brief The points of a file, with radius 0. Its name tells what it is: PCD (.pcd: ascii, binary or
        binary_compressed), PLY (.ply), or a text of three coordinates in each line (.xyz, .txt, .asc, .pts, or .csv
        with commas), in the columns x, y and z if the first line names these, or the last comment before the points
        that does, if it has a word for each column. Units behind the names, as in x (m), change nothing. Colors, normals
        and faces are left out, and so are points with a coordinate that is infinite or not a number: there nothing was
        seen.
        \throws ompl::Exception that names the file, the line or byte, and the reason: if it cannot be read, is not what
        its name or its header says, or has a coordinate beyond 1e9
        Cost: some 0.1 s for 10^6 points in binary, 1 s in a text. */
    PointCloud loadCloud(const std::string &file);
}

#endif
