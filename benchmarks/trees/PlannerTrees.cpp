// The cost of the planner's own nearest-neighbor structure: PlannerKdTree against OMPL's default (GNAT).
//
//     trees --benchmark_filter=nearestAndAdd
//     trees --benchmark_filter='RRT, .*/5/'
//
// nearestAndAdd is RRT's access pattern among random states; its time is for one query and one addition, over the last
// tenth of the elements. Other benchmarks are whole plans: range 5 in 100 x 100, a checker that says yes, a goal that
// nothing satisfies. Counter nearest_ms is the structure's part of the time. RRT* asks for the k nearest with k about
// 2^(D + 1) 3 log n, which soon is every node of the tree, or for those in a radius (RADIUS).

#include "common/NoGoal.h"

#include "ompl_certificates/neighbors/PlannerKdTree.h"
#include "ompl_certificates/neighbors/PlannerNeighbors.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/team/TeamStateSpace.h"

#include <benchmark/benchmark.h>
#include <chrono>
#include <ctime>
#include <memory>
#include <ompl/base/Goal.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/datastructures/NearestNeighborsGNATNoThreadSafety.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <string>
#include <type_traits>
#include <vector>

using namespace ompl_certificates;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    TeamStateSpacePtr discs(unsigned int count)
    {
        ob::RealVectorBounds bounds(2);
        bounds.setLow(0.0);
        bounds.setHigh(100.0);
        auto team = std::make_shared<TeamStateSpace>();
        for (unsigned int i = 0; i < count; ++i)
            team->addRobot(RigidRobot::disc(std::to_string(i), 0.1, bounds));
        team->setup();
        return team;
    }

    struct Motion
    {
        ob::State *state;
    };

    /** RRT's default in a metric space */
    template <typename T>
    using Gnat = ompl::NearestNeighborsGNATNoThreadSafety<T>;

    template <template <typename> class Neighbors>
    void nearestAndAdd(benchmark::State &run)
    {
        using Clock = std::chrono::steady_clock;
        const auto team = discs(static_cast<unsigned int>(run.range(0)));
        const auto count = static_cast<std::size_t>(run.range(1));
        ompl::RNG::setSeed(1);
        const auto sampler = team->allocStateSampler();
        std::vector<Motion> motions(count);
        for (auto &motion : motions)
        {
            motion.state = team->allocState();
            sampler->sampleUniform(motion.state);
        }
        Motion query{team->allocState()};
        for (auto _ : run)
        {
            Neighbors<Motion *> neighbors;
            neighbors.setDistanceFunction([&](const Motion *a, const Motion *b)
                                          { return team->distance(a->state, b->state); });
            Clock::duration last{0};
            for (std::size_t i = 0; i < count; ++i)
            {
                sampler->sampleUniform(query.state);
                const auto begin = Clock::now();
                if (i > 0)
                    benchmark::DoNotOptimize(neighbors.nearest(&query));
                neighbors.add(&motions[i]);
                if (i >= count - count / 10)
                    last += Clock::now() - begin;
            }
            run.SetIterationTime(std::chrono::duration<double>(last).count() / static_cast<double>(count / 10));
        }
        team->freeState(query.state);
        for (auto &motion : motions)
            team->freeState(motion.state);
    }

    enum Neighborhood
    {
        K_NEAREST,
        RADIUS
    };

    template <typename Planner, template <typename> class Neighbors, Neighborhood neighborhood>
    void plan(benchmark::State &run)
    {
        const auto team = discs(static_cast<unsigned int>(run.range(0)));
        double vertices = 0.0;
        const auto nearest = std::make_shared<NearestClock>();
        for (auto _ : run)
        {
            ompl::RNG::setSeed(1);
            auto si = std::make_shared<ob::SpaceInformation>(team);
            si->setStateValidityChecker([](const ob::State *) { return true; });
            si->setup();
            auto problem = std::make_shared<ob::ProblemDefinition>(si);
            ob::ScopedState<> start(team);
            start = std::vector<double>(team->getDimension(), 50.0);
            problem->addStartState(start);
            problem->setGoal(std::make_shared<benchmarks::NoGoal>(si));
            problem->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(si));
            Planner planner(si);
            planner.setRange(5.0);
            if constexpr (std::is_same_v<Planner, og::RRTstar>)
                planner.setKNearest(neighborhood == K_NEAREST);
            planner.template setNearestNeighbors<Neighbors>();
            planner.setProblemDefinition(problem);
            planner.setup();
            timeNearest(planner, nearest);
            ob::IterationTerminationCondition condition(static_cast<unsigned int>(run.range(1)));
            const std::clock_t begin = std::clock();
            planner.solve(condition);
            run.SetIterationTime(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
            ob::PlannerData data(si);
            planner.getPlannerData(data);
            vertices = data.numVertices();
        }
        run.counters["vertices"] = vertices;
        run.counters["nearest_ms"] = 1e3 * nearest->getSeconds();
    }

    /** OMPL complains about a seed that is set again, though it takes it. */
    const bool quiet = (ompl::msg::setLogLevel(ompl::msg::LOG_NONE), true);

    void sizes(benchmark::internal::Benchmark *benchmark)
    {
        for (const int robots : {1, 2, 3, 4, 5})
            benchmark->Args({robots, 100000});
        benchmark->Iterations(1)->UseManualTime()->Unit(benchmark::kMicrosecond);
    }

    void plans(benchmark::internal::Benchmark *benchmark)
    {
        for (const int robots : {1, 2, 3, 4, 5})
            benchmark->Args({robots, 100000});
        benchmark->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);
    }

    void optimalPlans(benchmark::internal::Benchmark *benchmark)
    {
        for (const int robots : {1, 2, 3, 4, 5})
            benchmark->Args({robots, 10000});
        benchmark->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);
    }
}

BENCHMARK_TEMPLATE(nearestAndAdd, PlannerKdTree)->Apply(sizes);
BENCHMARK_TEMPLATE(nearestAndAdd, Gnat)->Apply(sizes);
BENCHMARK_TEMPLATE(plan, og::RRTstar, PlannerKdTree, K_NEAREST)->Apply(optimalPlans);
BENCHMARK_TEMPLATE(plan, og::RRTstar, Gnat, K_NEAREST)->Apply(optimalPlans);
BENCHMARK_TEMPLATE(plan, og::RRTstar, PlannerKdTree, RADIUS)->Apply(optimalPlans);
BENCHMARK_TEMPLATE(plan, og::RRTstar, Gnat, RADIUS)->Apply(optimalPlans);
BENCHMARK_TEMPLATE(plan, og::RRT, PlannerKdTree, K_NEAREST)->Apply(plans);
BENCHMARK_TEMPLATE(plan, og::RRT, Gnat, K_NEAREST)->Apply(plans);
