#include "support/Checkers.h"

#include "ompl_certificates/validity/SharedProjection.h"

#include <atomic>
#include <gtest/gtest.h>
#include <memory>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/geometric/planners/cforest/CForest.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/pRRT.h>
#include <ompl/util/Console.h>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

/** What the sanitizer of threads leaves out. A thread of CForest that finds a path gives its states to the samplers of
    the others, and OMPL 1.5.2 does not keep it from doing so while another one is just being made. */
extern "C" const char *__tsan_default_suppressions();
extern "C" const char *__tsan_default_suppressions()
{
    return "race:ompl::base::CForestStateSampler::setStatesToSample\n";
}

namespace
{
    /** The setup of a team in these tests */
    struct Plan
    {
        explicit Plan(std::uint64_t seed)
        {
            ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
            Random random(seed);
            const auto team = teamOfDiscs();
            setup = std::make_shared<TeamSetup>(team, scatteredObstacles(random, 2, 10));
            setup->getStateSpace()->setLongestValidSegmentFraction(0.02);
            si()->setup();  // otherwise motions have no samples
            setup->getTeamChecker()->setAdaptive(false);
            do
            {
                start = std::make_unique<ob::ScopedState<>>(randomState(random, team));
                goal = std::make_unique<ob::ScopedState<>>(randomState(random, team));
            } while (!setup->getTeamChecker()->isValid(start->get()) ||
                     !setup->getTeamChecker()->isValid(goal->get()) || si()->checkMotion(start->get(), goal->get()));
            setup->setStartAndGoalStates(*start, *goal, 1e-9);
            // No path is good enough, so planners that optimise use up their time.
            const auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(si());
            objective->setCostThreshold(ob::Cost(0.0));
            setup->setOptimizationObjective(objective);
            setup->getStatistics().reset();
        }

        const ob::SpaceInformationPtr &si() const
        {
            return setup->getSpaceInformation();
        }

        /** Plan for a while, then verify the solution by the standard check. */
        void solveWith(const ob::PlannerPtr &planner, double seconds)
        {
            setup->setPlanner(planner);
            setup->setup();
            setup->solve(seconds);
            ASSERT_GT(setup->getTeamChecker()->getCertificateCount(), 10U);
            const CheckCounts counts = setup->getStatistics().getCounts();
            EXPECT_EQ(counts.robotPoses, counts.certifiedFree + counts.certifiedColliding + counts.asked);
            EXPECT_GT(counts.certifiedFree, counts.asked);
            const TeamSetup standard(std::static_pointer_cast<TeamStateSpace>(setup->getStateSpace()), obstacles(),
                                     Method::STANDARD);
            standard.getSpaceInformation()->setup();
            ob::PlannerData data(si());
            setup->getPlannerData(data);
            std::vector<const ob::State *> states;
            for (unsigned int i = 0; i < data.numVertices(); ++i)
                states.push_back(data.getVertex(i).getState());
            if (setup->getProblemDefinition()->hasSolution())
                for (const ob::State *state : setup->getSolutionPath().getStates())
                    states.push_back(state);
            EXPECT_GT(states.size(), 2U);
            for (const ob::State *state : states)
                EXPECT_TRUE(standard.getTeamChecker()->isValid(state));
        }

        ObstaclesPtr obstacles() const
        {
            // The checker keeps them alive.
            return {ObstaclesPtr(), &setup->getTeamChecker()->getObstacles()};
        }

        TeamSetupPtr setup;
        std::unique_ptr<ob::ScopedState<>> start, goal;
    };

    constexpr double SECONDS = 0.4;
}

TEST(PlannersOnThreads, CForest)
{
    Plan plan(1);
    auto planner = std::make_shared<og::CForest>(plan.si());
    planner->setNumThreads(3);       // of RRT*
    planner->setFocusSearch(false);  // OMPL knows this for a few spaces of its own only
    plan.solveWith(planner, SECONDS);
    // It plans in spaces that wrap the team's, of which pictures and files know nothing.
    EXPECT_EQ(plan.setup->getSolutionPath().getSpaceInformation(), plan.si());
    EXPECT_TRUE(plan.setup->getSolutionPath().check());
}

TEST(PlannersOnThreads, ParallelRRT)
{
    Plan plan(2);
    auto planner = std::make_shared<og::pRRT>(plan.si());
    planner->setThreadCount(3);
    plan.solveWith(planner, SECONDS);
}

TEST(PlannersOnThreads, AnytimePathShortening)
{
    Plan plan(3);
    auto planner = std::make_shared<og::AnytimePathShortening>(plan.si());
    for (int i = 0; i < 3; ++i)
    {
        ob::PlannerPtr one = std::make_shared<og::RRTConnect>(plan.si());
        planner->addPlanner(one);
    }
    plan.solveWith(planner, SECONDS);
}

TEST(PlannersOnThreads, PRM)
{
    // This planner searches in a thread of its own.
    Plan plan(4);
    plan.solveWith(std::make_shared<og::PRM>(plan.si()), SECONDS);
}

/** What one thread learns serves the others: together they ask the obstacles hardly more often than one thread that
    makes all their checks. */
TEST(PlannersOnThreads, LearnFromEachOther)
{
    for (unsigned int seed = 0; seed < scaled(5); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto team = teamOfDiscs();
        const auto obstacles = scatteredObstacles(random, 2, 10);
        std::vector<ob::ScopedState<>> states;
        for (unsigned int i = 0; i < 2000; ++i)
            states.push_back(randomState(random, team));
        const auto exactOf = [&](unsigned int threads, bool shared)
        {
            std::vector<TeamSetupPtr> setups;
            for (unsigned int i = 0; i < (shared ? 1 : threads); ++i)
            {
                setups.push_back(std::make_shared<TeamSetup>(team, obstacles));
                setups.back()->getTeamChecker()->setAdaptive(false);
            }
            std::vector<std::thread> running;
            for (unsigned int thread = 0; thread < threads; ++thread)
                running.emplace_back(
                    [&, thread]
                    {
                        const auto &checker = *setups[shared ? 0 : thread]->getTeamChecker();
                        // Each thread in another order: states with their own references
                        ob::ScopedState<> copy(team);
                        for (unsigned int k = 0; k < states.size(); ++k)
                        {
                            team->copyState(copy.get(), states[(k * 7 + 500 * thread) % states.size()].get());
                            team->clearReferences(copy.get());
                            checker.isValid(copy.get());
                        }
                    });
            for (auto &thread : running)
                thread.join();
            std::uint64_t exact = 0;
            for (const auto &setup : setups)
                exact += setup->getStatistics().getCounts().asked;
            return exact;
        };
        const std::uint64_t alone = exactOf(1, true), together = exactOf(4, true), apart = exactOf(4, false);
        EXPECT_GT(apart, 3 * alone);
        EXPECT_LT(together, 2 * alone);
    }
}
