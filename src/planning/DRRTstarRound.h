#ifndef OMPL_CERTIFICATES_PLANNING_DRRTSTAR_ROUND_
#define OMPL_CERTIFICATES_PLANNING_DRRTSTAR_ROUND_

#include "CrowdSearch.h"

#include "ompl_certificates/planning/DRRTstar.h"

namespace ompl_certificates
{
    /** \brief What a round has done, so that the next call of solve() goes on where one was stopped */
    struct DRRTstar::Round
    {
        /** \brief What a round does, in this order */
        enum Phase
        {
            GROWTH,
            CONNECTION,
            PRIORITIES,
            CROWD,
            TREE,
            SHORTENING,
            END
        };

        /** \brief What is to be done next */
        Phase phase{GROWTH};

        /** \brief Whether each robot can reach a goal alone */
        bool isConnected{false};

        /** \brief The goals that were chosen, if they are */
        std::optional<std::vector<Configuration>> chosen;

        /** \brief Those of them whose distances are known; of the last one maybe not all */
        std::vector<ProductTree::Goal> goals;

        /** \brief Which pair of a goal and a start the search is at */
        std::size_t pair{0};

        /** \brief The search by priorities for this pair; null before it begins */
        std::unique_ptr<PrioritizedSearch> priorities;

        /** \brief The search in the crowd from the end of \e path; null before it begins */
        std::unique_ptr<CrowdSearch> crowd;

        /** \brief The path that was found in the crowd, as far as it is free */
        Path path;

        /** \brief How many iterations of the tree are left */
        std::uint64_t treeIterations{0};
    };
}

#endif
