#ifndef OMPL_CERTIFICATES_PLANNING_CROWD_SEARCH_
#define OMPL_CERTIFICATES_PLANNING_CROWD_SEARCH_

#include "LazyConstraintSearch.h"
#include "PrioritizedSearch.h"
#include "ProductTree.h"

#include <optional>

namespace ompl_certificates
{
    /** \brief Looks for any path in a crowd, by LazyConstraintSearch. The last robots to arrive are the hardest for it:
        if its steps are used up, PrioritizedSearch goes on from where robots have the least way to go. Among few that
        move, priorities often succeed. */
    class CrowdSearch
    {
    public:
        /** \brief A search from \e start to \e goal, which must live longer, of that many \e steps and \e orders of the
            robots */
        CrowdSearch(TeamRoadmaps &roadmaps, const TeamRoadmaps::Configuration &start, const ProductTree::Goal &goal,
                    std::uint64_t steps, unsigned int orders);

        /** \brief Search until \e condition becomes true; again goes on from there.
            \return a path; none if there is none yet */
        std::optional<TeamRoadmaps::Path> search(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Whether all was tried */
        bool isOver() const
        {
            return rest_ && rest_->isOver();
        }

    private:
        TeamRoadmaps &roadmaps_;
        const ProductTree::Goal &goal_;
        const std::uint64_t steps_;
        const unsigned int orders_;
        LazyConstraintSearch search_;
        /** \brief From the start to where priorities go on */
        TeamRoadmaps::Path path_;
        std::optional<PrioritizedSearch> rest_;
    };
}

#endif
