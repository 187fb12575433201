#include "ompl_certificates/geometry/TriangleMesh.h"

#include "MeshInside.h"
#include "MeshSolid.h"
#include "TriangleTree.h"
#include "Weld.h"

#include <algorithm>
#include <boost/functional/hash.hpp>
#include <cmath>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <unordered_set>

namespace ompl_certificates
{
    namespace
    {
        /** Squares of larger ones would not fit into the single precision of a TriangleTree. */
        constexpr double LARGEST_COORDINATE = 1e15;

        using Place = std::array<double, 3>;

        /** A place, with one kind of zero */
        Place placeOf(const Eigen::Vector3d &point)
        {
            return {point.x() + 0.0, point.y() + 0.0, point.z() + 0.0};
        }

        /** How many of some triangles, \e wires, have a corner where no triangle with an area has one, so that what they
            touch need not touch a neighbor */
        std::size_t countLone(const std::vector<Eigen::Vector3d> &vertices,
                              const std::vector<TriangleMesh::Triangle> &triangles, const std::vector<bool> &hasArea,
                              const std::vector<std::size_t> &wires)
        {
            std::unordered_set<Place, boost::hash<Place>> alone;
            for (const std::size_t wire : wires)
                for (const std::uint32_t corner : triangles[wire])
                    alone.insert(placeOf(vertices[corner]));
            for (std::size_t i = 0; i < triangles.size() && !alone.empty(); ++i)
                if (hasArea[i])
                    for (const std::uint32_t corner : triangles[i])
                        alone.erase(placeOf(vertices[corner]));
            const auto isAlone = [&](std::size_t wire)
            {
                return std::any_of(triangles[wire].begin(), triangles[wire].end(),
                                   [&](std::uint32_t corner) { return alone.count(placeOf(vertices[corner])) != 0; });
            };
            return static_cast<std::size_t>(std::count_if(wires.begin(), wires.end(), isAlone));
        }
    }

    TriangleMesh::TriangleMesh(std::vector<Eigen::Vector3d> vertices, std::vector<Triangle> triangles)
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
        std::vector<bool> hasArea(triangles_.size());
        std::vector<std::size_t> wires;
        std::size_t degenerate = 0, small = 0;
        for (std::size_t i = 0; i < triangles_.size(); ++i)
        {
            hasArea[i] = !isDegenerate(i);
            if (hasArea[i])
                continue;
            ++degenerate;
            const auto [a, b, c] = getCorners(i);
            const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
            const bool isThin = !((b - a).cross(c - a).norm() > 1e-3 * longest);
            small += isThin ? 0 : 1;
            if (isThin && longest > leastHeight_ * leastHeight_)
                wires.push_back(i);
        }
        if (degenerate == triangles_.size())
            throw ompl::Exception("None of the " + std::to_string(triangles_.size()) +
                                  " triangles of a mesh has an area");
        if (small > 0)
            OMPL_WARN(
                "A mesh is %g in size, and up to %g away from its origin, so %zu of its %zu triangles are too small "
                "to be checked. Give what is so large a mesh of its own",
                bounds_.diagonal().norm(), farthest, small, triangles_.size());
        if (const std::size_t lone = wires.empty() ? 0 : countLone(vertices_, triangles_, hasArea, wires))
            OMPL_WARN(
                "%zu of the %zu triangles of a mesh have no area, and a corner where no other triangle has one. They are "
                "not checked: give wires and fences a thickness",
                lone, triangles_.size());
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
