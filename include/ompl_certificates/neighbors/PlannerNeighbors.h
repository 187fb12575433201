#ifndef OMPL_CERTIFICATES_NEIGHBORS_PLANNER_NEIGHBORS_
#define OMPL_CERTIFICATES_NEIGHBORS_PLANNER_NEIGHBORS_

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <ompl/base/Planner.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief The structure in which a planner searches its tree for near states */
    enum class NearestStructure
    {
        /// PlannerKdTree
        KD_TREE,
        /// What OMPL chooses: a GNAT, if the space is a metric one
        GNAT
    };

    /** \brief All structures, the default one first */
    const std::vector<NearestStructure> &allNearestStructures();

    /** \brief The name of a structure: kdtree or gnat */
    std::string nameOf(NearestStructure structure);

    /** \brief The structure of that name
        \throws ompl::Exception that lists the names if there is none */
    NearestStructure nearestStructureOf(const std::string &name);

    /** \brief Sums up the time that threads spend in a planner's nearest-neighbor structures */
    class NearestClock
    {
    public:
        /** \brief The sum so far, in seconds */
        double getSeconds() const
        {
            return 1e-9 * static_cast<double>(nanoseconds_.load(std::memory_order_relaxed));
        }

        /** \brief Add the time since \e start */
        void addSince(std::chrono::steady_clock::time_point start)
        {
            const std::chrono::nanoseconds time = std::chrono::steady_clock::now() - start;
            nanoseconds_.fetch_add(static_cast<std::uint64_t>(time.count()), std::memory_order_relaxed);
        }

    private:
        std::atomic<std::uint64_t> nanoseconds_{0};
    };

    /** \brief Put a PlannerKdTree in the place of each GNAT that OMPL has given \e planner. TeamSetup and
        TeamControlSetup do this for their planners. Call it once the planner is set up, with its problem definition.

        Unlike the planner's setNearestNeighbors() it does not need the planner's class. So it also works for these
        planners:
        - those without that function (EST, BiEST), and those where it fails in OMPL 1.5.2 (PRM, and TRRT before
          setup());
        - those whose nodes do not hold their states (PRM, LazyPRM, SPARS, SPARStwo);
        - those within CForest and AnytimePathShortening.

        Of control planners it knows RRT and SST. FMT and BFMT keep theirs if costs are no lengths (an objective that is
        no PathLengthOptimizationObjective): these are their distances.

        Structures of other classes are their user's choice and stay.
        \return whether there was one to replace. Planners with grids or other structures of their own have none:
        KPIECE1, PDST, SBL, STRIDE, RLRT, BITstar and their kin, and of control planners EST and Syclop's. */
    bool useKdTree(ompl::base::Planner &planner);

    /** \brief From now on, add the time that \e planner spends in its structures to \e clock. Costs some 50 ns per call
        of a structure. Call it once for a planner, after setup() and useKdTree().
        \return false if no structure can be accessed; see useKdTree() */
    bool timeNearest(ompl::base::Planner &planner, const std::shared_ptr<NearestClock> &clock);
}

#endif
