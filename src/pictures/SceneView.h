#ifndef OMPL_CERTIFICATES_PICTURES_SCENE_VIEW_
#define OMPL_CERTIFICATES_PICTURES_SCENE_VIEW_

#include "MeshOutline.h"
#include "SvgWriter.h"
#include "ompl_certificates/geometry/Body.h"

#include <ompl/base/spaces/RealVectorBounds.h>

namespace ompl_certificates
{
    class CellObstacles;

    /** \brief The workspace seen along one of its axes, at a position in a picture */
    class SceneView
    {
    public:
        /** \brief A view of \e bounds with axis 0 to the right and axis \e up upwards
            \param corner where the view's upper left corner is in the picture
            \param scale pixels per unit of length */
        SceneView(const ompl::base::RealVectorBounds &bounds, int up, const Eigen::Vector2d &corner, double scale);

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

        int up_;
        double left_, top_;
        Eigen::Vector2d corner_;
        double scale_;
        Eigen::Vector2d size_;
    };
}

#endif
