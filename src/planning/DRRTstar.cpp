#include "ompl_certificates/planning/DRRTstar.h"

#include "PrioritizedSearch.h"
#include "ProductTree.h"
#include "TeamRoadmaps.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ompl/util/Time.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/tools/config/SelfConfig.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

    namespace
    {
        /** How many orders of the robots a round tries */
        constexpr unsigned int ORDERS = 20;

        /** The iterations of the tree, and of RRTConnect for a robot, in the first round. Each later round doubles them. */
        constexpr unsigned int TREE_ITERATIONS = 10, ROBOT_ITERATIONS = 500, SMOOTHING = 100;
    }

    DRRTstar::DRRTstar(const ob::SpaceInformationPtr &si) : Planner(si, "DRRTstar"), bestCost_(std::nan("")), treeCost_(std::nan(""))
    {
        specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
        specs_.optimizingPaths = true;
        specs_.multithreaded = false;
        specs_.canReportIntermediateSolutions = true;
        Planner::declareParam<unsigned int>("roadmap_size", this, &DRRTstar::setRoadmapSize, &DRRTstar::getRoadmapSize,
                                            "1:1000000");
        addPlannerProgressProperty("best cost REAL", [this] { return std::to_string(bestCost_.value()); });
        addPlannerProgressProperty("rounds INTEGER", [this] { return std::to_string(rounds_); });
    }

    DRRTstar::~DRRTstar() = default;

    void DRRTstar::setup()
    {
        Planner::setup();
        checker_ = std::dynamic_pointer_cast<TeamValidityChecker>(si_->getStateValidityChecker());
        if (!checker_)
            throw ompl::Exception(getName(), "needs a TeamValidityChecker");
        if (!dynamic_cast<const TeamStateSpace *>(si_->getStateSpace().get()))
            throw ompl::Exception(getName(), "needs a TeamStateSpace");
        if (!pdef_)
            return;
        objective_ = pdef_->getOptimizationObjective();
        if (!objective_)
        {
            objective_ = std::make_shared<ob::PathLengthOptimizationObjective>(si_);
            pdef_->setOptimizationObjective(objective_);
        }
        bestCost_ = objective_->infiniteCost();
    }

    void DRRTstar::clear()
    {
        Planner::clear();
        simplifier_.reset();
        tree_.reset();
        roadmaps_.reset();
        starts_.clear();
        goals_.clear();
        best_.reset();
        rounds_ = 0;
        bestCost_ = objective_ ? objective_->infiniteCost() : ob::Cost(std::nan(""));
    }

    ob::PlannerStatus DRRTstar::takeInput(const ob::PlannerTerminationCondition &condition)
    {
        while (const ob::State *start = pis_.nextStart())
            starts_.push_back(roadmaps_->add(start));
        if (starts_.empty())
        {
            OMPL_ERROR("%s: there are no valid start states", getName().c_str());
            return ob::PlannerStatus::INVALID_START;
        }
        if (!dynamic_cast<ob::GoalSampleableRegion *>(pdef_->getGoal().get()))
        {
            OMPL_ERROR("%s: the goal cannot be sampled", getName().c_str());
            return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
        }
        if (goals_.empty())
            if (const ob::State *goal = pis_.nextGoal(condition))
                goals_.push_back(roadmaps_->add(goal));
        while (const ob::State *goal = goals_.size() < 10 ? pis_.nextGoal() : nullptr)
            goals_.push_back(roadmaps_->add(goal));
        if (goals_.empty())
        {
            OMPL_ERROR("%s: there are no valid goal states", getName().c_str());
            return ob::PlannerStatus::INVALID_GOAL;
        }
        return ob::PlannerStatus::UNKNOWN;
    }

    bool DRRTstar::confirm(const Path &path)
    {
        const Team &team = checker_->getTeam();
        ob::State *from = si_->allocState(), *to = si_->allocState(), *at = si_->allocState();
        bool holds = true;
        for (std::size_t step = 0; step + 1 < path.size(); ++step)
        {
            const Configuration &a = path[step], &b = path[step + 1];
            roadmaps_->copyTo(a, from);
            roadmaps_->copyTo(b, to);
            if (si_->checkMotion(from, to))
                continue;
            // The team's resolution is finer than that of a robot: what it shows is taken from the roadmaps.
            holds = false;
            tree_->cut(b);
            const unsigned int segments = si_->getStateSpace()->validSegmentCount(from, to);
            for (unsigned int sample = 0; sample <= segments; ++sample)
            {
                si_->getStateSpace()->interpolate(from, to, static_cast<double>(sample) / segments, at);
                for (unsigned int i = 0; i < team.getRobotCount(); ++i)
                {
                    if (!checker_->isRobotFree(i, team.getRobotState(at, i)))
                        roadmaps_->refute(i, a[i], b[i]);
                    for (unsigned int j = i + 1; j < team.getRobotCount(); ++j)
                        if (!checker_->isPairFree(i, team.getRobotState(at, i), j, team.getRobotState(at, j)))
                            roadmaps_->refute(i, a[i], b[i], j, a[j], b[j]);
                }
            }
        }
        for (ob::State *state : {from, to, at})
            si_->freeState(state);
        return holds;
    }

    og::PathGeometric DRRTstar::toGeometric(const Path &path) const
    {
        og::PathGeometric geometric(si_);
        ob::State *state = si_->allocState();
        for (const Configuration &configuration : path)
        {
            roadmaps_->copyTo(configuration, state);
            geometric.append(state);
        }
        si_->freeState(state);
        return geometric;
    }

    void DRRTstar::report(const og::PathGeometric &path)
    {
        const ob::Cost cost = path.cost(objective_);
        if (!objective_->isCostBetterThan(cost, bestCost_))
            return;
        best_ = std::make_shared<og::PathGeometric>(path);
        bestCost_ = cost;
        OMPL_INFORM("%s: a solution of cost %.4f in round %u", getName().c_str(), cost.value(), rounds_);
        if (const auto intermediate = pdef_->getIntermediateSolutionCallback())
        {
            const auto &kept = best_->as<og::PathGeometric>()->getStates();
            const std::vector<const ob::State *> states(kept.begin(), kept.end());
            intermediate(this, states, cost);
        }
    }

    bool DRRTstar::connect(const ob::PlannerTerminationCondition &condition)
    {
        const unsigned int iterations = ROBOT_ITERATIONS << std::min(rounds_, 20U);
        std::vector<ProductTree::Goal> goals;
        for (const Configuration &goal : goals_)
        {
            std::vector<std::vector<double>> distances;
            for (unsigned int robot = 0; robot < goal.size(); ++robot)
            {
                distances.push_back(
                    roadmaps_->getRoadmap(robot).connect(starts_.front()[robot], goal[robot], iterations, condition));
                if (distances.back().empty())
                    break;
            }
            if (distances.size() == goal.size() && !distances.back().empty())
                goals.push_back({goal, distances});
        }
        if (goals.empty())
            return false;
        // What was connected first may have found edges blocked, and added vertices.
        for (ProductTree::Goal &goal : goals)
            for (unsigned int robot = 0; robot < goal.configuration.size(); ++robot)
                goal.distances[robot] = roadmaps_->getRoadmap(robot).distancesTo(goal.configuration[robot]);
        tree_->setGoals(std::move(goals));
        return true;
    }

    void DRRTstar::search(const ob::PlannerTerminationCondition &condition)
    {
        if (!best_ && std::getenv("NOPRIO") == nullptr)
            for (const ProductTree::Goal &goal : tree_->getGoals())
                while (const auto path = PrioritizedSearch(*roadmaps_, starts_.front(), goal.configuration,
                                                           goal.distances).search(ORDERS, condition))
                    if (confirm(*path))
                    {
                        tree_->insert(*path);
                        break;
                    }
        unsigned int iterations = TREE_ITERATIONS << std::min(rounds_, 20U);
        while (tree_->grow(iterations, treeCost_, condition))
        {
            const Path path = tree_->getPath();
            if (!confirm(path))
                continue;
            treeCost_ = tree_->getCost();
            og::PathGeometric geometric = toGeometric(path);
            report(geometric);
            if (smoothing_ && simplifier_->simplify(geometric, SMOOTHING << std::min(rounds_, 20U), condition))
                report(geometric);
        }
        if (best_ && smoothing_)
        {
            og::PathGeometric geometric = *best_->as<og::PathGeometric>();
            if (simplifier_->simplify(geometric, SMOOTHING << std::min(rounds_, 20U), condition))
                report(geometric);
        }
    }

    ob::PlannerStatus DRRTstar::solve(const ob::PlannerTerminationCondition &condition)
    {
        checkValidity();
        if (!roadmaps_)
        {
            roadmaps_ = std::make_unique<TeamRoadmaps>(*checker_);
            tree_ = std::make_unique<ProductTree>(si_, objective_, *roadmaps_);
            simplifier_ = std::make_unique<TeamPathSimplifier>(si_, objective_);
            treeCost_ = objective_->infiniteCost();
        }
        if (const ob::PlannerStatus status = takeInput(condition); status != ob::PlannerStatus::UNKNOWN)
            return status;
        for (const Configuration &start : starts_)
            tree_->addStart(start);
        while (!condition)
        {
            if (rounds_ > 0)
                roadmaps_->grow(static_cast<TeamRoadmaps::Vertex>(roadmapSize_ << std::min(rounds_ - 1, 20U)), condition);
            const auto t0 = ompl::time::now();
            const bool ok = !condition && connect(condition);
            const auto t1 = ompl::time::now();
            if (ok)
                search(condition);
            if (std::getenv("DBG"))
            {
                std::size_t checked = 0, size = 0;
                for (const auto &r : roadmaps_->getRoadmaps())
                    checked += r->getCheckedMotions(), size += r->size();
                std::fprintf(stderr, "round %u vertices %zu checked %zu pairs %zu tree %zu connect %d %.4f search %.4f cost %g tree %g\n", rounds_, size, checked, roadmaps_->getCheckedPairMotions(), tree_->size(), ok, ompl::time::seconds(t1 - t0), ompl::time::seconds(ompl::time::now() - t1), bestCost_.value(), treeCost_.value());
            }
            ++rounds_;
            if (best_ && objective_->isSatisfied(bestCost_))
                break;
        }
        if (!best_)
            return ob::PlannerStatus::TIMEOUT;
        ob::PlannerSolution solution(best_);
        solution.setPlannerName(getName());
        solution.setOptimized(objective_, bestCost_, objective_->isSatisfied(bestCost_));
        pdef_->addSolutionPath(solution);
        return ob::PlannerStatus::EXACT_SOLUTION;
    }

    void DRRTstar::getPlannerData(ob::PlannerData &data) const
    {
        Planner::getPlannerData(data);
        if (!best_)
            return;
        const auto &states = best_->as<og::PathGeometric>()->getStates();
        for (std::size_t i = 0; i + 1 < states.size(); ++i)
            data.addEdge(ob::PlannerDataVertex(states[i]), ob::PlannerDataVertex(states[i + 1]));
    }
}
