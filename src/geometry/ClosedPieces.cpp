#include "ClosedPieces.h"

#include "Weld.h"
#include "Winding.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <numeric>
#include <utility>

namespace ompl_certificates
{
    namespace
    {
        /** Whether each edge is passed as often in one direction as in the other */
        bool isClosed(const Surface &piece)
        {
            struct Edge
            {
                std::pair<std::uint32_t, std::uint32_t> ends;
                int direction;
            };
            std::vector<Edge> edges;
            edges.reserve(3 * piece.size());
            for (const auto &triangle : piece)
                for (std::size_t i = 0; i < 3; ++i)
                {
                    const std::uint32_t from = triangle[i], to = triangle[(i + 1) % 3];
                    edges.push_back({std::minmax(from, to), from < to ? 1 : -1});
                }
            std::sort(edges.begin(), edges.end(), [](const Edge &a, const Edge &b) { return a.ends < b.ends; });
            int sum = 0;
            for (std::size_t i = 0; i < edges.size(); ++i)
            {
                sum += edges[i].direction;
                const bool isLast = i + 1 == edges.size() || edges[i].ends != edges[i + 1].ends;
                if (isLast && sum != 0)
                    return false;
            }
            return true;
        }

        ClosedPiece makePiece(const Surface &triangles, const std::vector<Eigen::Vector3d> &vertices)
        {
            ClosedPiece piece;
            for (const auto &[a, b, c] : triangles)
            {
                piece.surface.add({vertices[a], vertices[b], vertices[c]}, 0);
                for (const std::uint32_t corner : {a, b, c})
                    piece.box.extend(vertices[corner]);
            }
            for (const auto &triangle : triangles)
                for (const std::uint32_t corner : triangle)
                    for (std::size_t axis = 0; axis < 3; ++axis)
                    {
                        const Eigen::Vector3d &vertex = vertices[corner];
                        const auto k = static_cast<Eigen::Index>(axis);
                        if (vertex[k] == piece.box.min()[k])
                            piece.corners[2 * axis] = vertex;
                        if (vertex[k] == piece.box.max()[k])
                            piece.corners[2 * axis + 1] = vertex;
                    }
            return piece;
        }
    }

    std::vector<Surface> piecesOf(const Surface &triangles, std::size_t vertexCount)
    {
        std::vector<std::uint32_t> parents(vertexCount);
        std::iota(parents.begin(), parents.end(), 0U);
        const auto rootOf = [&parents](std::uint32_t vertex)
        {
            while (parents[vertex] != vertex)
                vertex = parents[vertex] = parents[parents[vertex]];
            return vertex;
        };
        for (const auto &[a, b, c] : triangles)
        {
            parents[rootOf(b)] = rootOf(a);
            parents[rootOf(c)] = rootOf(a);
        }
        constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
        std::vector<std::size_t> numbers(vertexCount, none);
        std::vector<Surface> pieces;
        for (const auto &triangle : triangles)
        {
            std::size_t &number = numbers[rootOf(triangle[0])];
            if (number == none)
            {
                number = pieces.size();
                pieces.emplace_back();
            }
            pieces[number].push_back(triangle);
        }
        return pieces;
    }

    std::vector<ClosedPiece> closedPiecesOf(const TriangleTree &mesh)
    {
        std::vector<Eigen::Vector3d> vertices;
        vertices.reserve(3 * mesh.size());
        for (std::uint32_t i = 0; i < mesh.size(); ++i)
            for (const Eigen::Vector3d &corner : mesh.getTriangle(i).corners)
                vertices.push_back(corner);
        const std::vector<std::uint32_t> welded = weld(vertices);
        Surface triangles;
        triangles.reserve(mesh.size());
        for (std::size_t i = 0; i < vertices.size(); i += 3)
            triangles.push_back({welded[i], welded[i + 1], welded[i + 2]});
        std::vector<ClosedPiece> closed;
        for (const Surface &piece : piecesOf(triangles, vertices.size()))
            if (isClosed(piece))
                closed.push_back(makePiece(piece, vertices));
        closed.erase(std::remove_if(closed.begin(), closed.end(),
                                    [](const ClosedPiece &piece) { return !(piece.box.volume() > 0.0); }),
                     closed.end());
        std::sort(closed.begin(), closed.end(),
                  [](const ClosedPiece &a, const ClosedPiece &b)
                  { return a.box.diagonal().squaredNorm() > b.box.diagonal().squaredNorm(); });
        return closed;
    }

    bool isInside(const TriangleTree &surface, const Eigen::Vector3d &point)
    {
        double sum = 0.0;
        for (std::uint32_t i = 0; i < surface.size(); ++i)
        {
            const auto &[a, b, c] = surface.getTriangle(i).corners;
            sum += halfSolidAngle(a - point, b - point, c - point);
        }
        const double winding = sum / boost::math::constants::two_pi<double>(), whole = std::round(winding);
        return whole != 0.0 && std::abs(winding - whole) < 0.01;
    }
}
