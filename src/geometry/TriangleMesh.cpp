#include "ompl_certificates/geometry/TriangleMesh.h"

#include "MeshInside.h"
#include "MeshSolid.h"
#include "TriangleTree.h"
#include "Weld.h"

#include <algorithm>
#include <cmath>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        /** Squares of larger ones would not fit into the single precision of a TriangleTree. */
        constexpr double LARGEST_COORDINATE = 1e15;

        /** Whether a triangle without area, of these corners, leaves the triangles of a tree somewhere. Slivers lie in
            their neighbors, be it in the middle of an edge. */
        bool isWire(const TriangleTree &tree, const TriangleTree::Corners &corners, double tolerance)
        {
            const auto &[a, b, c] = corners;
            constexpr int pieces = 4;
            for (const auto &[from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
                for (int i = 0; i < pieces; ++i)
                    if (tree.distance(from + i * (to - from) / pieces, 2.0 * tolerance) > tolerance)
                        return true;
            return false;
        }
    }

    TriangleMesh::TriangleMesh(std::vector<Eigen::Vector3d> vertices, std::vector<Triangle> triangles,
                               const std::string &name)
      : vertices_(std::move(vertices)), triangles_(std::move(triangles))
    {
        if (triangles_.empty())
            throw ompl::Exception("A mesh needs at least one triangle");
        for (std::size_t i = 0; i < vertices_.size(); ++i)
            if (!(vertices_[i].cwiseAbs().array() <= LARGEST_COORDINATE).all())
                throw ompl::Exception("Vertex " + std::to_string(i) + " of a mesh is not finite or too large");
        double farthest = 0.0;
        for (std::size_t i = 0; i < triangles_.size(); ++i)
            for (const std::uint32_t corner : triangles_[i])
            {
                if (corner >= vertices_.size())
                    throw ompl::Exception("Triangle " + std::to_string(i) + " of a mesh has vertex " +
                                          std::to_string(corner) + ", but there are only " +
                                          std::to_string(vertices_.size()));
                bounds_.extend(vertices_[corner]);
                farthest = std::max(farthest, vertices_[corner].norm());
            }
        leastHeight_ = std::max(0.5e-7 * bounds_.diagonal().norm(), 1e-12 * farthest);
        std::vector<std::size_t> thin;
        std::size_t degenerate = 0, small = 0;
        for (std::size_t i = 0; i < triangles_.size(); ++i)
        {
            if (!isDegenerate(i))
                continue;
            ++degenerate;
            const auto [a, b, c] = getCorners(i);
            const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
            const bool isThin = !((b - a).cross(c - a).norm() > 1e-3 * longest);
            small += isThin ? 0 : 1;
            if (isThin && longest > leastHeight_ * leastHeight_)
                thin.push_back(i);
        }
        if (degenerate == triangles_.size())
            throw ompl::Exception("None of the " + std::to_string(triangles_.size()) +
                                  " triangles of a mesh has an area");
        if (small > 0)
            OMPL_WARN(
                "%s is %g in size, and up to %g away from its origin, so %zu of its %zu triangles are too small "
                "to be checked. Give what is so large a mesh of its own",
                name.c_str(), bounds_.diagonal().norm(), farthest, small, triangles_.size());
        const double tolerance = 1e-5 * bounds_.diagonal().norm() + 1e-6 * farthest;
        const auto wires =
            std::count_if(thin.begin(), thin.end(),
                          [&](std::size_t triangle) { return isWire(getTree(), getCorners(triangle), tolerance); });
        if (wires > 0)
            OMPL_WARN(
                "%zu of the %zu triangles of %s are wires without an area, which are not checked: give them a "
                "thickness",
                static_cast<std::size_t>(wires), triangles_.size(), name.c_str());
    }

    TriangleMesh::~TriangleMesh() = default;

    bool TriangleMesh::isDegenerate(std::size_t triangle) const
    {
        const auto [a, b, c] = getCorners(triangle);
        const double longest =
            std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
        return !((b - a).cross(c - a).norm() > leastHeight_ * longest);
    }

    const TriangleTree &TriangleMesh::getTree() const
    {
        std::call_once(once_,
                       [this]
                       {
                           tree_ = std::make_unique<TriangleTree>();
                           for (std::uint32_t i = 0; i < triangles_.size(); ++i)
                               if (!isDegenerate(i))
                                   tree_->add(getCorners(i), i);
                           tree_->build();
                       });
        return *tree_;
    }

    const TriangleTree &TriangleMesh::getOutline() const
    {
        const auto makeOutline = [this]
        {
            auto outline = std::make_unique<TriangleTree>();
            for (std::uint32_t i = 0; i < triangles_.size(); ++i)
            {
                if (isDegenerate(i))
                    continue;
                TriangleTree::Corners corners = getCorners(i);
                for (Eigen::Vector3d &corner : corners)
                    corner.z() = 0.0;
                outline->add(corners, i);
            }
            outline->build();
            outline_ = std::move(outline);
        };
        std::call_once(outlineOnce_, makeOutline);
        return *outline_;
    }

    const MeshInside &TriangleMesh::getInside() const
    {
        std::call_once(insideOnce_, [this] { inside_ = std::make_unique<MeshInside>(getTree()); });
        return *inside_;
    }

    const MeshSolid &TriangleMesh::getSolid() const
    {
        std::call_once(solidOnce_, [this] { solid_ = std::make_unique<MeshSolid>(*this); });
        return *solid_;
    }

    bool TriangleMesh::isClosed() const
    {
        const std::vector<std::uint32_t> welded = weld(vertices_);
        using Edge = std::pair<std::uint32_t, std::uint32_t>;
        std::vector<Edge> edges;
        edges.reserve(3 * triangles_.size());
        for (const Triangle &triangle : triangles_)
        {
            const std::uint32_t a = welded[triangle[0]], b = welded[triangle[1]], c = welded[triangle[2]];
            if (a == b || b == c || c == a)
                continue;
            for (const auto &[from, to] : {Edge{a, b}, Edge{b, c}, Edge{c, a}})
                edges.push_back(std::minmax(from, to));
        }
        std::sort(edges.begin(), edges.end());
        for (std::size_t i = 0; i < edges.size(); i += 2)
            if (i + 1 == edges.size() || edges[i] != edges[i + 1] || (i + 2 < edges.size() && edges[i] == edges[i + 2]))
                return false;
        return !edges.empty();
    }
}
