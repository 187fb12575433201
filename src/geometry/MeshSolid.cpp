#include "MeshSolid.h"

#include "ClosedPieces.h"
#include "Weld.h"

#include <algorithm>
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

        bool isClosed(const Surface &piece)
        {
            bool closed = true;
            forEachEdge(sidesOf(piece), [&closed](auto first, auto end) { closed = closed && (end - first) % 2 == 0; });
            return closed;
        }

        /** A turn about no special axis. Rays go along z of the turned frame: they meet no edge or corner of a mesh
            along the axes exactly. */
        const Eigen::Matrix3d &turn()
        {
            static const Eigen::Matrix3d matrix =
                Eigen::Quaterniond(0.8112, 0.3271, -0.4583, 0.1634).normalized().toRotationMatrix();
            return matrix;
        }

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
            if (!isClosed(closed))
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
            pieces_.push_back(std::move(piece));
        }
    }

    bool MeshSolid::contains(const Eigen::Vector3d &point) const
    {
        const Eigen::Vector3d turned = turn() * point;
        return std::any_of(pieces_.begin(), pieces_.end(),
                           [&turned](const Piece &piece)
                           {
                               return piece.box.contains(turned) &&
                                      std::count_if(piece.triangles.begin(), piece.triangles.end(),
                                                    [&](const auto &triangle) { return isMet(triangle, turned); }) %
                                              2 !=
                                          0;
                           });
    }
}
