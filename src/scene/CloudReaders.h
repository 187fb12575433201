#ifndef OMPL_CERTIFICATES_SCENE_CLOUD_READERS_
#define OMPL_CERTIFICATES_SCENE_CLOUD_READERS_

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace ompl_certificates
{
    /** \brief Read the points of a PCD file: ascii, binary or binary_compressed. Here and below points with a
        coordinate that is infinite or not a number, as clouds have where nothing was seen, are left out.
        \throws std::runtime_error that names line or byte and value if there is something wrong, as the other readers
        do */
    std::vector<Eigen::Vector3d> readPcd(std::string_view content);

    /** \brief Read the points of a text: the first three numbers of each line, or those in the columns x, y and z that
        the first line names. Lines that are empty or begin with # or // are left out, and a first line that is the
        number of points. */
    std::vector<Eigen::Vector3d> readXyz(std::string_view content);

    /** \brief The same, with commas between the numbers */
    std::vector<Eigen::Vector3d> readCsv(std::string_view content);

    /** \brief Read the vertices of a PLY file, which need not have faces */
    std::vector<Eigen::Vector3d> readPlyPoints(std::string_view content);
}

#endif
