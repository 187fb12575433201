#ifndef OMPL_CERTIFICATES_SRC_PICTURES_QUANTIZED_MESH_
#define OMPL_CERTIFICATES_SRC_PICTURES_QUANTIZED_MESH_

#include "ompl_certificates/geometry/TriangleMesh.h"
#include "ompl_certificates/geometry/ZInterval.h"

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace ompl_certificates
{
    /** \brief Triangles for a picture, with coordinates of 16 bits: equal vertices are one, and triangles without area
        are left out. */
    struct QuantizedMesh
    {
        /** \brief Triangles with these corners
            \param most how many triangles there should be at most. Of more, vertices near each other become one. */
        QuantizedMesh(const std::vector<std::array<Eigen::Vector3d, 3>> &triangles, std::size_t most);

        /** \brief Coordinate \e c stands for low + c * step. */
        Eigen::Vector3d low, step;

        /** \brief The coordinates of the vertices: x, y, z, x, ... */
        std::vector<std::uint16_t> vertices;

        /** \brief The indices of the triangles' vertices */
        std::vector<std::uint32_t> triangles;

    private:
        /** \brief Make vertices and triangles with coordinates from 0 to \e levels */
        void quantize(const std::vector<std::array<Eigen::Vector3d, 3>> &corners, const Eigen::Vector3d &size,
                      double levels);
    };

    /** \brief The corners of the triangles that overlap \e zInterval */
    std::vector<std::array<Eigen::Vector3d, 3>> cornersOf(const TriangleMesh &mesh, const ZInterval &zInterval);
}

#endif
