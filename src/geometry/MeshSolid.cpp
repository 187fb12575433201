#include "MeshSolid.h"

#include "ClosedPieces.h"
#include "Weld.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ompl_certificates
{
    namespace
    {
        using Edge = std::pair<std::uint32_t, std::uint32_t>;

        /** The edges of a triangle whose corners are in order */
        std::array<Edge, 3> edgesOf(const TriangleMesh::Triangle &triangle)
        {
            const auto &[a, b, c] = triangle;
            return {Edge{a, b}, Edge{b, c}, Edge{a, c}};
        }

        /** The triangles by welded corners, in order and each once, without those that have two equal corners */
        Surface orderedTriangles(const TriangleMesh &mesh)
        {
            const std::vector<std::uint32_t> welded = weld(mesh.getVertices());
            Surface triangles;
            for (TriangleMesh::Triangle triangle : mesh.getTriangles())
            {
                for (std::uint32_t &corner : triangle)
                    corner = welded[corner];
                std::sort(triangle.begin(), triangle.end());
                if (triangle[0] != triangle[1] && triangle[1] != triangle[2])
                    triangles.push_back(triangle);
            }
            std::sort(triangles.begin(), triangles.end());
            triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
            return triangles;
        }

        /** An edge of a triangle, by the triangle's number */
        struct Side
        {
            Edge edge;
            std::size_t triangle;
        };

        /** Calls \e use with the range of the sides of each edge */
        template <typename Use>
        void forEachEdge(const std::vector<Side> &sides, const Use &use)
        {
            for (auto first = sides.begin(); first != sides.end();)
            {
                const auto end =
                    std::find_if(first, sides.end(), [first](const Side &side) { return side.edge != first->edge; });
                use(first, end);
                first = end;
            }
        }

        /** The sides of all triangles, those of an edge beside each other */
        std::vector<Side> sidesOf(const Surface &surface)
        {
            std::vector<Side> sides;
            sides.reserve(3 * surface.size());
            for (std::size_t i = 0; i < surface.size(); ++i)
                for (const Edge &edge : edgesOf(surface[i]))
                    sides.push_back({edge, i});
            std::sort(sides.begin(), sides.end(), [](const Side &a, const Side &b) { return a.edge < b.edge; });
            return sides;
        }

        /** The surface without triangles that have an edge for themselves, until there is none */
        Surface withoutLoose(const Surface &surface)
        {
            const std::vector<Side> sides = sidesOf(surface);
            std::vector<bool> isLoose(surface.size());
            std::vector<std::size_t> next;
            const auto dropIfAlone = [&](auto first, auto end)
            {
                const auto isLeft = [&](const Side &side) { return !isLoose[side.triangle]; };
                if (std::count_if(first, end, isLeft) != 1)
                    return;
                const std::size_t triangle = std::find_if(first, end, isLeft)->triangle;
                isLoose[triangle] = true;
                next.push_back(triangle);
            };
            forEachEdge(sides, dropIfAlone);
            while (!next.empty())
            {
                const std::size_t triangle = next.back();
                next.pop_back();
                for (const Edge &edge : edgesOf(surface[triangle]))
                {
                    const auto first =
                        std::lower_bound(sides.begin(), sides.end(), edge,
                                         [](const Side &side, const Edge &it) { return side.edge < it; });
                    dropIfAlone(first, std::find_if(first, sides.end(),
                                                    [&edge](const Side &side) { return side.edge != edge; }));
                }
            }
            Surface rest;
            for (std::size_t i = 0; i < surface.size(); ++i)
                if (!isLoose[i])
                    rest.push_back(surface[i]);
            return rest;
        }

        /** Whether each edge is one of an even number of triangles, however they are turned */
        bool hasEvenEdges(const Surface &piece)
        {
            bool even = true;
            forEachEdge(sidesOf(piece), [&even](auto first, auto end) { even = even && (end - first) % 2 == 0; });
            return even;
        }

        /** A turn about no special axis. Rays go along z of the turned frame: they meet no edge or corner of a mesh
            along the axes exactly. */
        const Eigen::Matrix3d &turn()
        {
            static const Eigen::Matrix3d matrix =
                Eigen::Quaterniond(0.8112, 0.3271, -0.4583, 0.1634).normalized().toRotationMatrix();
            return matrix;
        }

        /** In how many columns triangles may be, in the mean */
        constexpr std::size_t MOST_ENTRIES = 8;

        /** On which side of the edge from \e a to \e b a point is, seen along z */
        double sideOf(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Eigen::Vector3d &point)
        {
            return (a.x() - point.x()) * (b.y() - point.y()) - (a.y() - point.y()) * (b.x() - point.x());
        }

        /** Whether the ray along z from a point meets a triangle */
        bool isMet(const std::array<Eigen::Vector3d, 3> &triangle, const Eigen::Vector3d &point)
        {
            const auto &[a, b, c] = triangle;
            const double ofC = sideOf(a, b, point), ofA = sideOf(b, c, point), ofB = -sideOf(a, c, point);
            if ((ofC >= 0.0) != (ofA >= 0.0) || (ofA >= 0.0) == (-ofB >= 0.0))
                return false;
            const double sum = ofA + ofB + ofC;
            const double z = sum != 0.0 ? (ofA * a.z() + ofB * b.z() + ofC * c.z()) / sum : a.z();
            return z > point.z();
        }
    }

    MeshSolid::MeshSolid(const TriangleMesh &mesh)
    {
        const Surface surface = withoutLoose(orderedTriangles(mesh));
        for (const Surface &closed : piecesOf(surface, mesh.getVertices().size()))
        {
            if (!hasEvenEdges(closed))
                continue;
            Piece piece;
            piece.triangles.reserve(closed.size());
            for (const auto &[a, b, c] : closed)
            {
                const auto turned = [&mesh](std::uint32_t i)
                { return Eigen::Vector3d(turn() * mesh.getVertices()[i]); };
                piece.triangles.push_back({turned(a), turned(b), turned(c)});
                for (const Eigen::Vector3d &corner : piece.triangles.back())
                    piece.box.extend(corner);
            }
            piece.sort();
            pieces_.push_back(std::move(piece));
        }
    }

    void MeshSolid::Piece::sort()
    {
        std::vector<Eigen::AlignedBox3d> bounds(triangles.size());
        for (std::size_t i = 0; i < triangles.size(); ++i)
            for (const Eigen::Vector3d &corner : triangles[i])
                bounds[i].extend(corner);
        const auto countColumns = [&](std::size_t axis, const Eigen::AlignedBox3d &of)
        {
            const auto i = static_cast<Eigen::Index>(axis);
            return columnOf(axis, of.max()[i]) - columnOf(axis, of.min()[i]) + 1;
        };
        const auto countEntries = [&]
        {
            return std::accumulate(bounds.begin(), bounds.end(), std::size_t(0),
                                   [&](std::size_t sum, const Eigen::AlignedBox3d &of)
                                   { return sum + countColumns(0, of) * countColumns(1, of); });
        };
        // Large triangles are in many columns.
        columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(triangles.size()))));
        while (columns > 1 && countEntries() > MOST_ENTRIES * triangles.size())
            columns /= 2;
        const auto forEachColumn = [&](const Eigen::AlignedBox3d &of, const auto &visit)
        {
            for (std::size_t x = columnOf(0, of.min().x()); x <= columnOf(0, of.max().x()); ++x)
                for (std::size_t y = columnOf(1, of.min().y()); y <= columnOf(1, of.max().y()); ++y)
                    visit(x * columns + y);
        };
        begins.assign(columns * columns + 1, 0);
        for (const Eigen::AlignedBox3d &of : bounds)
            forEachColumn(of, [this](std::size_t column) { ++begins[column + 1]; });
        std::partial_sum(begins.begin(), begins.end(), begins.begin());
        sorted.resize(begins.back());
        std::vector<std::uint32_t> next = begins;
        for (std::uint32_t i = 0; i < bounds.size(); ++i)
            forEachColumn(bounds[i], [&](std::size_t column) { sorted[next[column]++] = i; });
    }

    std::size_t MeshSolid::Piece::columnOf(std::size_t axis, double coordinate) const
    {
        const auto i = static_cast<Eigen::Index>(axis);
        const double extent = box.max()[i] - box.min()[i];
        const double part = extent > 0.0 ? (coordinate - box.min()[i]) / extent : 0.0;
        return std::min(static_cast<std::size_t>(part * static_cast<double>(columns)), columns - 1);
    }

    bool MeshSolid::Piece::contains(const Eigen::Vector3d &point) const
    {
        if (!box.contains(point))
            return false;
        const std::size_t column = columnOf(0, point.x()) * columns + columnOf(1, point.y());
        const auto isMetBy = [&](std::uint32_t i) { return isMet(triangles[i], point); };
        return std::count_if(sorted.begin() + begins[column], sorted.begin() + begins[column + 1], isMetBy) % 2 != 0;
    }

    bool MeshSolid::contains(const Eigen::Vector3d &point) const
    {
        const Eigen::Vector3d turned = turn() * point;
        return std::any_of(pieces_.begin(), pieces_.end(),
                           [&turned](const Piece &piece) { return piece.contains(turned); });
    }
}
