#include "QuantizedMesh.h"

#include <algorithm>
#include <map>

namespace ompl_certificates
{
    namespace
    {
        constexpr double FINEST = 65535.0, COARSEST = 63.0;
    }

    QuantizedMesh::QuantizedMesh(const std::vector<std::array<Eigen::Vector3d, 3>> &corners, std::size_t most)
    {
        Eigen::AlignedBox3d box;
        for (const std::array<Eigen::Vector3d, 3> &triangle : corners)
            for (const Eigen::Vector3d &corner : triangle)
                box.extend(corner);
        low = corners.empty() ? Eigen::Vector3d::Zero().eval() : box.min();
        const Eigen::Vector3d size = corners.empty() ? Eigen::Vector3d::Zero().eval() : box.sizes();
        double levels = FINEST;
        quantize(corners, size, levels);
        // Too many triangles are merged on a coarser grid, which begins where their number says.
        if (triangles.size() / 3 > most)
            levels = 4096.0;
        while (triangles.size() / 3 > most && levels > COARSEST)
        {
            quantize(corners, size, levels);
            levels *= 0.7;
        }
    }

    void QuantizedMesh::quantize(const std::vector<std::array<Eigen::Vector3d, 3>> &corners,
                                 const Eigen::Vector3d &size, double levels)
    {
        step = Eigen::Vector3d::Constant(size.maxCoeff() / levels);
        vertices.clear();
        triangles.clear();
        std::map<std::array<std::uint16_t, 3>, std::uint32_t> indices;
        const auto indexOf = [&](const Eigen::Vector3d &corner)
        {
            std::array<std::uint16_t, 3> cell{};
            for (int axis = 0; axis < 3; ++axis)
                if (step[axis] > 0.0)
                    cell[static_cast<std::size_t>(axis)] = static_cast<std::uint16_t>(
                        std::clamp(std::round((corner[axis] - low[axis]) / step[axis]), 0.0, FINEST));
            const auto [found, isNew] = indices.try_emplace(cell, static_cast<std::uint32_t>(indices.size()));
            if (isNew)
                vertices.insert(vertices.end(), cell.begin(), cell.end());
            return found->second;
        };
        for (const std::array<Eigen::Vector3d, 3> &triangle : corners)
        {
            const std::array<std::uint32_t, 3> index{indexOf(triangle[0]), indexOf(triangle[1]), indexOf(triangle[2])};
            if (index[0] != index[1] && index[1] != index[2] && index[2] != index[0])
                triangles.insert(triangles.end(), index.begin(), index.end());
        }
    }

    std::vector<std::array<Eigen::Vector3d, 3>> cornersOf(const TriangleMesh &mesh, const ZInterval &zInterval)
    {
        std::vector<std::array<Eigen::Vector3d, 3>> corners;
        for (std::size_t i = 0; i < mesh.getTriangles().size(); ++i)
        {
            const std::array<Eigen::Vector3d, 3> triangle = mesh.getCorners(i);
            const auto [lowest, highest] = std::minmax({triangle[0].z(), triangle[1].z(), triangle[2].z()});
            if (lowest <= zInterval.high && highest >= zInterval.low)
                corners.push_back(triangle);
        }
        return corners;
    }
}
