#ifndef OMPL_CERTIFICATES_PLANNING_DRRTSTAR_
#define OMPL_CERTIFICATES_PLANNING_DRRTSTAR_

#include "ompl_certificates/planning/TeamPathSimplifier.h"

#include <memory>
#include <ompl/base/Planner.h>

namespace ompl_certificates
{
    class ProductTree;
    class TeamRoadmaps;

    /** \brief A planner for teams: a roadmap for each robot in its own space, and a search in their tensor product.

        Robots that are alike share a roadmap, and all ask the team's one checker, so what one robot learns of the
        obstacles serves all. The roadmaps grow in rounds. After each round a prioritized search looks for a path of the
        team in them, and a tree in their tensor product (dRRT*) improves it.

        Needs a TeamStateSpace and a TeamValidityChecker.

        @par External documentation
        R. Shome, K. Solovey, A. Dobson, D. Halperin, K. E. Bekris, dRRT*: Scalable and informed asymptotically-optimal
        multi-robot motion planning, 2020. */
    class DRRTstar : public ompl::base::Planner
    {
    public:
        explicit DRRTstar(const ompl::base::SpaceInformationPtr &si);
        ~DRRTstar() override;

        void setup() override;

        void clear() override;

        ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &condition) override;

        void getPlannerData(ompl::base::PlannerData &data) const override;

        /** \brief The number of samples of each roadmap in the first round; each later round doubles it */
        void setRoadmapSize(unsigned int samples)
        {
            roadmapSize_ = samples;
        }

        /** \brief See setRoadmapSize() */
        unsigned int getRoadmapSize() const
        {
            return roadmapSize_;
        }

        /** \brief The cost of the best solution so far; infinite if there is none */
        ompl::base::Cost getBestCost() const
        {
            return bestCost_;
        }

    private:
        using Configuration = std::vector<std::uint32_t>;
        using Path = std::vector<Configuration>;

        /** \brief Take the starts and goals that are new
            \return what is wrong, or UNKNOWN */
        ompl::base::PlannerStatus takeInput(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Find out which goals each robot can reach alone
            \return whether there is a start and a goal that all can */
        bool connect(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Look for better paths in the roadmaps as they are */
        void search(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Check a path of the roadmaps as a path of the team; remove what does not hold
            \return whether all of it holds */
        bool confirm(const Path &path);

        /** \brief Keep a path if it is the best so far */
        void report(const ompl::geometric::PathGeometric &path);

        /** \brief A path of the roadmaps as one of the team */
        ompl::geometric::PathGeometric toGeometric(const Path &path) const;

        std::shared_ptr<TeamValidityChecker> checker_;
        std::unique_ptr<TeamRoadmaps> roadmaps_;
        std::unique_ptr<ProductTree> tree_;
        std::unique_ptr<TeamPathSimplifier> simplifier_;
        std::vector<Configuration> starts_, goals_;
        ompl::base::OptimizationObjectivePtr objective_;
        ompl::base::PathPtr best_;
        ompl::base::Cost bestCost_;
        /** \brief The cost of the best path of the tree */
        ompl::base::Cost treeCost_;
        unsigned int roadmapSize_{20};
        unsigned int rounds_{0};
        bool smoothing_{true};
    };
}

#endif
