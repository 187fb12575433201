#ifndef OMPL_CERTIFICATES_SCENE_MESH_FILE_
#define OMPL_CERTIFICATES_SCENE_MESH_FILE_

#include "ompl_certificates/geometry/Body.h"
#include "ompl_certificates/geometry/TriangleMesh.h"

#include <string>

namespace ompl_certificates
{
    /** \brief The triangles of a mesh file: COLLADA (.dae), STL, OBJ or PLY.

        All meshes of the file are taken together, where its nodes place them. COLLADA files are brought to meters, by
        the unit that they state, and to the y axis up, as OMPL.app does it. Files of the other kinds are taken as they
        are. Polygons are cut into triangles; lines and points, bones, animations and materials are left out. Open
        meshes, triangles given twice and triangles without area are normal. Other files that a file names are not
        opened. */
    class MeshFile
    {
    public:
        /** \brief Read \e file. Takes some milliseconds, and about a second for a million triangles.
            \param file the mesh file
            \param keepsAxes whether the axes of a COLLADA file stay as they are, whichever it says is up. So do ROS and
            MoveIt read the meshes of robots.
            \throws ompl::Exception that names the file, the line, byte or element, and the reason: if it cannot be
            read, is not a mesh, or is not what its counts say. A file without triangles, with more than 5 million of
            them, or with a coordinate that is not finite or beyond 1e9 is refused, too. */
        explicit MeshFile(const std::string &file, bool keepsAxes = false);

        /** \brief The file */
        const std::string &getName() const
        {
            return name_;
        }

        /** \brief The triangles, in the file's own frame */
        const TriangleMeshPtr &getMesh() const
        {
            return mesh_;
        }

        /** \brief The mean of the file's vertices, in the file's own frame: what OMPL.app takes for the reference point
            of a robot. A vertex counts once for each normal and texture coordinate that it has in a part of the
            file, those of lines and points too. So often does Assimp, by which OMPL.app reads files, keep it. */
        const Eigen::Vector3d &getMean() const
        {
            return mean_;
        }

        /** \brief A copy of the mesh with all vertices moved by \e transform, which may scale */
        TriangleMeshPtr transformed(const Eigen::Affine3d &transform) const;

        /** \brief An obstacle, in the file's own frame
            \param dimension 2 for a planar team: the mesh keeps its z */
        Body makeObstacle(unsigned int dimension) const;

        /** \brief A robot by the conventions of OMPL.app: the origin of the body's frame, whose position a state gives,
            is at getMean(), in the plane at its x and y
            \param dimension 2 for a planar team: the mesh keeps its z */
        Body makeRobot(unsigned int dimension) const;

    private:
        std::string name_;
        TriangleMeshPtr mesh_;
        Eigen::Vector3d mean_;
    };
}

#endif
