#ifndef OMPL_CERTIFICATES_SCENE_MESH_PART_
#define OMPL_CERTIFICATES_SCENE_MESH_PART_

#include "ompl_certificates/geometry/TriangleMesh.h"

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace ompl_certificates
{
    /** \brief The most triangles that a file of meshes may have, and the most corners of its polygons */
    constexpr std::size_t MOST_TRIANGLES = 5000000, MOST_CORNERS = 3 * MOST_TRIANGLES;

    /** \brief The largest coordinate that a file of meshes may have */
    constexpr double MOST_COORDINATE = 1e9;

    /** \brief A hash of a point, the same for equal ones */
    struct PointHash
    {
        template <typename T>
        std::size_t operator()(const std::array<T, 3> &point) const
        {
            std::size_t hash = 0;
            for (const T coordinate : point)
                hash = (hash ^ std::hash<T>()(coordinate)) * 0x9E3779B97F4A7C15U;
            return hash ^ hash >> 32U;
        }
    };

    /** \brief A part of a mesh file that has vertices of its own: an OBJ group, the solid of an STL file, or a primitive
        of COLLADA. Its polygons are cut into triangles. */
    class MeshPart
    {
    public:
        /** \brief A vertex with what tells it from others at the same place */
        struct Vertex
        {
            Eigen::Vector3d point;
            Eigen::Vector3f normal{Eigen::Vector3f::Zero()};
            Eigen::Vector3f texture{Eigen::Vector3f::Zero()};
        };

        /** \brief What the primitives of a vertex are */
        enum Kind : unsigned char
        {
            POINT = 1,
            LINE = 2,
            TRIANGLE = 4
        };

        /** \brief Whether normals are given. Otherwise each triangle gives its own to its vertices. */
        bool hasNormals{false};

        /** \brief Add a vertex, and return its number. */
        std::uint32_t addVertex(const Vertex &vertex);

        /** \brief Add a triangle between vertices. */
        void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

        /** \brief Add a polygon between vertices, which may be concave; with two or one it is a line or a point.
            \param work counts the steps of cutting polygons in the whole file
            \throws std::runtime_error if polygons need too many steps */
        void addPolygon(const std::vector<std::uint32_t> &corners, std::size_t &work);

        /** \brief Say what \e vertex is used for, other than as a corner of a polygon. */
        void use(std::uint32_t vertex, Kind kind)
        {
            kinds_[vertex] |= kind;
        }

        /** \brief The number of vertices */
        std::size_t size() const
        {
            return vertices_.size();
        }

        /** \brief A vertex's place */
        const Eigen::Vector3d &getPoint(std::uint32_t vertex) const
        {
            return vertices_[vertex].point;
        }

        /** \brief The triangles between the vertices */
        const std::vector<TriangleMesh::Triangle> &getTriangles() const
        {
            return triangles_;
        }

        /** \brief The vertices that Assimp, whose mean OMPL.app takes, keeps after joining equal ones: those at one place,
            as floats, whose normals and textures are nearly the same. Asked for once all is added. */
        const std::vector<std::uint32_t> &getDistinct();

    private:
        void makeNormals();
        void addDistinct(Kind kind);

        std::vector<Vertex> vertices_;
        /** For each vertex a sum of kinds */
        std::vector<unsigned char> kinds_;
        std::vector<TriangleMesh::Triangle> triangles_;
        std::vector<std::uint32_t> distinct_;
    };

    /** \brief Puts the parts of a file together. */
    class MeshCollector
    {
    public:
        /** \brief Add \e part, moved by \e transform.
            \throws std::runtime_error if a coordinate is too large, or if there are too many vertices or triangles */
        void add(MeshPart &part, const Eigen::Affine3d &transform = Eigen::Affine3d::Identity());

        /** \brief All triangles; equal vertices are one. Once, at the end.
            \throws std::runtime_error if there are none */
        TriangleMeshPtr takeMesh();

        /** \brief The mean of the distinct vertices of all parts */
        Eigen::Vector3d getMean() const
        {
            return sum_ / static_cast<double>(count_);
        }

        /** \brief The steps that were needed to cut polygons */
        std::size_t work{0};

    private:
        std::uint32_t numberOf(const Eigen::Vector3d &point);

        std::vector<Eigen::Vector3d> vertices_;
        std::vector<TriangleMesh::Triangle> triangles_;
        std::unordered_map<std::array<double, 3>, std::uint32_t, PointHash> numbers_;
        Eigen::Vector3d sum_{Eigen::Vector3d::Zero()};
        std::size_t count_{0}, placed_{0};
    };
}

#endif
