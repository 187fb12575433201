#ifndef OMPL_CERTIFICATES_PICTURES_PLAN_VIEWER_
#define OMPL_CERTIFICATES_PICTURES_PLAN_VIEWER_

#include "ompl_certificates/pictures/PlanReport.h"
#include "ompl_certificates/scene/Scene.h"

#include <memory>
#include <ompl/base/PlannerData.h>
#include <ompl/control/PathControl.h>
#include <ompl/geometric/PathGeometric.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    class RobotMotion;

    /** \brief A page for browsers in which a scene can be looked at from all sides while its robots move along a path.

        The page is one HTML file with all that it needs, and opens without a network. Scenes of the plane are seen from
        above. The file has some 0.67 MB, and what the scene's meshes, cells and points take. See docs/plan-team.md. */
    class PlanViewer
    {
    public:
        /** \brief A page with the scene alone: the robots stay at their starts */
        explicit PlanViewer(const Scene &scene);

        /** \brief Let the robots move along a path of the scene's team, by stateTimes()
            \throws ompl::Exception if its states are not those of a TeamStateSpace with the scene's robots, or if it
            has none */
        void setPath(const ompl::geometric::PathGeometric &path);

        /** \brief Let the robots move along a path of controls, with the times of its controls
            \throws ompl::Exception as above */
        void setPath(const ompl::control::PathControl &path);

        /** \brief Add a planner's tree, projected to each robot's position in the workspace. Of very large trees every
            n-th edge is shown.
            \throws ompl::Exception if its states are not those of a TeamStateSpace with the scene's robots */
        void setTree(const ompl::base::PlannerData &data);

        /** \brief Add the balls that certificates prove free: the largest, but few that have nearly the same place.
            Cost: n log n for n certificates, and some hundred comparisons for each. */
        void setCertificates(const std::vector<Certificate> &certificates);

        /** \brief Add numbers about the plan, to be read beside it */
        void setReport(const PlanReport &report);

        /** \brief What the page shows, as JSON. Arrays of numbers are little-endian and in base64; see
            viewer/src/data.js. */
        std::string toJson() const;

        /** \brief The page as the text of an HTML file */
        std::string toHtml() const;

        /** \brief Write toHtml() to \e file; see writeWholeFile()
            \throws ompl::Exception that names the file if it cannot be written */
        void write(const std::string &file) const;

    private:
        /** \brief Make motions_ from states of the team
            \param times one for each state */
        void setStates(const std::vector<const ompl::base::State *> &states, const std::vector<double> &times);

        Scene scene_;
        std::vector<std::shared_ptr<const RobotMotion>> motions_;

        /** \brief For each robot: the positions of its traced body at both ends of the tree's edges */
        std::vector<std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>> edges_;
        std::vector<Certificate> certificates_;

        /** \brief A PlanReport as JSON; empty if there is none */
        std::string report_;

        /** \brief The time of the path's last state */
        double end_{0.0};
    };
}

#endif
