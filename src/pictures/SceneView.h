#ifndef OMPL_CERTIFICATES_PICTURES_SCENE_VIEW_
#define OMPL_CERTIFICATES_PICTURES_SCENE_VIEW_

#include "MeshOutline.h"
#include "SvgWriter.h"
#include "ompl_certificates/geometry/Body.h"

#include <array>
#include <ompl/base/spaces/RealVectorBounds.h>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    class CellObstacles;
    struct CellBox;

    /** \brief The workspace seen from far away, at a position in a picture */
    class SceneView
    {
    public:
        /** \brief Where it is seen from */
        enum class From
        {
            /// From above: x to the right, y up. Scenes of the plane have no other view.
            ABOVE,
            /// From the side: x to the right, z up.
            SIDE,
            /// From above the corner where x is large and y is small.
            OBLIQUE
        };

        /** \brief A view of \e bounds
            \param corner where the view's upper left corner is in the picture
            \param scale pixels per unit of length */
        SceneView(const ompl::base::RealVectorBounds &bounds, From from, const Eigen::Vector2d &corner, double scale);

        /** \brief Where it is seen from */
        From getFrom() const
        {
            return from_;
        }

        /** \brief The corners of the outline of the bounds, which are larger by \e edge pixels */
        std::vector<Eigen::Vector2d> getFrame(double edge = 0.0) const;

        /** \brief The edges of the bounds */
        std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> getEdges() const;

        /** \brief What is seen of the workspace */
        const ompl::base::RealVectorBounds &getBounds() const
        {
            return bounds_;
        }

        /** \brief The size of the view in pixels */
        const Eigen::Vector2d &getSize() const
        {
            return size_;
        }

        /** \brief The upper left corner of the view */
        const Eigen::Vector2d &getCorner() const
        {
            return corner_;
        }

        /** \brief Pixels per unit of length */
        double getScale() const
        {
            return scale_;
        }

        /** \brief Where \e point of the workspace is in the picture */
        Eigen::Vector2d project(const Eigen::Vector3d &point) const;

        /** \brief A view of the same kind for what is within \e radius of the workspace's origin, which is at the
            origin of the picture */
        SceneView aroundOrigin(double radius) const;

        /** \brief The closed lines around what is seen of a part of a body at \e pose; inner lines are holes */
        std::vector<MeshOutline::Loop> outlineOf(const Body::Part &part, const Pose &pose) const;

        /** \brief Draw the outline of \e body at \e pose, each shape separately
            \param zInterval of planar meshes only the triangles that overlap it are drawn
            \param levels how many outlines a mesh gets: the whole, then parts nearer and nearer to the viewer */
        void draw(SvgWriter &svg, const Body &body, const Pose &pose, const ZInterval &zInterval = ZInterval(),
                  int levels = 1) const;

        /** \brief Draw occupied cells: the whole, then parts nearer and nearer to the viewer */
        void draw(SvgWriter &svg, const CellObstacles &cells, int levels) const;

    private:
        /** \brief Outlines of a mesh: the whole, then parts nearer and nearer to the viewer. None if it is out of
            view. */
        std::vector<std::vector<MeshOutline::Loop>> outlinesOf(const TriangleMesh &mesh, const Pose &pose,
                                                               const ZInterval &zInterval, int levels) const;

        /** \brief The outline of a shape that is not a mesh, hence convex */
        MeshOutline::Loop outlineOf(const Shape &shape, const Pose &pose) const;

        /** \brief Outlines of triangles, as of a mesh
            \param seen the corners: x and y in the picture, and how near they are to the viewer */
        std::vector<std::vector<MeshOutline::Loop>> outlinesOf(const std::vector<std::array<Eigen::Vector3d, 3>> &seen,
                                                               int levels) const;

        /** \brief Add the faces of a cell that look at the viewer to \e seen */
        void addFaces(const Eigen::AlignedBox3d &box, std::vector<std::array<Eigen::Vector3d, 3>> &seen) const;

        /** \brief Draw the first of \e outlines, and lightly the others over it. */
        static void drawLevels(SvgWriter &svg, const std::vector<std::vector<MeshOutline::Loop>> &outlines);

        /** \brief Where \e point is in the picture, and how near it is to the viewer */
        Eigen::Vector3d see(const Eigen::Vector3d &point) const;

        /** \brief The eight corners of the bounds, those of a plane twice. Bit i of an index tells whether axis i is
            high. */
        std::array<Eigen::Vector3d, 8> cornersOf(double edge) const;

        From from_;
        ompl::base::RealVectorBounds bounds_;
        /** Unit vectors to the right, upwards and towards the viewer, as rows */
        Eigen::Matrix3d axes_;
        double left_, top_;
        Eigen::Vector2d corner_;
        double scale_;
        Eigen::Vector2d size_;
        /** How many cells an outline is found on at most, along an edge: what is larger is drawn more coarsely. */
        double mostCells_{2000.0};
    };
}

#endif
