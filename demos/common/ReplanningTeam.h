#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_REPLANNING_TEAM_
#define OMPL_CERTIFICATES_DEMOS_COMMON_REPLANNING_TEAM_

#include "ompl_certificates/planning/TeamSetup.h"

#include <deque>
#include <ompl/base/ScopedState.h>
#include <string>
#include <vector>

namespace demos
{
    /** \brief A team that follows its path while the obstacles change, and plans anew where a change blocks it. */
    class ReplanningTeam
    {
    public:
        /** \brief What the team knows of the obstacles when they have changed */
        enum Way
        {
            /// Certificates are kept, and repaired by the change.
            KEPT,
            /// A new checker makes new certificates.
            FRESH,
            /// The standard check, without certificates.
            STANDARD
        };

        /** \brief How the team plans */
        struct Settings
        {
            /** \brief The range and most iterations of RRTConnect. OMPL's own range, a fifth of the team's space, would
                mostly lead through an obstacle. */
            double range{4.0};
            std::uint64_t iterations{20000};

            /** \brief How far robots go from frame to frame, in the distance of their spaces, at speed 1 */
            double step{0.1};

            /** \brief See ompl_certificates::TeamValidityChecker::setAdaptive() */
            bool adaptive{true};
        };

        /** \brief What a frame took, and what it led to */
        struct Frame
        {
            /** \brief The time of the change itself: repair, or a new checker; of asking whether the path is still
                valid; and of a new plan, if it was not */
            double changeSeconds{0.0}, pathSeconds{0.0}, planSeconds{0.0};

            /** \brief The part of planSeconds that was spent in checks */
            double planCheckingSeconds{0.0};

            /** \brief Robots at states for which the obstacles were asked */
            std::uint64_t asked{0};

            /** \brief The motions of the path that are no longer valid, by number */
            std::vector<std::size_t> invalid;

            /** \brief Whether a new plan was made or tried, and whether there is a path to the goal now */
            bool planned{false}, hasPath{false};

            /** \brief The change, the path and the checks of planning */
            double checkingSeconds() const
            {
                return changeSeconds + pathSeconds + planCheckingSeconds;
            }

            /** \brief The change, the path and all of planning */
            double totalSeconds() const
            {
                return changeSeconds + pathSeconds + planSeconds;
            }
        };

        /** \brief A team at \e start that stands among \e obstacles and shall go to \e goal */
        ReplanningTeam(Way way, const ompl_certificates::TeamStateSpacePtr &team,
                       const ompl_certificates::ObstaclesPtr &obstacles, const ompl::base::ScopedState<> &start,
                       const ompl::base::ScopedState<> &goal, const Settings &settings);

        /** \brief The obstacles have changed: see whether the path is still valid, and plan if not. With equal seeds,
            all ways come to the same. */
        Frame meet(const ompl_certificates::ObstacleChange &change, std::uint64_t seed);

        /** \brief Go on along the path, if there is one. At the goal the team turns back to where it started. */
        void moveOn();

        /** \brief Where the team is, and where it will be frame by frame */
        const std::deque<ompl::base::ScopedState<>> &getPath() const
        {
            return path_;
        }

        /** \brief The checker of the last frame */
        const ompl_certificates::TeamValidityChecker &getChecker() const
        {
            return *setup_->getTeamChecker();
        }

    private:
        void takeChange(const ompl_certificates::ObstacleChange &change);
        void makeSetup(const ompl_certificates::ObstaclesPtr &obstacles);

        /** \brief Fills in invalid and asked, whichever way. */
        void askForPath(const ompl_certificates::ObstacleChange &change, Frame &frame) const;
        std::vector<std::size_t> findInvalid() const;

        void plan(std::uint64_t seed, Frame &frame);

        /** \brief Makes path_ of \e path, in steps from frame to frame. Returns false if such a step is not valid. */
        bool follow(const ompl::geometric::PathGeometric &path);

        bool hasPath() const;

        Way way_;
        ompl_certificates::TeamStateSpacePtr team_;
        Settings settings_;
        ompl_certificates::TeamSetupPtr setup_;
        std::deque<ompl::base::ScopedState<>> path_;
        ompl::base::ScopedState<> goal_, nextGoal_;
    };
}

#endif
