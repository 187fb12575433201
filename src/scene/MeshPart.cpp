#include "MeshPart.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::uint32_t NONE = 0xFFFFFFFFU;
        constexpr std::size_t MOST_STEPS = 300000000;
        /** Of vertices at one place no more than so many are compared: else a fan of n triangles would take n² steps. */
        constexpr unsigned int MOST_COMPARED = 300;
        /** Assimp takes normals and textures whose distance is smaller for the same. */
        constexpr float SAME = 1e-5F;

        [[noreturn]] void failAtMost(std::size_t most, const std::string &what)
        {
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
            for (std::size_t i = 0; i < points.size(); ++i)
                normal += (points[i] - points[0]).cross(points[(i + 1) % points.size()] - points[0]);
            Eigen::Index axis;
            normal.cwiseAbs().maxCoeff(&axis);
            Eigen::Index x = (axis + 1) % 3, y = (axis + 2) % 3;
            if (normal[axis] < 0.0)
                std::swap(x, y);
            std::vector<Eigen::Vector2d> flat;
            for (const Eigen::Vector3d &point : points)
                flat.emplace_back(point[x], point[y]);
            return flat;
        }

        /** Whether the corner \e ear of a polygon can be cut off: it is convex, and no other corner lies within */
        bool isEar(const std::vector<Eigen::Vector2d> &corners, std::size_t ear)
        {
            const std::size_t count = corners.size();
            const Eigen::Vector2d &a = corners[(ear + count - 1) % count], &b = corners[ear],
                                  &c = corners[(ear + 1) % count];
            return area(a, b, c) >= 0.0 && std::none_of(corners.begin(), corners.end(),
                                                        [&](const Eigen::Vector2d &point)
                                                        {
                                                            return area(a, b, point) > 0.0 &&
                                                                   area(b, c, point) > 0.0 && area(c, a, point) > 0.0;
                                                        });
        }
    }

    std::uint32_t MeshPart::addVertex(const Vertex &vertex)
    {
        vertices_.push_back(vertex);
        kinds_.push_back(0);
        return static_cast<std::uint32_t>(vertices_.size() - 1);
    }

    void MeshPart::addPolygon(const std::vector<std::uint32_t> &corners, std::size_t &work)
    {
        if (corners.size() < 3)
        {
            for (const std::uint32_t corner : corners)
                use(corner, corners.size() == 1 ? POINT : LINE);
            return;
        }
        std::vector<std::uint32_t> rest = corners;
        std::vector<Eigen::Vector3d> points;
        std::vector<Eigen::Vector2d> flat;
        if (rest.size() > 3)
        {
            for (const std::uint32_t corner : rest)
                points.push_back(getPoint(corner));
            flat = flatten(points);
        }
        // The order in which Assimp cuts: from a convex polygon it takes the fan about the last corner, of four the first.
        for (std::size_t ear = rest.size() == 4 ? 1 : 0; rest.size() > 3;)
        {
            const std::size_t count = rest.size();
            std::size_t tries = 0;
            for (; tries < count && !isEar(flat, ear); ++tries)
                ear = (ear + 1) % count;
            if ((work += (tries + 1) * count) > MOST_STEPS)
                throw std::runtime_error("it has polygons with too many corners");
            // A polygon that crosses itself may have no ear, and loses this corner.
            addTriangle(rest[(ear + count - 1) % count], rest[ear], rest[(ear + 1) % count]);
            rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
            flat.erase(flat.begin() + static_cast<std::ptrdiff_t>(ear));
            ear %= rest.size();
        }
        addTriangle(rest[0], rest[1], rest[2]);
    }

    void MeshPart::addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        triangles_.push_back({a, b, c});
        for (const std::uint32_t corner : triangles_.back())
            use(corner, TRIANGLE);
    }

    void MeshPart::makeNormals()
    {
        for (const auto &[a, b, c] : triangles_)
        {
            const Eigen::Vector3f from = getPoint(a).cast<float>();
            const Eigen::Vector3f normal =
                (getPoint(b).cast<float>() - from).cross(getPoint(c).cast<float>() - from).normalized();
            for (const std::uint32_t corner : {a, b, c})
                vertices_[corner].normal = normal;
        }
    }

    const std::vector<std::uint32_t> &MeshPart::getDistinct()
    {
        if (!distinct_.empty())
            return distinct_;
        if (!hasNormals)
            makeNormals();
        for (const Kind kind : {POINT, LINE, TRIANGLE})
            addDistinct(kind);
        return distinct_;
    }

    void MeshPart::addDistinct(Kind kind)
    {
        // The first vertex of each place, and for each vertex the next one there
        std::unordered_map<std::array<float, 3>, std::uint32_t, PointHash> first;
        std::vector<std::uint32_t> next(vertices_.size(), NONE);
        const bool comparesNormals = hasNormals || kind == TRIANGLE;
        const auto areSame = [&](const Vertex &a, const Vertex &b)
        {
            // Not a number is the same as all.
            return !(comparesNormals && (a.normal - b.normal).squaredNorm() > SAME * SAME) &&
                   !((a.texture - b.texture).squaredNorm() > SAME * SAME);
        };
        for (std::uint32_t vertex = 0; vertex < vertices_.size(); ++vertex)
        {
            if ((kinds_[vertex] & kind) == 0)
                continue;
            const Eigen::Vector3f point = getPoint(vertex).cast<float>();
            const auto [entry, isNew] = first.try_emplace({point.x(), point.y(), point.z()}, vertex);
            std::uint32_t other = entry->second;
            for (unsigned int i = 1; !isNew && !areSame(vertices_[other], vertices_[vertex]); ++i, other = next[other])
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
        if ((placed_ += part.size()) > MOST_CORNERS)
            failAtMost(MOST_CORNERS, "vertices");
        if (triangles_.size() + part.getTriangles().size() > MOST_TRIANGLES)
            failAtMost(MOST_TRIANGLES, "triangles");
        std::vector<std::uint32_t> numbers(part.size(), NONE);
        for (TriangleMesh::Triangle triangle : part.getTriangles())
        {
            for (std::uint32_t &corner : triangle)
            {
                if (numbers[corner] == NONE)
                    numbers[corner] = numberOf(transform * part.getPoint(corner));
                corner = numbers[corner];
            }
            triangles_.push_back(triangle);
        }
        for (const std::uint32_t vertex : part.getDistinct())
            sum_ += transform * part.getPoint(vertex);
        count_ += part.getDistinct().size();
    }

    std::uint32_t MeshCollector::numberOf(const Eigen::Vector3d &point)
    {
        // Not a number is not smaller either.
        if (!(point.cwiseAbs().maxCoeff() <= MOST_COORDINATE))
            throw std::runtime_error("it has a vertex whose coordinates are not finite numbers of at most 1e9");
        const auto [entry, isNew] =
            numbers_.try_emplace({point.x(), point.y(), point.z()}, static_cast<std::uint32_t>(vertices_.size()));
        if (isNew)
            vertices_.push_back(point);
        return entry->second;
    }

    TriangleMeshPtr MeshCollector::takeMesh()
    {
        if (triangles_.empty())
            throw std::runtime_error("it has no triangles");
        return std::make_shared<TriangleMesh>(std::move(vertices_), std::move(triangles_));
    }
}
