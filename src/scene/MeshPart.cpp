#include "MeshPart.h"

#include <algorithm>
#include <stdexcept>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t MOST_STEPS = 300000000;
        constexpr std::uint32_t NONE = 0xFFFFFFFFU;
        /** Of vertices at one place no more than so many are compared: else a fan of n triangles would take n²
            steps. */
        constexpr unsigned int MOST_COMPARED = 300;
        /** Assimp takes normals and textures whose squared distance is no larger for the same. */
        constexpr float SAME = 1e-5F * 1e-5F;

        void checkAtMost(std::size_t most, std::size_t count, const char *what)
        {
            if (count > most)
                throw std::runtime_error("it has more than " + std::to_string(most) + " " + what);
        }

        /** Twice the signed area of a triangle in the plane */
        double area(const Eigen::Vector2d &a, const Eigen::Vector2d &b, const Eigen::Vector2d &c)
        {
            return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
        }

        /** A polygon as it is seen along the axis that it faces most, counter-clockwise */
        std::vector<Eigen::Vector2d> flatten(const std::vector<Eigen::Vector3d> &points)
        {
            Eigen::Vector3d normal = Eigen::Vector3d::Zero();
            for (std::size_t i = 1; i + 1 < points.size(); ++i)
                normal += (points[i] - points[0]).cross(points[i + 1] - points[0]);
            Eigen::Index axis;
            normal.cwiseAbs().maxCoeff(&axis);
            Eigen::Index x = (axis + 1) % 3, y = (axis + 2) % 3;
            if (normal[axis] < 0.0)
                std::swap(x, y);
            std::vector<Eigen::Vector2d> flat;
            flat.reserve(points.size());
            for (const Eigen::Vector3d &point : points)
                flat.emplace_back(point[x], point[y]);
            return flat;
        }

        /** Whether the corner \e ear of a polygon can be cut off: it is convex, and no other corner lies within, nor on
            the edges if \e edgesCount. Cut off with one on its edge, it may leave a rest that crosses itself. */
        bool isEar(const std::vector<Eigen::Vector2d> &corners, std::size_t ear, bool edgesCount)
        {
            const std::size_t count = corners.size();
            const Eigen::Vector2d &a = corners[(ear + count - 1) % count], &b = corners[ear],
                                  &c = corners[(ear + 1) % count];
            // What rounding leaves of an area of zero
            const double zero = 1e-12 * std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
            const auto isOnOrWithin = [&](const Eigen::Vector2d &point)
            {
                return point != a && point != b && point != c && area(a, b, point) >= -zero &&
                       area(b, c, point) >= -zero && area(c, a, point) >= -zero;
            };
            const auto isWithin = [&](const Eigen::Vector2d &point)
            { return area(a, b, point) > 0.0 && area(b, c, point) > 0.0 && area(c, a, point) > 0.0; };
            return edgesCount ? area(a, b, c) >= -zero && std::none_of(corners.begin(), corners.end(), isOnOrWithin)
                              : area(a, b, c) >= 0.0 && std::none_of(corners.begin(), corners.end(), isWithin);
        }
    }

    std::uint32_t MeshPart::add(const Vertex &vertex)
    {
        checkAtMost(MOST_CORNERS, vertices.size() + 1, "corners");
        vertices.push_back(vertex);
        return static_cast<std::uint32_t>(vertices.size() - 1);
    }

    void MeshPart::closeTriangle()
    {
        const auto end = static_cast<std::uint32_t>(vertices.size());
        triangles.push_back({end - 3, end - 2, end - 1});
    }

    void MeshPart::addPolygon(const std::vector<std::uint32_t> &corners, std::size_t &work)
    {
        if (corners.size() < 3)
        {
            loose.insert(loose.end(), corners.begin(), corners.end());
            return;
        }
        std::vector<std::uint32_t> rest = corners;
        std::vector<Eigen::Vector2d> flat;
        if (rest.size() > 3)
        {
            std::vector<Eigen::Vector3d> points;
            points.reserve(rest.size());
            for (const std::uint32_t corner : rest)
                points.push_back(vertices[corner].point);
            flat = flatten(points);
        }
        // The order in which Assimp cuts: from a convex polygon it takes the fan about the last corner, of four the
        // first.
        std::size_t ear = rest.size() == 4 ? 1 : 0;
        for (std::size_t count = rest.size(); count > 3; --count)
        {
            ear %= count;
            std::size_t tries = 0;
            for (; tries < 2 * count && !isEar(flat, ear, tries < count); ++tries)
                ear = (ear + 1) % count;
            if ((work += (tries + 1) * count) > MOST_STEPS)
                throw std::runtime_error("it has polygons with too many corners");
            // A polygon that crosses itself may have no ear, and loses this corner.
            triangles.push_back({rest[(ear + count - 1) % count], rest[ear], rest[(ear + 1) % count]});
            rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
            flat.erase(flat.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        triangles.push_back({rest[0], rest[1], rest[2]});
    }

    void MeshPart::makeNormals()
    {
        for (const auto &[a, b, c] : triangles)
        {
            const Eigen::Vector3f from = vertices[a].point.cast<float>();
            const Eigen::Vector3f normal =
                (vertices[b].point.cast<float>() - from).cross(vertices[c].point.cast<float>() - from).normalized();
            for (const std::uint32_t corner : {a, b, c})
                vertices[corner].normal = normal;
        }
    }

    const std::vector<std::uint32_t> &MeshPart::getDistinct()
    {
        if (!distinct_.empty())
            return distinct_;
        if (!hasNormals)
            makeNormals();
        // In Assimp's order: the first of several that are nearly the same counts.
        std::vector<bool> isUsed(vertices.size());
        for (const TriangleMesh::Triangle &triangle : triangles)
            for (const std::uint32_t corner : triangle)
                isUsed[corner] = true;
        std::vector<std::uint32_t> used;
        for (std::uint32_t vertex = 0; vertex < vertices.size(); ++vertex)
            if (isUsed[vertex])
                used.push_back(vertex);
        std::sort(loose.begin(), loose.end());
        loose.erase(std::unique(loose.begin(), loose.end()), loose.end());
        addDistinct(used, true);
        addDistinct(loose, hasNormals);
        return distinct_;
    }

    void MeshPart::addDistinct(const std::vector<std::uint32_t> &used, bool comparesNormals)
    {
        // The first vertex of each place, and for each vertex the next one there
        std::map<std::array<float, 3>, std::uint32_t> first;
        std::vector<std::uint32_t> next(vertices.size(), NONE);
        // What is not a number is the same as all.
        const auto areSame = [&](const Vertex &a, const Vertex &b)
        {
            return !(comparesNormals && (a.normal - b.normal).squaredNorm() > SAME) &&
                   !((a.texture - b.texture).squaredNorm() > SAME);
        };
        for (const std::uint32_t vertex : used)
        {
            const Eigen::Vector3f point = vertices[vertex].point.cast<float>();
            const auto [entry, isNew] = first.try_emplace({point.x(), point.y(), point.z()}, vertex);
            std::uint32_t other = entry->second;
            for (unsigned int i = 1; !isNew && other != vertex && !areSame(vertices[other], vertices[vertex]);
                 other = next[other], ++i)
                if (next[other] == NONE || i == MOST_COMPARED)
                {
                    next[vertex] = next[other];
                    next[other] = vertex;
                }
            if (other == vertex)
                distinct_.push_back(vertex);
        }
    }

    void MeshCollector::add(MeshPart &part, const Eigen::Affine3d &transform)
    {
        checkAtMost(MOST_CORNERS, placed_ += part.vertices.size(), "corners");
        checkAtMost(MOST_TRIANGLES, triangles_.size() + part.triangles.size(), "triangles");
        std::vector<std::uint32_t> numbers(part.vertices.size(), NONE);
        for (TriangleMesh::Triangle triangle : part.triangles)
        {
            for (std::uint32_t &corner : triangle)
            {
                if (numbers[corner] == NONE)
                    numbers[corner] = numberOf(transform * part.vertices[corner].point);
                corner = numbers[corner];
            }
            triangles_.push_back(triangle);
        }
        for (const std::uint32_t vertex : part.getDistinct())
            sum_ += transform * part.vertices[vertex].point;
        count_ += part.getDistinct().size();
    }

    std::uint32_t MeshCollector::numberOf(const Eigen::Vector3d &point)
    {
        if (!isPoint(point))
            throw std::runtime_error(NO_POINT);
        const auto [entry, isNew] =
            numbers_.try_emplace({point.x(), point.y(), point.z()}, static_cast<std::uint32_t>(vertices_.size()));
        if (isNew)
            vertices_.push_back(point);
        return entry->second;
    }

    TriangleMeshPtr MeshCollector::takeMesh(const std::string &name)
    {
        if (triangles_.empty())
            throw std::runtime_error("it has no triangles");
        return std::make_shared<TriangleMesh>(std::move(vertices_), std::move(triangles_), name);
    }
}
