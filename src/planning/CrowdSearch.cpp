#include "CrowdSearch.h"

namespace ompl_certificates
{
    CrowdSearch::CrowdSearch(TeamRoadmaps &roadmaps, const TeamRoadmaps::Configuration &start,
                             const ProductTree::Goal &goal, std::uint64_t steps, unsigned int orders)
      : roadmaps_(roadmaps), goal_(goal), steps_(steps), orders_(orders), search_(roadmaps, start, goal.configuration)
    {
    }

    std::optional<TeamRoadmaps::Path> CrowdSearch::search(const ompl::base::PlannerTerminationCondition &condition)
    {
        if (!rest_)
        {
            if (auto path = search_.search(steps_, condition))
                return path;
            if (!search_.isOver(steps_))
                return std::nullopt;
            path_ = search_.getNearest();
            rest_.emplace(roadmaps_, path_.back(), goal_.configuration, goal_.distances, orders_);
        }
        const auto rest = rest_->search(condition);
        if (!rest)
            return std::nullopt;
        TeamRoadmaps::Path path = path_;
        path.insert(path.end(), rest->begin() + 1, rest->end());
        return path;
    }
}
