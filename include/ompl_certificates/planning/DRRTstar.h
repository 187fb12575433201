#ifndef OMPL_CERTIFICATES_PLANNING_DRRTSTAR_
#define OMPL_CERTIFICATES_PLANNING_DRRTSTAR_

#include "ompl_certificates/planning/TeamPathSimplifier.h"
#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <atomic>
#include <memory>
#include <ompl/base/Planner.h>

namespace ompl_certificates
{
    class CertificateMotionValidator;
    class ProductTree;
    class RoadmapPathCheck;
    class TeamGoals;
    class TeamRoadmaps;

    /** \brief A planner for teams: a roadmap for each robot in its own space, and a search in their tensor product.
        There each robot moves along an edge of its roadmap in each step, or waits.

        Robots that are alike share a roadmap, and all ask the team's one checker, so what one robot learns of the
        obstacles serves all. Edges are checked when they are needed, and edges of two robots against each other once.
        After a few iterations of RRTConnect for a whole team of up to four, which solve what is easy, the planner
        works in rounds:

        - The roadmaps grow; each round adds twice as many vertices as the one before. Where a robot cannot reach its
          goal in its roadmap, RRTConnect looks for a way of this robot alone, which becomes part of the roadmap.
        - A prioritized search plans robot by robot around those planned before.
        - As long as there is no solution, a depth-first search (LaCAM) takes one step after the other, in which robots
          make way for those that have been on their way for longest.
        - A tree in the tensor product (dRRT*) looks for better solutions, and for the first one, too.
        - A TeamPathSimplifier shortens what was found robot by robot; see setSmoothing().

        It is probabilistically complete, and its paths approach the best ones. It runs until it is stopped, until
        the cost satisfies the objective, or until each robot goes straight to its goal, at the least cost that the
        objective's OptimizationObjective::costToGo() allows. Equal seeds and numbers of iterations give equal paths
        under all methods of checking.

        Of a goal region, each round samples ten more goals. The robots' parts of goals are mixed if the region contains
        the result: so each robot goes to one that it reaches, and that is near.

        Needs a TeamStateSpace, a TeamValidityChecker and a goal that can be sampled. If the motion validator is a
        CertificateMotionValidator, it checks single robots and pairs, too; else one of its own does, in discrete mode.
        All motions that are returned are valid for the space information's motion validator. Roadmaps take their states
        from the samplers of the robots' spaces, so the team's own sampler and a ValidStateSampler have no effect: give an
        allocator to a robot's space, TeamStateSpace::getSubspace().

        @par External documentation
        K. Solovey, O. Salzman, D. Halperin, Finding a needle in an exponential haystack: discrete RRT for exploration
        of implicit roadmaps in multi-robot motion planning, 2016; R. Shome, K. Solovey, A. Dobson, D. Halperin,
        K. E. Bekris, dRRT*: Scalable and informed asymptotically-optimal multi-robot motion planning, 2020; K. Okumura,
        LaCAM: Search-based algorithm for quick multi-agent pathfinding, 2023. */
    class DRRTstar : public ompl::base::Planner
    {
    public:
        /** \brief A planner for the team of \e si */
        explicit DRRTstar(const ompl::base::SpaceInformationPtr &si);
        ~DRRTstar() override;

        /** \throws ompl::Exception if the space is no TeamStateSpace, or the validity checker no TeamValidityChecker */
        void setup() override;

        /** \brief Forget roadmaps, tree and solution */
        void clear() override;

        /** \brief Set the problem; if it is another one than before, clear(). */
        void setProblemDefinition(const ompl::base::ProblemDefinitionPtr &pdef) override;

        /** \brief Plan until \e condition becomes true, the objective is satisfied or no path can be better. Calls
            of solve() go on where the one before was stopped, if each has the time of a search for one robot, unless clear() was called, or the validity checker, the motion
            validator or the objective is another one. If a robot finds no way even alone, a message names it; then
            planning also ends when the roadmaps have grown to their limit and all goals were taken. */
        ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &condition) override;

        /** \brief The tree in the tensor product, with starts and goals */
        void getPlannerData(ompl::base::PlannerData &data) const override;

        /** \brief The number of vertices by which each roadmap grows first; each later round doubles it. Parameter
            roadmap_size.
            \throws ompl::Exception if it is 0 */
        void setRoadmapSize(unsigned int vertices);

        /** \brief See setRoadmapSize() */
        unsigned int getRoadmapSize() const
        {
            return roadmapSize_;
        }

        /** \brief The number of vertices at which a roadmap stops to grow. Parameter max_roadmap_size.
            \throws ompl::Exception if it is 0 */
        void setMaxRoadmapSize(unsigned int vertices);

        /** \brief See setMaxRoadmapSize() */
        unsigned int getMaxRoadmapSize() const
        {
            return maxRoadmapSize_;
        }

        /** \brief Whether robots that are alike share a roadmap; the default. If not, each has its own: to measure
            what sharing saves. Parameter share_roadmaps. Takes effect in the first solve(), and in the first one after
            clear(). */
        void setSharesRoadmaps(bool share)
        {
            sharesRoadmaps_ = share;
        }

        /** \brief See setSharesRoadmaps() */
        bool getSharesRoadmaps() const
        {
            return sharesRoadmaps_;
        }

