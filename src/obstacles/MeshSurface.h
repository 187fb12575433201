#ifndef OMPL_CERTIFICATES_OBSTACLES_MESH_SURFACE_
#define OMPL_CERTIFICATES_OBSTACLES_MESH_SURFACE_

#include "PlacedShape.h"

#include "ompl_certificates/geometry/ZInterval.h"
#include "geometry/TriangleTree.h"
#include "ompl_certificates/obstacles/Obstacles.h"

#include <memory>

namespace ompl_certificates
{
    /** \brief The triangles of the obstacles' meshes; in the plane also what robots can touch of them, seen from
        above */
    class MeshSurface
    {
    public:
        /** \param zInterval in the plane: the robots' z-interval */
        MeshSurface(const PlacedShapes &obstacles, unsigned int dimension, const ZInterval &zInterval);

        bool isEmpty() const
        {
            return triangles_->size() == 0;
        }

        /** \brief The triangles in space; an ObstaclePart is a position in this tree */
        const TriangleTree &getTriangles() const
        {
            return *triangles_;
        }

        /** \brief In the plane: the intersection of the meshes' z-interval with the robots' */
        const ZInterval &getZInterval() const
        {
            return zInterval_;
        }

        /** \brief The distance of \e point to the nearest triangle, in the plane to its outline; at most \e most */
        double distance(const Eigen::Vector3d &point, double most) const
        {
            return near().distance(point, most);
        }

        /** \brief distance(), and the nearest triangle, or NO_PART if none is nearer than \e most */
        double findNearest(const Eigen::Vector3d &point, double most, ObstaclePart &part) const;

    private:
        void project(const ZInterval &robotZInterval);

        /** \brief The tree in which distances are searched */
        const TriangleTree &near() const
        {
            return isPlanar_ ? outlines_ : *triangles_;
        }

        bool isPlanar_;

        /** \brief That of the mesh itself, if there is no other and it stands at the origin; of a large one it would take
            long to make it again */
        std::shared_ptr<const TriangleTree> triangles_;

        /** \brief In the plane: the projections, by their position in triangles_ */
        TriangleTree outlines_;
        ZInterval zInterval_;
    };
}

#endif
