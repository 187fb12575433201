#include "ompl_certificates/planning/DRRTstar.h"

#include "LazyConstraintSearch.h"
#include "LimitedRRTConnect.h"
#include "PrioritizedSearch.h"
#include "ProductTree.h"
#include "RoadmapPathCheck.h"
#include "TeamGoals.h"
#include "TeamRoadmaps.h"

#include "ompl_certificates/team/TeamObjective.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

    namespace
    {
        /** How many orders of the robots each round tries */
        constexpr unsigned int ORDERS = 20;

        /** What the first round does: iterations of the tree, iterations of RRTConnect for a robot, attempts to
            shorten each robot's way, steps of the search in a crowd for each robot, and for all starts and goals. Each
            later round does twice as much. */
        constexpr unsigned int TREE_ITERATIONS = 10, ROBOT_ITERATIONS = 500, SMOOTHING_ATTEMPTS = 50, CROWD_STEPS = 40;

        /** How often RRTConnect may iterate for a whole team of so many robots, before all else. Larger teams have
            little hope. */
        constexpr std::array<unsigned int, 5> TEAM_ITERATIONS{0, 0, 100, 10, 10};

        /** A path by LazyConstraintSearch. The last robots to arrive are the hardest for it. Among few that move,
            priorities often succeed. */
        std::optional<TeamRoadmaps::Path> findInCrowd(TeamRoadmaps &roadmaps, const TeamRoadmaps::Configuration &start,
                                                      const ProductTree::Goal &goal, std::uint64_t steps,
                                                      const ob::PlannerTerminationCondition &condition)
        {
            LazyConstraintSearch search(roadmaps, start, goal.configuration);
            if (auto path = search.search(steps, condition))
                return path;
            if (condition)
                return std::nullopt;
            TeamRoadmaps::Path path = search.getNearest();
            const TeamRoadmaps::Configuration last = path.back();
            const auto rest =
                PrioritizedSearch(roadmaps, last, goal.configuration, goal.distances).search(ORDERS, condition);
            if (!rest)
                return std::nullopt;
            path.insert(path.end(), rest->begin() + 1, rest->end());
            return path;
        }
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
        best_.reset();
        isBestOptimal_ = false;
        stuckRobot_.clear();
        rounds_ = 0;
        iterations_ = 0;
        vertices_ = 0;
        bestCost_ = objective_ ? objective_->infiniteCost().value() : std::nan("");
    }

    std::uint64_t DRRTstar::effort(unsigned int first) const
    {
        return static_cast<std::uint64_t>(first) << std::min(rounds_, 30U);
    }

    void DRRTstar::planTogether(const ob::PlannerTerminationCondition &condition)
    {
        const auto &team = *si_->getStateSpace()->as<TeamStateSpace>();
        auto problem = std::make_shared<ob::ProblemDefinition>(si_);
        for (unsigned int i = 0; i < pdef_->getStartStateCount(); ++i)
            problem->addStartState(pdef_->getStartState(i));
        problem->setGoal(pdef_->getGoal());
        if (const auto path = planByRRTConnect(problem, getName() + ", all robots at once", team.getPlannerRange(),
                                               TEAM_ITERATIONS[team.getRobotCount()], condition))
        {
            report(*path);
            shorten(*path, condition);
        }
    }

    void DRRTstar::growRoadmaps(const ob::PlannerTerminationCondition &condition)
    {
        // The round before the first growth counts, too.
        roadmaps_->grow(effort(roadmapSize_) / 2, maxRoadmapSize_, condition);
        std::uint64_t vertices = 0;
        for (const auto &roadmap : roadmaps_->getRoadmaps())
            vertices += roadmap->size();
        vertices_ = vertices;
    }

    bool DRRTstar::isAtLimit() const
    {
        return std::all_of(roadmaps_->getRoadmaps().begin(), roadmaps_->getRoadmaps().end(),
                           [this](const auto &roadmap) { return roadmap->size() >= maxRoadmapSize_; });
    }

    bool DRRTstar::connect(const ob::PlannerTerminationCondition &condition)
    {
        const std::vector<Configuration> chosen =
            goals_->choose(*pdef_->getGoal(), starts_, effort(ROBOT_ITERATIONS), condition);
        if (condition)
            return false;
        const auto stuck = goals_->getStuckRobot();
        stuckRobot_ = stuck ? checker_->getTeam().getRobot(*stuck).getName() : std::string();
        if (chosen.empty())
            return false;
        std::vector<ProductTree::Goal> goals;
        goals.reserve(chosen.size());
        for (const Configuration &goal : chosen)
            goals.push_back({goal, {}});
        for (ProductTree::Goal &goal : goals)
            for (unsigned int robot = 0; robot < goal.configuration.size(); ++robot)
            {
                if (condition)
                    return false;
                goal.distances.push_back(roadmaps_->getRoadmap(robot).distancesTo(goal.configuration[robot]));
            }
        tree_->setGoals(std::move(goals));
        return true;
    }

    void DRRTstar::searchByPriorities(const ob::PlannerTerminationCondition &condition)
    {
        for (const ProductTree::Goal &goal : tree_->getGoals())
            for (const Configuration &start : starts_)
                while (auto path = PrioritizedSearch(*roadmaps_, start, goal.configuration, goal.distances)
                                       .search(ORDERS, condition))
                    if (check_->confirm(*path))
                    {
                        tree_->insert(*path);
                        take(*path, condition);
                        return;
                    }
    }

    void DRRTstar::searchInCrowd(const ob::PlannerTerminationCondition &condition)
    {
        const std::uint64_t steps =
            effort(CROWD_STEPS) * roadmaps_->getRobotCount() / (tree_->getGoals().size() * starts_.size()) + 1;
        for (const ProductTree::Goal &goal : tree_->getGoals())
            for (const Configuration &start : starts_)
            {
                if (condition)
                    return;
                Path path{start};
                while (const auto rest = findInCrowd(*roadmaps_, path.back(), goal, steps, condition))
                {
                    path.insert(path.end(), rest->begin() + 1, rest->end());
                    if (check_->confirm(path))
                    {
                        tree_->insert(path);
                        take(path, condition);
                        return;
                    }
                }
            }
    }

    void DRRTstar::searchTree(const ob::PlannerTerminationCondition &condition)
    {
        const std::uint64_t most = effort(TREE_ITERATIONS);
        std::uint64_t left = most;
        while (tree_->grow(left, treeCost_, condition))
        {
            Path path = tree_->getPath();
            if (!check_->confirm(path))
            {
                if (condition)
                    break;
                continue;
            }
            treeCost_ = tree_->getCost();
            take(path, condition);
        }
        iterations_ += most - left;
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
        stuckRobot_.clear();
        if (!roadmaps_)
            beginSearch();
        if (const ob::PlannerStatus status = takeInput(condition); status != ob::PlannerStatus::UNKNOWN)
            return status;
        for (const Configuration &start : starts_)
            tree_->addStart(start);
        // A start or a goal may have been added since.
        if (best_)
            isBestOptimal_ = isOptimal(*best_);
        if (const unsigned int robots = roadmaps_->getRobotCount();
            !isDone() && rounds_ == 0 && robots < TEAM_ITERATIONS.size() && TEAM_ITERATIONS[robots] > 0)
            planTogether(condition);
        for (; !condition && !isDone(); ++rounds_)
        {
            if (rounds_ > 0)
                growRoadmaps(condition);
            takeGoals();
            if (!connect(condition))
            {
                if (isAtLimit() && !pis_.haveMoreGoalStates())
                    break;
                continue;
            }
            searchByPriorities(condition);
            if (!best_)
                searchInCrowd(condition);
            if (!isDone())
                searchTree(condition);
            if (best_)
                shorten(*best_, condition);
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