        /** \brief Whether the best path is shortened robot by robot; the default. Parameter smoothing. */
        void setSmoothing(bool smoothing)
        {
            smoothing_ = smoothing;
        }

        /** \brief See setSmoothing() */
        bool getSmoothing() const
        {
            return smoothing_;
        }

        /** \brief How many threads let the roadmaps of robots that are not alike grow; the default is 1, and 0 stands
            for as many as there are cores. Paths are equal for any number of threads. The rest of the planner uses one
            thread. Parameter threads. Takes effect as setSharesRoadmaps() does. */
        void setThreads(unsigned int threads)
        {
            threads_ = threads;
        }

        /** \brief See setThreads() */
        unsigned int getThreads() const
        {
            return threads_;
        }

        /** \brief The cost of the best solution so far; infinite if there is none */
        ompl::base::Cost getBestCost() const
        {
            return ompl::base::Cost(bestCost_);
        }

        /** \brief The name of the robot that solve() found no way for last, from its start to any goal, even alone;
            empty if there was none */
        const std::string &getStuckRobot() const
        {
            return stuckRobot_;
        }

    private:
        using Configuration = std::vector<std::uint32_t>;
        using Path = std::vector<Configuration>;

        struct Round;

        /** \brief Take the checker, the motion validator and the objective that are set now. If they are others, what
            was found with those before is of no use: clear(). */
        void takeCheckers();

        /** \brief Make the roadmaps and what searches them. */
        void beginSearch();

        /** \brief Take the starts that are new, and a goal if there is none yet
            \return what is wrong, or UNKNOWN */
        ompl::base::PlannerStatus takeInput(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief What is wrong with a state that is not valid */
        std::string describeInvalid(const ompl::base::State *state) const;

        /** \brief Take further goals for this round, if the goal region has more */
        void takeGoals();

        /** \brief Let RRTConnect try its luck with the whole team: it solves what is easy for few robots at once. */
        void planTogether(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Do what is left of this round
            \return whether it is finished; false if \e condition became true */
        bool continueRound(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Begin the first round, or this one again but for growth, since there are new starts or goals. */
        void beginRound();

        /** \brief Let the roadmaps grow for this round
            \return whether they have */
        bool growRoadmaps(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Whether all roadmaps have grown to their limit */
        bool isAtLimit() const;

        /** \brief Choose goals that each robot can reach alone, and give them to the tree
            \return whether there is one */
        bool connect(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Look for a path by priorities
            \return whether this is finished */
        bool searchByPriorities(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Look for any path by LazyConstraintSearch
            \return whether this is finished */
        bool searchInCrowd(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Look for better paths with the tree
            \return whether this is finished */
        bool searchTree(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Report a path, and shorten it */
        void take(const Path &path, const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Whether the best path is good enough for the objective */
        bool isSatisfied() const;

        /** \brief Whether the search may end: the best path is good enough, or no path can be better */
        bool isDone() const;

        /** \brief Whether a path costs no more than any path from a start to the goal must. For a makespan, it must
            also be as short as any path. */
        bool isOptimal(const ompl::geometric::PathGeometric &path) const;

        /** \brief Shorten a path if none is good enough yet, and report it if that makes it the best */
        void shorten(ompl::geometric::PathGeometric path, const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Keep a path if it is the best so far
            \return whether it is */
        bool report(const ompl::geometric::PathGeometric &path);

        /** \brief How much work the present round may do: \e first, doubled in each round */
        std::uint64_t effort(unsigned int first) const;

        std::shared_ptr<TeamValidityChecker> checker_;
        std::shared_ptr<const CertificateMotionValidator> validator_;
        /** \brief For a space information whose motion validator is another one */
        std::shared_ptr<const CertificateMotionValidator> ownValidator_;
        std::unique_ptr<TeamRoadmaps> roadmaps_;
        std::unique_ptr<TeamGoals> goals_;
        std::unique_ptr<ProductTree> tree_;
        std::unique_ptr<RoadmapPathCheck> check_;
        std::unique_ptr<TeamPathSimplifier> simplifier_;
        std::vector<Configuration> starts_;
        /** \brief How many starts there were in the present round, and how many goals to sample */
        std::size_t knownStarts_{0};
        unsigned int knownGoals_{0};
        ompl::base::OptimizationObjectivePtr objective_;
        std::shared_ptr<ompl::geometric::PathGeometric> best_;
        /** \brief Whether the best path is optimal */
        bool isBestOptimal_{false};
        /** \brief The cost of the best path of the tree, before it was shortened */
        ompl::base::Cost treeCost_;
        /** \brief The robot that found no way alone in this round */
        std::string stuckRobot_;
        unsigned int roadmapSize_{20}, maxRoadmapSize_{100000}, threads_{1};
        bool sharesRoadmaps_{true}, smoothing_{true};
        unsigned int rounds_{0};
        /** \brief What of the present round is done; null before the first one */
        std::unique_ptr<Round> round_;
        /** \brief What progress properties tell: other threads may ask. */
        std::atomic<double> bestCost_;
        std::atomic<std::uint64_t> iterations_{0}, vertices_{0};
    };
}

#endif
