#ifndef OMPL_CERTIFICATES_PICTURES_PLAN_ANIMATION_
#define OMPL_CERTIFICATES_PICTURES_PLAN_ANIMATION_

#include "ompl_certificates/scene/Scene.h"

#include <memory>
#include <ompl/control/PathControl.h>
#include <ompl/geometric/PathGeometric.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    class RobotMotion;
    class SceneView;
    class SvgWriter;

    /** \brief A picture of a scene in which its robots move along a path, again and again, as SVG with animations
        (SMIL). Browsers play it; other viewers show the start.

        Robots move by stateTimes(). In the plane the motion is exact to a fraction of a pixel. In space, seen from
        above and from the side, positions are, too; outlines of bodies that turn change several times a second. */
    class PlanAnimation
    {
    public:
        /** \brief An animation of a path of the scene's team
            \throws ompl::Exception if its states are not those of a TeamStateSpace with the scene's robots, or if it
            has none */
        PlanAnimation(const Scene &scene, const ompl::geometric::PathGeometric &path);

        /** \brief An animation of a path by controls, whose robots move as these move them
            \throws ompl::Exception as for other paths, and as pathSteps() does */
        PlanAnimation(const Scene &scene, const ompl::control::PathControl &path);

        /** \brief Set how long the robots move, in seconds of the viewer; then they rest at their goals for a second.
            10 by default.
            \throws ompl::Exception if it is not above 0 and at most 3600 */
        void setDuration(double seconds);

        /** \brief The animation as the text of an SVG file */
        std::string toSvg() const;

        /** \brief Write toSvg() to \e file; see writeWholeFile()
            \throws ompl::Exception that names the file if it cannot be written */
        void write(const std::string &file) const;

    private:
        /** \brief When something happens, as a fraction of the whole animation */
        double fractionOf(double time) const;

        /** \brief Draw a moving body */
        void drawBody(SvgWriter &svg, const SceneView &view, std::size_t robot, std::size_t body) const;

        /** \brief Draw a body of a spatial scene, as it turns, at the origin of \e view */
        void drawTurning(SvgWriter &svg, const SceneView &view, std::size_t robot, std::size_t body) const;

        Scene scene_;
        std::vector<std::shared_ptr<const RobotMotion>> motions_;
        /** \brief The time of the path's last state */
        double end_;
        double seconds_{10.0};
    };
}

#endif
