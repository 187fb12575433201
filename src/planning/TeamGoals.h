#ifndef OMPL_CERTIFICATES_PLANNING_TEAM_GOALS_
#define OMPL_CERTIFICATES_PLANNING_TEAM_GOALS_

#include "TeamRoadmaps.h"

#include <array>
#include <map>
#include <ompl/base/Goal.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/util/RandomNumbers.h>
#include <optional>

namespace ompl_certificates
{
    class TeamValidityChecker;

    /** \brief The goals of a team as vertices of its roadmaps, and which of them its robots can reach.

        Of a goal that is sampled from a region, some robot of many often cannot reach its part, and another one has a
        long way to go. So goals are mixed, too: each robot goes to the nearest part it reaches, if the region contains
        such a goal. */
    class TeamGoals
    {
    public:
        using Configuration = TeamRoadmaps::Configuration;

        TeamGoals(ompl::base::SpaceInformationPtr si, std::shared_ptr<const TeamValidityChecker> checker,
                  TeamRoadmaps &roadmaps);
        ~TeamGoals();

        TeamGoals(const TeamGoals &) = delete;
        TeamGoals &operator=(const TeamGoals &) = delete;

        /** \brief Add a valid state of the goal region */
        void add(const ompl::base::State *goal);

        std::size_t size() const
        {
            return goals_.size();
        }

        /** \brief Always choose this goal from now on: the best path ends there. */
        void keep(const Configuration &goal)
        {
            kept_ = goal;
        }

        /** \brief Choose at most ten goals that all robots can reach alone from one of \e starts: a mixed one, that of
            keep(), and others at random if there are more
            \param region tells which mixed goals are goals
            \param iterations of RRTConnect for each robot without a way in its roadmap, divided among the goals
            \return nothing if \e condition became true before; then another call goes on */
        std::optional<std::vector<Configuration>> choose(const ompl::base::Goal &region,
                                                         const std::vector<Configuration> &starts,
                                                         std::uint64_t iterations,
                                                         const ompl::base::PlannerTerminationCondition &condition);

        /** \brief A robot that in the last choose() found no way from any start to any goal, even alone */
        const std::optional<unsigned int> &getStuckRobot() const
        {
            return stuckRobot_;
        }

    private:
        using Vertex = TeamRoadmaps::Vertex;

        /** \brief Add the goals to \e reachable that can be reached from \e start, the mixed one before all. Note which
            robots arrive at any goal.
            \return false if \e condition became true before */
        bool addReachable(const ompl::base::Goal &region, const Configuration &start, unsigned int iterations,
                          const ompl::base::PlannerTerminationCondition &condition,
                          std::vector<Configuration> &reachable, std::vector<bool> &arrives);

        /** \brief For each robot the vertex nearest to its start among those it reaches, but apart from the robots
            before it; nothing if that is no goal */
        std::optional<Configuration> mix(const ompl::base::Goal &region, const Configuration &start,
                                         std::vector<std::vector<Vertex>> reached) const;

        const ompl::base::SpaceInformationPtr si_;
        const std::shared_ptr<const TeamValidityChecker> checker_;
        TeamRoadmaps &roadmaps_;
        std::vector<Configuration> goals_;
        Configuration kept_;
        std::optional<unsigned int> stuckRobot_;
        /** \brief For a robot, its start and the number of a goal, whether it has a way. Of a choose() that was stopped:
            the next one goes on with others. */
        std::map<std::array<std::size_t, 3>, bool> tried_;
        ompl::RNG random_;
        ompl::base::State *mixed_;
    };
}

#endif
