#include "ompl_certificates/planning/Planners.h"
#include "support/Checkers.h"
#include "support/ErrorsOnly.h"
#include "support/IterationLimit.h"
#include "support/Quiet.h"

#include <gtest/gtest.h>
#include <map>
#include <ompl/base/PlannerData.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** Take all further random numbers from \e seed. OMPL calls that an error if others were drawn before. */
    void reseed(unsigned int seed)
    {
        const Quiet quiet;
        ompl::RNG::setSeed(seed);
    }

    /** The outcome of a planner */
    struct Result
    {
        std::vector<std::vector<double>> states;
        std::vector<std::vector<unsigned int>> edges;
        std::vector<std::vector<double>> path;
        bool solved;

        bool operator==(const Result &other) const
        {
            return states == other.states && edges == other.edges && path == other.path && solved == other.solved;
        }
    };

    struct Problem
    {
        TeamStateSpacePtr team;
        ObstaclesPtr obstacles;
        std::vector<double> start, goal;
    };

    Problem randomProblem(unsigned int seed, unsigned int kind)
    {
        Random random(seed);
        Problem problem;
        problem.team = anyTeam(kind);
        problem.obstacles = anyObstacles(random, kind, 8);
        const Checkers checkers(problem.team, problem.obstacles);
        for (auto *reals : {&problem.start, &problem.goal})
        {
            auto state = randomState(random, problem.team);
            while (!checkers.isValid(state.get()))
                state = randomState(random, problem.team);
            *reals = state.reals();
        }
        return problem;
    }

    Result plan(const Problem &problem, Method method, const std::string &plannerName, unsigned int seed,
                unsigned int iterations)
    {
        reseed(seed);
        TeamSetup setup(problem.team, problem.obstacles, method);
        // Some plans begin without certificates, as they do by default.
        setup.getTeamChecker()->setCertificatesAfter(seed % 2 == 0 ? 8192 : 0);
        ob::ScopedState<> start(problem.team), goal(problem.team);
        start = problem.start;
        goal = problem.goal;
        setup.setStartAndGoalStates(start, goal);
        setup.getSpaceInformation()->setStateValidityCheckingResolution(0.005);
        const auto planner = makePlanner(plannerName, setup.getSpaceInformation());
        setup.setPlanner(planner);
        setup.setup();
        ob::IterationTerminationCondition condition(iterations);
        setup.solve(ob::PlannerTerminationCondition(condition));

        Result result;
        ob::PlannerData data(setup.getSpaceInformation());
        planner->getPlannerData(data);
        for (unsigned int i = 0; i < data.numVertices(); ++i)
        {
            result.states.push_back(realsOf(*problem.team, data.getVertex(i).getState()));
            std::vector<unsigned int> edges;
            data.getEdges(i, edges);
            std::sort(edges.begin(), edges.end());
            result.edges.push_back(edges);
        }
        result.solved = setup.haveSolutionPath();
        if (result.solved)
            for (const ob::State *state : setup.getSolutionPath().getStates())
                result.path.push_back(realsOf(*problem.team, state));
        const CheckCounts counts = setup.getStatistics().getCounts();
        EXPECT_EQ(counts.robotPoses, counts.certifiedFree + counts.certifiedColliding + counts.asked);
        EXPECT_EQ(counts.motionSamples > 0, counts.motions > 0);
        EXPECT_LE(counts.motionSamplesSkipped, counts.motionSamples);
        EXPECT_LE(counts.askedColliding, counts.asked);
        EXPECT_GT(counts.robotPoses, 0U);
        return result;
    }
}

class Trees : public ErrorsOnly<std::string>
{
};

TEST_P(Trees, AreTheSameUnderAllMethods)
{
    const unsigned int iterations = GetParam() == "RRTstar" ? 250 : 700;
    std::size_t nodes = 0;
    unsigned int solved = 0, runs = 0;
    for (unsigned int seed = 1; seed <= scaled(3); ++seed)
        for (unsigned int kind = 0; kind < TEAMS; ++kind)
        {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", team " + std::to_string(kind));
            const Problem problem = randomProblem(seed, kind);
            const Result standard = plan(problem, Method::FCL, GetParam(), seed, iterations);
            nodes += standard.states.size();
            solved += standard.solved ? 1 : 0;
            ++runs;
            for (const Method method : allMethods())
            {
                const Result result = plan(problem, method, GetParam(), seed, iterations);
                ASSERT_EQ(result.states.size(), standard.states.size()) << nameOf(method);
                ASSERT_TRUE(result == standard) << nameOf(method);
            }
        }
    EXPECT_GT(nodes, runs * 5U);
    RecordProperty("nodes", static_cast<int>(nodes));
    RecordProperty("solved", static_cast<int>(solved));
}

TEST_P(Trees, DifferFromSeedToSeed)
{
    // Otherwise the test above would compare nothing.
    const Problem problem = randomProblem(1, 0);
    EXPECT_FALSE(plan(problem, Method::STANDARD, GetParam(), 1, 200) ==
                 plan(problem, Method::STANDARD, GetParam(), 2, 200));
}

INSTANTIATE_TEST_SUITE_P(Planner, Trees, testing::Values("RRT", "RRTConnect", "RRTstar", "EST", "KPIECE1"),
                         [](const auto &tested) { return tested.param; });
