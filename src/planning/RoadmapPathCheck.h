#ifndef OMPL_CERTIFICATES_PLANNING_ROADMAP_PATH_CHECK_
#define OMPL_CERTIFICATES_PLANNING_ROADMAP_PATH_CHECK_

#include "TeamRoadmaps.h"

#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

namespace ompl_certificates
{
    class ProductTree;

    /** \brief Checks paths of roadmaps as paths of the team. What does not hold is taken out of the roadmaps and the tree,
        so that no search finds it again. */
    class RoadmapPathCheck
    {
    public:
        using Configuration = TeamRoadmaps::Configuration;
        using Path = TeamRoadmaps::Path;

        /** \brief A check by the motion validator of \e si. All must outlive it. */
        RoadmapPathCheck(ompl::base::SpaceInformationPtr si, const TeamValidityChecker &checker, TeamRoadmaps &roadmaps,
                         ProductTree &tree);

        /** \brief Check a path, and end it before the first step that does not hold
            \return whether all of it holds */
        bool confirm(Path &path);

        /** \brief A path of the roadmaps as one of the team */
        ompl::geometric::PathGeometric toGeometric(const Path &path) const;

    private:
        /** \brief Find out which robots or pairs make a step invalid, and remember it. */
        void refute(const Configuration &from, const Configuration &to);

        const ompl::base::SpaceInformationPtr si_;
        const TeamValidityChecker &checker_;
        TeamRoadmaps &roadmaps_;
        ProductTree &tree_;
    };
}

#endif
