#include "KdTreeSpaces.h"

#include "ompl_certificates/neighbors/PlannerKdTree.h"
#include "ompl_certificates/neighbors/PlannerNeighbors.h"
#include "support/IterationLimit.h"
#include "support/Quiet.h"
#include "support/RandomStates.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <typeinfo>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    /** The states of the tree that \e Planner grows, in the order of the planner's data, with their parents */
    template <typename Planner, template <typename> class Neighbors>
    std::vector<std::vector<double>> grow(const TeamStateSpacePtr &team, unsigned int iterations)
    {
        const Quiet quiet;
        ompl::RNG::setSeed(7);  // OMPL complains about any seed but the first
        og::SimpleSetup setup(team);
        setup.setStateValidityChecker(
            [](const ob::State *state)
            {
                const auto *values = state->as<ob::CompoundState>()
                                         ->as<ob::CompoundState>(0)
                                         ->as<ob::RealVectorStateSpace::StateType>(0)
                                         ->values;
                return values[0] < 0.5 || values[0] > 1.0 || values[1] > 1.0;
            });
        ob::ScopedState<> start(team), goal(team);
        Random random(1);
        randomize(random, team, start.get());
        randomize(random, team, goal.get());
        ob::State *const first = start.get(), *const second = goal.get();
        for (ob::State *state : {first, second})
            state->as<ob::CompoundState>()
                ->as<ob::CompoundState>(0)
                ->as<ob::RealVectorStateSpace::StateType>(0)
                ->values[0] = state == first ? -1.5 : 1.5;
        setup.setStartAndGoalStates(start, goal, 1e-9);
        auto planner = std::make_shared<Planner>(setup.getSpaceInformation());
        planner->template setNearestNeighbors<Neighbors>();
        setup.setPlanner(planner);
        setup.setup();
        ob::IterationTerminationCondition condition(iterations);
        setup.solve(condition);
        ob::PlannerData data(setup.getSpaceInformation());
        setup.getPlannerData(data);
        std::vector<std::vector<double>> tree;
        for (unsigned int i = 0; i < data.numVertices(); ++i)
        {
            std::vector<double> values;
            team->copyToReals(values, data.getVertex(i).getState());
            std::vector<unsigned int> edges;
            data.getIncomingEdges(i, edges);
            std::vector<std::vector<double>> parents;
            for (const auto parent : edges)
            {
                parents.emplace_back();
                team->copyToReals(parents.back(), data.getVertex(parent).getState());
            }
            std::sort(parents.begin(), parents.end());
            for (const auto &parent : parents)
                values.insert(values.end(), parent.begin(), parent.end());
            tree.push_back(values);
        }
        // The vertices come in the order of list(), which is each structure's own.
        std::sort(tree.begin(), tree.end());
        return tree;
    }

    template <typename Planner>
    void expectSameTrees(unsigned int iterations)
    {
        for (const auto &team : {boxes(), mixed(), mixed(TeamStateSpace::SUM)})
        {
            const auto gnat = grow<Planner, ompl::NearestNeighborsGNAT>(team, iterations);
            // Not EXPECT_EQ, which would print them
            EXPECT_TRUE(gnat == (grow<Planner, PlannerKdTree>(team, iterations))) << typeid(Planner).name();
            EXPECT_TRUE(gnat == (grow<Planner, ompl::NearestNeighborsGNAT>(team, iterations)))
                << "not by the seed alone";
            EXPECT_GT(gnat.size(), 2U);
        }
    }
}

namespace
{
    /** A cost that is a length but in one place, and looks like one at first */
    class DearPlace : public ob::OptimizationObjective
    {
    public:
        using ob::OptimizationObjective::OptimizationObjective;

        ob::Cost stateCost(const ob::State * /*state*/) const override
        {
            return identityCost();
        }

        ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
        {
            const double x = to->as<ob::RealVectorStateSpace::StateType>()->values[0];
            return ob::Cost(si_->distance(from, to) * (x > 0.9 ? 30.0 : 1.0));
        }
    };
}

/** Their distance is the cost of a motion. */
TEST(PlannerKdTree, LeavesFmtItsStructureWhereCostsAreNoLengths)
{
    const auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
    plane->setBounds(0.0, 1.0);
    const auto si = std::make_shared<ob::SpaceInformation>(plane);
    si->setStateValidityChecker([](const ob::State * /*state*/) { return true; });
    si->setup();
    ob::ScopedState<> start(plane), goal(plane);
    start = std::vector<double>{0.1, 0.1};
    goal = std::vector<double>{0.8, 0.8};
    for (const bool isLength : {true, false})
    {
        const auto problem = std::make_shared<ob::ProblemDefinition>(si);
        problem->setStartAndGoalStates(start, goal);
        if (isLength)
            problem->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(si));
        else
            problem->setOptimizationObjective(std::make_shared<DearPlace>(si));
        for (const ob::PlannerPtr &planner :
             {ob::PlannerPtr(std::make_shared<og::FMT>(si)), ob::PlannerPtr(std::make_shared<og::BFMT>(si))})
        {
            planner->setProblemDefinition(problem);
            planner->setup();
            EXPECT_EQ(useKdTree(*planner), isLength) << planner->getName();
        }
    }
}

TEST(PlannerKdTree, GrowsTheTreesOfGnat)
{
    const unsigned int iterations = std::max(300U, scaled(1500));
    expectSameTrees<og::RRT>(iterations);
    expectSameTrees<og::RRTConnect>(iterations);
    expectSameTrees<og::RRTstar>(iterations);
    expectSameTrees<og::LazyRRT>(iterations);
    expectSameTrees<og::BiTRRT>(iterations);
}
