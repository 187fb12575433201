#include "FclConvex.h"

#include "ompl_certificates/geometry/Shape.h"

#include <fcl/geometry/shape/convex.h>

namespace ompl_certificates
{
    std::shared_ptr<fcl::CollisionGeometryd> makeConvex(const ConvexHull &hull, double prismHeight)
    {
        auto vertices = std::make_shared<std::vector<fcl::Vector3d>>(hull.vertices);
        auto faces = std::make_shared<std::vector<int>>();
        int faceCount = 0;
        const auto addFace = [&](const std::vector<std::size_t> &corners)
        {
            faces->push_back(static_cast<int>(corners.size()));
            for (const std::size_t corner : corners)
                faces->push_back(static_cast<int>(corner));
            ++faceCount;
        };
        if (prismHeight > 0.0)
        {
            const std::size_t n = hull.vertices.size();
            const Eigen::Vector3d up(0.0, 0.0, 0.5 * prismHeight);
            std::vector<std::size_t> top, bottom;
            for (std::size_t i = 0; i < n; ++i)
            {
                (*vertices)[i] = hull.vertices[i] - up;
                vertices->push_back(hull.vertices[i] + up);
                bottom.push_back(n - 1 - i);
                top.push_back(n + i);
            }
            addFace(bottom);
            addFace(top);
            for (std::size_t i = 0; i < n; ++i)
                addFace({i, (i + 1) % n, n + (i + 1) % n, n + i});
        }
        else
            for (const auto &face : hull.faces)
                addFace(face.vertices);
        for (auto &vertex : *vertices)
            vertex *= Shape::FCL_SCALE;
        return std::make_shared<fcl::Convexd>(vertices, faceCount, faces);
    }
}
