#include "ompl_certificates/planning/DRRTstar.h"

#include "DRRTstarRound.h"
#include "LimitedRRTConnect.h"
#include "ProductTree.h"
#include "RoadmapPathCheck.h"
#include "TeamGoals.h"
#include "TeamRoadmaps.h"

#include "ompl_certificates/team/TeamObjective.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

    namespace
    {
        /** How often the first round tries to shorten each robot's way. Each later round does so twice as often. */
        constexpr unsigned int SMOOTHING_ATTEMPTS = 50;

        /** How often RRTConnect may iterate for a whole team of so many robots, before all else. Larger teams have
            little hope. */
        constexpr std::array<unsigned int, 5> TEAM_ITERATIONS{0, 0, 100, 10, 10};

    }

    DRRTstar::DRRTstar(const ob::SpaceInformationPtr &si)
      : Planner(si, "DRRTstar"), treeCost_(std::nan("")), bestCost_(std::nan(""))
    {
        specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
        specs_.optimizingPaths = true;
        specs_.canReportIntermediateSolutions = true;
        Planner::declareParam<unsigned int>("roadmap_size", this, &DRRTstar::setRoadmapSize, &DRRTstar::getRoadmapSize,
                                            "1:1000000");
        Planner::declareParam<unsigned int>("max_roadmap_size", this, &DRRTstar::setMaxRoadmapSize,
                                            &DRRTstar::getMaxRoadmapSize, "1:10000000");
        Planner::declareParam<bool>("share_roadmaps", this, &DRRTstar::setSharesRoadmaps, &DRRTstar::getSharesRoadmaps,
                                    "0,1");
        Planner::declareParam<unsigned int>("threads", this, &DRRTstar::setThreads, &DRRTstar::getThreads, "0:256");
        Planner::declareParam<bool>("smoothing", this, &DRRTstar::setSmoothing, &DRRTstar::getSmoothing, "0,1");
        addPlannerProgressProperty("best cost REAL", [this] { return std::to_string(bestCost_); });
        addPlannerProgressProperty("iterations INTEGER", [this] { return std::to_string(iterations_); });
        addPlannerProgressProperty("roadmap vertices INTEGER", [this] { return std::to_string(vertices_); });
    }

    DRRTstar::~DRRTstar() = default;

    void DRRTstar::beginSearch()
    {
        auto roadmaps = std::make_unique<TeamRoadmaps>(*validator_, sharesRoadmaps_, threads_);
        goals_ = std::make_unique<TeamGoals>(si_, checker_, *roadmaps);
        tree_ = std::make_unique<ProductTree>(si_, objective_, *roadmaps);
        check_ = std::make_unique<RoadmapPathCheck>(si_, *checker_, *roadmaps, *tree_);
        simplifier_ = std::make_unique<TeamPathSimplifier>(si_, objective_);
        treeCost_ = objective_->infiniteCost();
        roadmaps_ = std::move(roadmaps);
    }

    void DRRTstar::setRoadmapSize(unsigned int vertices)
    {
        if (vertices == 0)
            throw ompl::Exception(getName(), "roadmap_size must be positive, not 0");
        roadmapSize_ = vertices;
    }

    void DRRTstar::setMaxRoadmapSize(unsigned int vertices)
    {
        if (vertices == 0)
            throw ompl::Exception(getName(), "max_roadmap_size must be positive, not 0");
        maxRoadmapSize_ = vertices;
    }

    void DRRTstar::clear()
    {
        Planner::clear();
        simplifier_.reset();
        check_.reset();
        tree_.reset();
        goals_.reset();
        roadmaps_.reset();
        starts_.clear();
        knownStarts_ = 0;
        knownGoals_ = 0;
        best_.reset();
        isBestOptimal_ = false;
        stuckRobot_.clear();
        round_.reset();
        rounds_ = 0;
        iterations_ = 0;
        vertices_ = 0;
        bestCost_ = objective_ ? objective_->infiniteCost().value() : std::nan("");
    }

    void DRRTstar::planTogether(const ob::PlannerTerminationCondition &condition)
    {
        const auto &team = *si_->getStateSpace()->as<TeamStateSpace>();
        auto problem = std::make_shared<ob::ProblemDefinition>(si_);
        for (unsigned int i = 0; i < pdef_->getStartStateCount(); ++i)
            problem->addStartState(pdef_->getStartState(i));
        problem->setGoal(pdef_->getGoal());
        LimitedRRTConnect search(problem, getName() + ", all robots at once", team.getPlannerRange(),
                                 TEAM_ITERATIONS[team.getRobotCount()]);
        if (const auto path = search.search(condition))
        {
            report(*path);
            shorten(*path, condition);
        }
    }

    void DRRTstar::take(const Path &path, const ob::PlannerTerminationCondition &condition)
    {
        og::PathGeometric geometric = check_->toGeometric(path);
        if (report(geometric))
            goals_->keep(path.back());
        shorten(geometric, condition);
    }

    void DRRTstar::shorten(og::PathGeometric path, const ob::PlannerTerminationCondition &condition)
    {
        // An attempt changes the way of one robot.
        const std::uint64_t attempts = roadmaps_->getRobotCount() * effort(SMOOTHING_ATTEMPTS);
        if (smoothing_ && !isDone() && simplifier_->simplify(path, attempts, condition))
            report(path);
    }

    bool DRRTstar::isSatisfied() const
    {
        return best_ && objective_->isSatisfied(getBestCost());
    }

    bool DRRTstar::isDone() const
    {
        return isBestOptimal_ || isSatisfied();
    }

    bool DRRTstar::isOptimal(const og::PathGeometric &path) const
    {
        const auto isLeast = [&](const ob::OptimizationObjectivePtr &objective)
        {
            ob::Cost bound = objective->infiniteCost();
            for (unsigned int i = 0; i < pdef_->getStartStateCount(); ++i)
                bound =
                    objective->betterCost(bound, objective->costToGo(pdef_->getStartState(i), pdef_->getGoal().get()));
            // A sum over the states of a path is rounded.
            constexpr double rounding = 1e-12;
            const ob::Cost cost(path.cost(objective).value() * (1.0 - rounding));
            return !objective->isCostBetterThan(bound, cost);
        };
        return isLeast(objective_) && isLeast(std::make_shared<TeamObjective>(si_, TeamObjective::SUM_OF_LENGTHS));
    }

    bool DRRTstar::report(const og::PathGeometric &path)
    {
        const ob::Cost cost = path.cost(objective_);
        if (best_ && !objective_->isCostBetterThan(cost, getBestCost()))
        {
            // Of paths of one cost, such as a makespan, the one with the shorter ways is kept.
            const auto lengths = std::make_shared<TeamObjective>(si_, TeamObjective::SUM_OF_LENGTHS);
            if (!objective_->isCostBetterThan(getBestCost(), cost) &&
                lengths->isCostBetterThan(path.cost(lengths), best_->cost(lengths)))
            {
                best_ = std::make_shared<og::PathGeometric>(path);
                isBestOptimal_ = isOptimal(path);
            }
            return false;
        }
        best_ = std::make_shared<og::PathGeometric>(path);
        isBestOptimal_ = isOptimal(path);
        bestCost_ = cost.value();
        if (const auto intermediate = pdef_->getIntermediateSolutionCallback())
            intermediate(this, {best_->getStates().begin(), best_->getStates().end()}, cost);
        return true;
    }

    ob::PlannerStatus DRRTstar::solve(const ob::PlannerTerminationCondition &condition)
    {
        checkValidity();
        takeCheckers();
        if (!roadmaps_)
            beginSearch();
        if (const ob::PlannerStatus status = takeInput(condition); status != ob::PlannerStatus::UNKNOWN)
            return status;
        const unsigned int goals = pdef_->getGoal()->as<ob::GoalSampleableRegion>()->maxSampleCount();
        // What is under way does not know of new starts and goals.
        const bool isOther = !round_ || starts_.size() > knownStarts_ || goals > knownGoals_;
        knownStarts_ = starts_.size();
        knownGoals_ = goals;
        for (const Configuration &start : starts_)
            tree_->addStart(start);
        // A start or a goal may have been added since.
        if (best_)
            isBestOptimal_ = isOptimal(*best_);
        if (isOther)
        {
            beginRound();
            const unsigned int robots = roadmaps_->getRobotCount();
            if (!isDone() && robots < TEAM_ITERATIONS.size() && TEAM_ITERATIONS[robots] > 0)
                planTogether(condition);
        }
        while (!condition && !isDone() && continueRound(condition))
        {
            if (!round_->isConnected && isAtLimit() && !pis_.haveMoreGoalStates())
            {
                // Another call may have more luck.
                beginRound();
                break;
            }
            round_ = std::make_unique<Round>();
            ++rounds_;
        }
        if (!best_)
        {
            if (!stuckRobot_.empty())
                OMPL_INFORM("%s: robot '%s' found no way from its start to %s even alone, among %llu vertices",
                            getName().c_str(), stuckRobot_.c_str(),
                            goals_->size() == 1 ? "its goal" : "any of the goals sampled",
                            static_cast<unsigned long long>(vertices_));
            return ob::PlannerStatus::TIMEOUT;
        }
        stuckRobot_.clear();
        // A copy, which its owner may change
        ob::PlannerSolution solution(std::make_shared<og::PathGeometric>(*best_));
        solution.setPlannerName(getName());
        solution.setOptimized(objective_, getBestCost(), isSatisfied());
        pdef_->addSolutionPath(solution);
        return ob::PlannerStatus::EXACT_SOLUTION;
    }

    void DRRTstar::getPlannerData(ob::PlannerData &data) const
    {
        Planner::getPlannerData(data);
        if (!tree_)
            return;
        tree_->visitEdges([&](const ob::State *from, const ob::State *to)
                          { data.addEdge(ob::PlannerDataVertex(from), ob::PlannerDataVertex(to)); });
        for (const ob::State *start : tree_->getStarts())
            data.addStartVertex(ob::PlannerDataVertex(start));
        const auto goals = tree_->getReachedGoals();
        for (const ob::State *goal : goals)
            data.addGoalVertex(ob::PlannerDataVertex(goal));
        if (!best_ || !goals.empty())
            return;
        // The team was planned for together, without the tree.
        const auto &states = best_->getStates();
        const ob::State *last = states.front();
        for (const ob::State *start : tree_->getStarts())
            if (si_->equalStates(start, states.front()))
                last = start;
        for (std::size_t i = 1; i < states.size(); ++i)
        {
            data.addEdge(ob::PlannerDataVertex(last), ob::PlannerDataVertex(states[i]));
            last = states[i];
        }
        data.addGoalVertex(ob::PlannerDataVertex(states.back()));
    }
}
