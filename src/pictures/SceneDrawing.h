#ifndef OMPL_CERTIFICATES_SRC_PICTURES_SCENE_DRAWING_
#define OMPL_CERTIFICATES_SRC_PICTURES_SCENE_DRAWING_

#include "SceneView.h"
#include "ompl_certificates/scene/Scene.h"

#include <functional>
#include <ompl/base/PlannerData.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>
#include <string>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    /** \brief The poses of a robot's bodies */
    using BodyPoses = std::vector<Pose>;

    /** \brief Lines in the workspace, by their two ends */
    using Segments = std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>;

    /** \brief What all pictures of a scene have in common: views, obstacles, goals and a legend, and how a team's
        states are read. Spatial scenes have views from above and from the side, and pictures that do not move an
        oblique one. */
    class SceneDrawing
    {
    public:
        /** \brief Something that is explained in the legend, and a function that draws it at a position */
        using Symbol = std::pair<std::string, std::function<void(SvgWriter &, const Eigen::Vector2d &)>>;

        /** \brief Draws what one view shows, the scene's obstacles included */
        using Content = std::function<void(SvgWriter &, const SceneView &)>;

        /** \brief \e scene must outlive this */
        explicit SceneDrawing(const Scene &scene) : scene_(scene)
        {
        }

        /** \brief The color of a robot; after 18 they repeat */
        static std::string colorOf(std::size_t robot);

        /** \brief The symbol of goals */
        static Symbol goalSymbol();

        /** \brief The attribute of a group that ends at the frame of \e view */
        static std::string clipAtFrame(const SceneView &view);

        /** \brief Draw bodies that have their poses, but no obstacles */
        static void drawBodies(SvgWriter &svg, const SceneView &view, const Robot &robot, const BodyPoses &poses);

        /** \brief Draw what paddings add to bodies, see Body::padded(): a pale edge. Draw the bodies over it. */
        static void drawPaddings(SvgWriter &svg, const SceneView &view, const Robot &robot, const BodyPoses &poses,
                                 const std::string &color);

        /** \brief The attributes of a group in which bodies are drawn as the edge that a padding adds to them
            \param width how wide the edge is, in pixels */
        static std::string paddingStyle(const std::string &color, double width);

        /** \brief Require that \e space is the space of the scene's robots
            \throws ompl::Exception if not */
        void requireTeam(const ompl::base::StateSpacePtr &space) const;

        /** \brief The states of a path of the scene's team
            \throws ompl::Exception if it is of another team, or has no states */
        template <typename Path>
        std::vector<const ompl::base::State *> statesOf(const Path &path) const
        {
            requireTeam(path.getSpaceInformation()->getStateSpace());
            std::vector<const ompl::base::State *> states(path.getStateCount());
            for (unsigned int i = 0; i < states.size(); ++i)
                states[i] = path.getState(i);
            if (states.empty())
                throw ompl::Exception(scene_.getSource(), "a path without states cannot be shown");
            return states;
        }

        /** \brief The poses of each robot at a state of the team */
        std::vector<BodyPoses> posesOf(const ompl::base::State *state) const;

        /** \brief Where a robot is whose bodies have those poses: the origin of its traced body */
        Eigen::Vector3d pointOf(std::size_t robot, const BodyPoses &poses) const;

        /** \brief The edges of a planner's tree, for each robot, where pointOf() is at both ends. Of very large trees
            every n-th edge is taken.
            \throws ompl::Exception if its states are not those of the scene's robots */
        std::vector<Segments> edgesOf(const ompl::base::PlannerData &tree) const;

        /** \brief The poses of each robot at its start; empty if there are no robots */
        std::vector<BodyPoses> getStarts() const;

        /** \brief The poses of each robot at its goal; empty if there are no robots */
        std::vector<BodyPoses> getGoals() const;

        /** \brief Draw the obstacles, and zones in the color of the robot that they keep out */
        void drawObstacles(SvgWriter &svg, const SceneView &view) const;

        /** \brief Draw outlines and crosses at the goals */
        void drawGoals(SvgWriter &svg, const SceneView &view) const;

        /** \brief Write a robot's number beside \e center, if there are more robots than colors */
        void drawNumber(SvgWriter &svg, const SceneView &view, const Eigen::Vector2d &center, std::size_t robot) const;

        /** \brief The whole picture, as the text of an SVG file
            \param oblique whether a spatial scene has an oblique view, too */
        std::string toSvg(const Content &content, const std::vector<Symbol> &symbols, bool oblique) const;

    private:
        void drawZones(SvgWriter &svg, const SceneView &view) const;

        /** \brief The views of the scene, each at its position below \e top */
        std::vector<SceneView> placeViews(double top, bool oblique) const;

        /** \brief A robot's number as it is written, such as #20; empty if colors are enough to tell robots apart */
        std::string numberOf(std::size_t robot) const;

        /** \brief Draw the legend, and return its lower right corner. Many robots are in columns, so that it is not much
            higher than \e height. */
        Eigen::Vector2d drawLegend(SvgWriter &svg, const Eigen::Vector2d &corner, double height,
                                   const std::vector<Symbol> &symbols) const;

        /** \brief The same for the robots alone */
        Eigen::Vector2d drawRobotNames(SvgWriter &svg, const Eigen::Vector2d &corner, std::size_t rows) const;

        const Scene &scene_;
    };
}

#endif
