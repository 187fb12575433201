#ifndef OMPL_CERTIFICATES_OBSTACLES_MESH_SURFACE_
#define OMPL_CERTIFICATES_OBSTACLES_MESH_SURFACE_

#include "PlacedShape.h"

#include "ompl_certificates/geometry/ZInterval.h"
#include "ompl_certificates/geometry/TriangleTree.h"
#include "ompl_certificates/obstacles/Obstacles.h"

namespace ompl_certificates
{
    /** \brief The triangles of the obstacles' meshes, and in the plane what robots can touch of them, seen from above */
    class MeshSurface
    {
    public:
        /** \param zInterval in the plane: how far up and down the robots reach */
        MeshSurface(const PlacedShapes &obstacles, unsigned int dimension, const ZInterval &zInterval);

        bool isEmpty() const
        {
            return triangles_.size() == 0;
        }

        /** \brief The triangles in space; an ObstaclePart is a position in it */
        const TriangleTree &getTriangles() const
        {
            return triangles_;
        }

        /** \brief In the plane: what the meshes have in common with the robots' heights */
        const ZInterval &getZInterval() const
        {
            return zInterval_;
        }

        /** \brief The distance of \e point to the nearest triangle, or its outline in the plane, if less than \e most; else
            \e most */
        double distance(const Eigen::Vector3d &point, double most) const
        {
            return near().distance(point, most);
        }

        /** \brief distance(), and the triangle that is nearest, or NO_PART if none is nearer than \e most */
        double findNearest(const Eigen::Vector3d &point, double most, ObstaclePart &part) const;

    private:
        void project(const ZInterval &robotZInterval);

        /** \brief The tree that distances are found in */
        const TriangleTree &near() const
        {
            return isPlanar_ ? outlines_ : triangles_;
        }

        bool isPlanar_;
        TriangleTree triangles_;

        /** \brief In the plane: the projections, by their position in triangles_ */
        TriangleTree outlines_;
        ZInterval zInterval_;
    };
}

#endif
