#include "ompl_certificates/neighbors/PlannerNeighbors.h"
#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/planning/Planners.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/pictures/PlanReport.h"
#include "support/Quiet.h"
#include "support/Random.h"

#include <gtest/gtest.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/util/RandomNumbers.h>
#include <set>
#include <thread>

using namespace ompl_certificates;
using ompl_certificates::test::Quiet;
using ompl_certificates::test::scaled;
namespace ob = ompl::base;

namespace
{
    TeamSetupPtr discAndBoxAmongColumns(NearestStructure structure)
    {
        ob::RealVectorBounds bounds(2);
        bounds.setLow(0.0);
        bounds.setHigh(10.0);
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(RigidRobot::disc("disc", 0.3, bounds));
        team->addRobot(RigidRobot::inSE2("box", Body::box(0.7, 0.3), bounds), 2.0);
        std::vector<PlacedBody> columns;
        for (int i = 0; i < 16; ++i)
            columns.push_back({Body::box(0.8, 0.8), planarPose(1.5 + 2.3 * (i % 4), 1.5 + 2.3 * (i / 4), 0.3 * i)});
        auto setup = std::make_shared<TeamSetup>(team, std::make_shared<FclObstacles>(columns, 2));
        ob::ScopedState<> start(team), goal(team);
        start = std::vector<double>{0.5, 0.5, 9.5, 0.5, 1.0};
        goal = std::vector<double>{9.5, 9.5, 0.5, 9.5, -3.0};
        setup->setStartAndGoalStates(start, goal);
        setup->setNearestStructure(structure);
        return setup;
    }

    struct Grown
    {
        PlanReport report;
        bool timed{false};
        double nearestSeconds{0.0};
    };

    Grown grow(const std::string &name, NearestStructure structure, unsigned int iterations)
    {
        ompl::RNG::setSeed(3);
        const auto setup = discAndBoxAmongColumns(structure);
        const ob::PlannerPtr planner = makePlanner(name, setup->getSpaceInformation());
        // Without an objective PRM ends when another thread notices that it may.
        if (name == "PRM")
            setup->setOptimizationObjective(
                std::make_shared<ob::PathLengthOptimizationObjective>(setup->getSpaceInformation()));
        // Trees depend on the seed alone only with one thread …
        for (const char *threads : {"thread_count", "num_threads"})
            if (planner->params().hasParam(threads))
                planner->params().setParam(threads, "1");
        setup->setPlanner(planner);
        setup->setup();
        Grown grown;
        const auto clock = std::make_shared<NearestClock>();
        grown.timed = timeNearest(*planner, clock);
        // … and if the end does not depend on another thread that merely waits for it, as roadmap planners' threads do.
        unsigned int left = iterations;
        const auto here = std::this_thread::get_id();
        const bool threaded = name == "pRRT" || name == "pSBL" || name == "CForest";
        const ob::PlannerTerminationCondition condition(
            [&] { return left == 0 || ((threaded || std::this_thread::get_id() == here) && --left == 0); });
        setup->solve(condition);
        ob::PlannerData tree(setup->getSpaceInformation());
        planner->getPlannerData(tree);
        grown.report.setTree(tree);
        grown.nearestSeconds = clock->getSeconds();
        return grown;
    }

    class EveryPlanner : public testing::TestWithParam<std::string>
    {
    };
}

TEST_P(EveryPlanner, GrowsTheSameTreeWithTheKdTreeAndWithGnat)
{
    const Quiet quiet;
    // These grow their roadmaps by the clock, for 0.4 seconds, and then expand them.
    const bool isByTheClock = GetParam() == "PRM" || GetParam() == "PRMstar";
    const unsigned int iterations = scaled(isByTheClock ? 300 : 1500);
    const auto kdTree = grow(GetParam(), NearestStructure::KD_TREE, iterations);
    const auto gnat = grow(GetParam(), NearestStructure::GNAT, iterations);
    // It shows none of its planners' trees, and shortens paths until it is stopped.
    if (GetParam() != "AnytimePathShortening")
    {
        EXPECT_GT(gnat.report.treeStates, 1U);
        EXPECT_EQ(kdTree.report.treeStates, gnat.report.treeStates);
        EXPECT_EQ(kdTree.report.digest, gnat.report.digest);
    }

    // These work with grids or structures of their own.
    static const std::set<std::string> others{"ABITstar", "AITstar",  "AnytimePathShortening",
                                              "BITstar",  "BKPIECE1", "BiRLRT",
                                              "DRRTstar", "KPIECE1",  "LBKPIECE1",
                                              "PDST",     "ProjEST",  "RLRT",
                                              "SBL",      "STRIDE",   "pSBL"};
    EXPECT_EQ(kdTree.timed, others.count(GetParam()) == 0);
    EXPECT_EQ(kdTree.timed, gnat.timed);
    EXPECT_EQ(kdTree.timed, kdTree.nearestSeconds > 0.0);
    EXPECT_EQ(gnat.timed, gnat.nearestSeconds > 0.0);
}

INSTANTIATE_TEST_SUITE_P(Planners, EveryPlanner, testing::ValuesIn(plannerNames()),
                         [](const auto &planner) { return planner.param; });
