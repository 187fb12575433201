#ifndef OMPL_CERTIFICATES_GENERATORS_MESH_BUILDER_
#define OMPL_CERTIFICATES_GENERATORS_MESH_BUILDER_

#include "ompl_certificates/geometry/TriangleMesh.h"

#include <functional>
#include <string>

namespace generators
{
    /** \brief Makes meshes of simple parts. Coordinates are rounded to the four decimals that an OBJ file gets, so that
        what is made is what is read. */
    class MeshBuilder
    {
    public:
        /** \brief A box along the axes */
        void addBox(const Eigen::Vector3d &low, const Eigen::Vector3d &high);

        /** \brief A prism over a polygon that is seen whole from its first corner, counter-clockwise */
        void addPrism(const std::vector<Eigen::Vector2d> &polygon, double low, double high);

        /** \brief A prism with a hole: \e outer and \e inner have as many corners, each opposite to its partner */
        void addRing(const std::vector<Eigen::Vector2d> &outer, const std::vector<Eigen::Vector2d> &inner, double low,
                     double high);

        /** \brief A closed tube about the closed curve \e center of a parameter from 0 to 1 */
        void addTube(const std::function<Eigen::Vector3d(double)> &center, double radius, unsigned int segments,
                     unsigned int sides);

        /** \brief The surface z = \e height(x, y) over a square from (0, 0) to (\e size, \e size), with two triangles
            for each of \e cells x \e cells squares */
        void addTerrain(const std::function<double(double, double)> &height, double size, unsigned int cells);

        /** \brief All of it */
        ompl_certificates::TriangleMeshPtr make() const;

        /** \brief All of it as the text of an OBJ file */
        std::string toObj() const;

    private:
        std::uint32_t addVertex(const Eigen::Vector3d &point);

        /** \brief Two triangles; corners counter-clockwise seen from outside */
        void addQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);

        std::vector<Eigen::Vector3d> vertices_;
        std::vector<ompl_certificates::TriangleMesh::Triangle> triangles_;
    };
}

#endif
