#include "KdTreeSpaces.h"

#include "ompl_certificates/neighbors/PlannerKdTree.h"
#include "support/IterationLimit.h"
#include "support/Quiet.h"
#include "support/RandomStates.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <ompl/geometric/SimpleSetup.h>
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

TEST(PlannerKdTree, GrowsTheTreesOfGnat)
{
    const unsigned int iterations = std::max(300U, scaled(1500));
    expectSameTrees<og::RRT>(iterations);
    expectSameTrees<og::RRTConnect>(iterations);
    expectSameTrees<og::RRTstar>(iterations);
    expectSameTrees<og::LazyRRT>(iterations);
    expectSameTrees<og::BiTRRT>(iterations);
}
