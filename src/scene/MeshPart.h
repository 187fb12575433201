#ifndef OMPL_CERTIFICATES_SCENE_MESH_PART_
#define OMPL_CERTIFICATES_SCENE_MESH_PART_

#include "ompl_certificates/geometry/TriangleMesh.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief The most triangles that a file of meshes may have, and the most corners of its faces */
    constexpr std::size_t MOST_TRIANGLES = 5000000, MOST_CORNERS = 3 * MOST_TRIANGLES;

    /** \brief Whether a file of meshes may have such a point: its coordinates are finite numbers of at most 1e9 */
    inline bool isPoint(const Eigen::Vector3d &point)
    {
        return (point.array().abs() <= 1e9).all();
    }

    /** \brief What is wrong with a file that has other points */
    constexpr const char *NO_POINT = "a vertex has a coordinate that is not a finite number of at most 1e9";

    /** \brief A part of a mesh file that has vertices of its own: an OBJ group, the solid of an STL file, or a
        primitive of COLLADA */
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

        /** \brief Whether normals are given. Otherwise each triangle gives its own to its vertices. */
        bool hasNormals{false};

        /** \brief All vertices */
        std::vector<Vertex> vertices;

        /** \brief Their triangles */
        std::vector<TriangleMesh::Triangle> triangles;

        /** \brief The vertices of lines and points */
        std::vector<std::uint32_t> loose;

        /** \brief Add a vertex. \return its number
            \throws std::runtime_error if there are too many */
        std::uint32_t add(const Vertex &vertex);

        /** \brief Add a triangle between the last three vertices. */
        void closeTriangle();

        /** \brief Add a polygon, which may be concave, cut into triangles; with two corners or one it is a line or a
            point.
            \param work counts the steps of cutting polygons in the whole file
            \throws std::runtime_error if polygons need too many steps */
        void addPolygon(const std::vector<std::uint32_t> &corners, std::size_t &work);

        /** \brief The vertices that Assimp, whose mean OMPL.app takes, keeps after joining equal ones: those at one
            place, as floats, whose normals and textures are nearly the same. Asked for once all is added. */
        const std::vector<std::uint32_t> &getDistinct();

    private:
        void makeNormals();
        void addDistinct(const std::vector<std::uint32_t> &used, bool comparesNormals);

        std::vector<std::uint32_t> distinct_;
    };

    /** \brief Puts the parts of a file together. */
    class MeshCollector
    {
    public:
        /** \brief Add \e part, moved by \e transform.
            \throws std::runtime_error if a coordinate becomes too large, or if there is too much */
        void add(MeshPart &part, const Eigen::Affine3d &transform = Eigen::Affine3d::Identity());

        /** \brief All triangles; equal vertices are one. Once, at the end.
            \param name what warnings call the mesh
            \throws std::runtime_error if there are none */
        TriangleMeshPtr takeMesh(const std::string &name);

        /** \brief The mean of the distinct vertices of all parts */
        Eigen::Vector3d getMean() const
        {
            return sum_ / static_cast<double>(count_);
        }

        /** \brief The steps that were needed to cut polygons */
        std::size_t work{0};

        /** \brief Whether axes stay as they are in the file, whichever it says is up */
        bool keepsAxes{false};

    private:
        std::uint32_t numberOf(const Eigen::Vector3d &point);

        std::vector<Eigen::Vector3d> vertices_;
        std::vector<TriangleMesh::Triangle> triangles_;
        std::map<std::array<double, 3>, std::uint32_t> numbers_;
        Eigen::Vector3d sum_{Eigen::Vector3d::Zero()};
        std::size_t count_{0}, placed_{0};
    };
}

#endif
