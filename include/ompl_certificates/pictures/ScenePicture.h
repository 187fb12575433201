#ifndef OMPL_CERTIFICATES_PICTURES_SCENE_PICTURE_
#define OMPL_CERTIFICATES_PICTURES_SCENE_PICTURE_

#include "ompl_certificates/scene/Scene.h"

#include <ompl/base/PlannerData.h>
#include <ompl/control/PathControl.h>
#include <ompl/geometric/PathGeometric.h>
#include <string>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    class SceneView;
    class SvgWriter;

    /** \brief A picture of a scene, and of a planner's results in it, as SVG.

        Every robot has a color. Its start is its body within a circle, its goal the outline of its body with a cross.
        Along a path arrows show the direction, and numbers where the robots are at equal times. Axes have the scene's
        unit. Scenes in space are seen from above (x to the right, y up), from the side (x to the right, z up) and from
        a corner. Obstacles end at the frame. */
    class ScenePicture
    {
    public:
        /** \brief A picture of \e scene alone */
        explicit ScenePicture(const Scene &scene);

        /** \brief Add a path of the scene's team, with the bodies at equal times. The times are those of stateTimes().
            \throws ompl::Exception if its states are not those of a TeamStateSpace with the scene's robots */
        void setPath(const ompl::geometric::PathGeometric &path);

        /** \brief The same, with the time of each state: finite, none less than the one before
            \throws ompl::Exception also if there are not as many times as states */
        void setPath(const ompl::geometric::PathGeometric &path, const std::vector<double> &times);

        /** \brief Add a path of controls, with the bodies at equal times
            \throws ompl::Exception as the first one */
        void setPath(const ompl::control::PathControl &path);

        /** \brief Add a planner's tree, projected to each robot's position in the workspace. Of very large trees every
            n-th edge is drawn.
            \throws ompl::Exception if its states are not those of a TeamStateSpace with the scene's robots */
        void setTree(const ompl::base::PlannerData &data);

        /** \brief Add the balls that certificates prove free. Of very many in the plane every n-th is drawn. In space
            only the largest are, and none whose point is within a larger one that is drawn. */
        void setCertificates(const std::vector<Certificate> &certificates);

        /** \brief The picture as the text of an SVG file */
        std::string toSvg() const;

        /** \brief Write toSvg() to \e file; see writeWholeFile()
            \throws ompl::Exception that names the file if it cannot be written */
        void write(const std::string &file) const;

    private:
        /** \brief The poses of a robot's bodies */
        using BodyPoses = std::vector<Pose>;

        void drawTree(SvgWriter &svg, const SceneView &view) const;
        void drawBodies(SvgWriter &svg, const SceneView &view) const;
        void drawLines(SvgWriter &svg, const SceneView &view) const;
        void drawMarks(SvgWriter &svg, const SceneView &view) const;
        void drawStarts(SvgWriter &svg, const SceneView &view) const;
        void drawCertificates(SvgWriter &svg, const SceneView &view) const;

        Scene scene_;

        /** For each robot: the line that its traced body follows, */
        std::vector<std::vector<Eigen::Vector3d>> lines_;

        /** and its poses at equal times */
        std::vector<std::vector<BodyPoses>> poses_;

        /** For each robot: the positions of its traced body at both ends of the tree's edges */
        std::vector<std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>> edges_;
        std::vector<Certificate> certificates_;
    };
}

#endif
