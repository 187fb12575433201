#include "generators/MeshBuilder.h"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <cstdio>

using namespace ompl_certificates;

namespace generators
{
    std::uint32_t MeshBuilder::addVertex(const Eigen::Vector3d &point)
    {
        // Adding zero turns minus zero into zero.
        vertices_.push_back((point * 1e4).array().round().matrix() / 1e4 + Eigen::Vector3d::Zero());
        return static_cast<std::uint32_t>(vertices_.size() - 1);
    }

    void MeshBuilder::addQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
    {
        triangles_.push_back({a, b, c});
        triangles_.push_back({a, c, d});
    }

    void MeshBuilder::addBox(const Eigen::Vector3d &low, const Eigen::Vector3d &high)
    {
        addPrism({{low.x(), low.y()}, {high.x(), low.y()}, {high.x(), high.y()}, {low.x(), high.y()}}, low.z(),
                 high.z());
    }

    void MeshBuilder::addPrism(const std::vector<Eigen::Vector2d> &polygon, double low, double high)
    {
        const auto count = static_cast<std::uint32_t>(polygon.size());
        const auto first = static_cast<std::uint32_t>(vertices_.size());
        for (const double z : {low, high})
            for (const Eigen::Vector2d &corner : polygon)
                addVertex({corner.x(), corner.y(), z});
        for (std::uint32_t i = 0; i < count; ++i)
        {
            const std::uint32_t next = (i + 1) % count;
            addQuad(first + i, first + next, first + count + next, first + count + i);
            if (i == 0 || next == 0)
                continue;
            triangles_.push_back({first, first + next, first + i});
            triangles_.push_back({first + count, first + count + i, first + count + next});
        }
    }

    void MeshBuilder::addRing(const std::vector<Eigen::Vector2d> &outer, const std::vector<Eigen::Vector2d> &inner,
                              double low, double high)
    {
        const auto count = static_cast<std::uint32_t>(outer.size());
        const auto first = static_cast<std::uint32_t>(vertices_.size());
        for (const auto *polygon : {&outer, &inner})
            for (const double z : {low, high})
                for (const Eigen::Vector2d &corner : *polygon)
                    addVertex({corner.x(), corner.y(), z});
        for (std::uint32_t i = 0; i < count; ++i)
        {
            const std::uint32_t next = (i + 1) % count, below = first, above = first + count, hole = 2 * count;
            addQuad(below + i, below + next, above + next, above + i);
            addQuad(below + hole + next, below + hole + i, above + hole + i, above + hole + next);
            addQuad(above + i, above + next, above + hole + next, above + hole + i);
            addQuad(below + next, below + i, below + hole + i, below + hole + next);
        }
    }

    void MeshBuilder::addTube(const std::function<Eigen::Vector3d(double)> &center, double radius,
                              unsigned int segments, unsigned int sides)
    {
        const auto first = static_cast<std::uint32_t>(vertices_.size());
        for (unsigned int i = 0; i < segments; ++i)
        {
            const double t = static_cast<double>(i) / segments, step = 1e-4;
            const Eigen::Vector3d point = center(t), tangent = (center(t + step) - center(t - step)).normalized();
            // A frame that comes back to where it began: the curve's own bend, not a rotation carried along
            const Eigen::Vector3d bend = center(t + 1e-2) + center(t - 1e-2) - 2.0 * point;
            const Eigen::Vector3d side = tangent.cross(bend).normalized(), up = side.cross(tangent);
            for (unsigned int k = 0; k < sides; ++k)
            {
                const double angle = boost::math::constants::two_pi<double>() * k / sides;
                addVertex(point + radius * (std::cos(angle) * up + std::sin(angle) * side));
            }
        }
        for (unsigned int i = 0; i < segments; ++i)
            for (unsigned int k = 0; k < sides; ++k)
            {
                const std::uint32_t here = first + i * sides, there = first + (i + 1) % segments * sides,
                                    next = (k + 1) % sides;
                addQuad(here + k, here + next, there + next, there + k);
            }
    }

    void MeshBuilder::addTerrain(const std::function<double(double, double)> &height, double size, unsigned int cells)
    {
        const auto first = static_cast<std::uint32_t>(vertices_.size());
        for (unsigned int row = 0; row <= cells; ++row)
            for (unsigned int column = 0; column <= cells; ++column)
            {
                const double x = size * column / cells, y = size * row / cells;
                addVertex({x, y, height(x, y)});
            }
        for (unsigned int row = 0; row < cells; ++row)
            for (unsigned int column = 0; column < cells; ++column)
            {
                const std::uint32_t corner = first + row * (cells + 1) + column, above = corner + cells + 1;
                addQuad(corner, corner + 1, above + 1, above);
            }
    }

    TriangleMeshPtr MeshBuilder::make() const
    {
        return std::make_shared<TriangleMesh>(vertices_, triangles_);
    }

    std::string MeshBuilder::toObj() const
    {
        std::string text;
        char line[100];
        for (const Eigen::Vector3d &vertex : vertices_)
        {
            std::snprintf(line, sizeof(line), "v %.4f %.4f %.4f\n", vertex.x(), vertex.y(), vertex.z());
            text += line;
        }
        for (const TriangleMesh::Triangle &triangle : triangles_)
        {
            std::snprintf(line, sizeof(line), "f %u %u %u\n", triangle[0] + 1, triangle[1] + 1, triangle[2] + 1);
            text += line;
        }
        return text;
    }
}
