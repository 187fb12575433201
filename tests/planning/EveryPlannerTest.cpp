// Each of OMPL's geometric planners runs in a TeamSetup without special settings. Planners that need more than a space
// and a problem are left out. TSRRT needs a task space, VFRRT a vector field, XXL a decomposition of the space, QRRT a
// sequence of spaces. LightningRetrieveRepair and ThunderRetrieveRepair need a database of plans.

#include "support/ForgivenLeaks.h"
#include "support/Quiet.h"
#include "support/Teams.h"

#include "ompl_certificates/planning/DRRTstar.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/team/TeamObjective.h"
#include "ompl_certificates/team/TeamPathLength.h"

#include <atomic>
#include <gtest/gtest.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/geometric/planners/cforest/CForest.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/est/ProjEST.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/pdst/PDST.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/prm/SPARS.h>
#include <ompl/geometric/planners/prm/SPARStwo.h>
#include <ompl/geometric/planners/rlrt/BiRLRT.h>
#include <ompl/geometric/planners/rlrt/RLRT.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/LBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyLBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTXstatic.h>
#include <ompl/geometric/planners/rrt/RRTsharp.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/SORRTstar.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/geometric/planners/rrt/pRRT.h>
#include <ompl/geometric/planners/sbl/SBL.h>
#include <ompl/geometric/planners/sbl/pSBL.h>
#include <ompl/geometric/planners/sst/SST.h>
#include <ompl/geometric/planners/stride/STRIDE.h>
#include <ompl/tools/benchmark/Benchmark.h>
#include <ompl/util/Exception.h>
#include <ompl/util/RandomNumbers.h>
#include <set>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    using Allocator = ob::PlannerPtr (*)(const ob::SpaceInformationPtr &);

    struct Named
    {
        const char *name;
        Allocator make;

        friend std::ostream &operator<<(std::ostream &out, const Named &planner)
        {
            return out << planner.name;
        }
    };

    template <typename Planner>
    ob::PlannerPtr make(const ob::SpaceInformationPtr &si)
    {
        return std::make_shared<Planner>(si);
    }

    const Named PLANNERS[] = {{"ABITstar", make<og::ABITstar>},
                              {"AITstar", make<og::AITstar>},
                              {"AnytimePathShortening", make<og::AnytimePathShortening>},
                              {"BFMT", make<og::BFMT>},
                              {"BITstar", make<og::BITstar>},
                              {"BKPIECE1", make<og::BKPIECE1>},
                              {"BiEST", make<og::BiEST>},
                              {"BiRLRT", make<og::BiRLRT>},
                              {"BiTRRT", make<og::BiTRRT>},
                              {"CForest", make<og::CForest>},
                              {"DRRTstar", make<DRRTstar>},
                              {"EST", make<og::EST>},
                              {"FMT", make<og::FMT>},
                              {"InformedRRTstar", make<og::InformedRRTstar>},
                              {"KPIECE1", make<og::KPIECE1>},
                              {"LBKPIECE1", make<og::LBKPIECE1>},
                              {"LBTRRT", make<og::LBTRRT>},
                              {"LazyLBTRRT", make<og::LazyLBTRRT>},
                              {"LazyPRM", make<og::LazyPRM>},
                              {"LazyPRMstar", make<og::LazyPRMstar>},
                              {"LazyRRT", make<og::LazyRRT>},
                              {"PDST", make<og::PDST>},
                              {"PRM", make<og::PRM>},
                              {"PRMstar", make<og::PRMstar>},
                              {"ProjEST", make<og::ProjEST>},
                              {"RLRT", make<og::RLRT>},
                              {"RRT", make<og::RRT>},
                              {"RRTConnect", make<og::RRTConnect>},
                              {"RRTXstatic", make<og::RRTXstatic>},
                              {"RRTsharp", make<og::RRTsharp>},
                              {"RRTstar", make<og::RRTstar>},
                              {"SBL", make<og::SBL>},
                              {"SORRTstar", make<og::SORRTstar>},
                              {"SPARS", make<og::SPARS>},
                              {"SPARStwo", make<og::SPARStwo>},
                              {"SST", make<og::SST>},
                              {"STRIDE", make<og::STRIDE>},
                              {"TRRT", make<og::TRRT>},
                              {"pRRT", make<og::pRRT>},
                              {"pSBL", make<og::pSBL>}};

    /** A disc and a box that change sides past a post */
    TeamSetupPtr easyProblem(TeamStateSpace::Metric metric = TeamStateSpace::EUCLIDEAN)
    {
        auto team = std::make_shared<TeamStateSpace>(metric);
        team->addRobot(RigidRobot::disc("disc", 0.3, cubeBounds(2, 2.0)));
        team->addRobot(RigidRobot::inSE2("box", Body::box(0.5, 0.3), cubeBounds(2, 2.0)));
        auto setup = std::make_shared<TeamSetup>(
            team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::disc(0.2)}}, 2));
        ob::ScopedState<> start(team), goal(team);
        start = std::vector<double>{-1.0, 0.5, 1.0, -1.0, 0.0};
        goal = std::vector<double>{1.0, 0.8, -1.0, -1.0, 0.5};
        setup->setStartAndGoalStates(start, goal, 0.8);
        return setup;
    }

    class EveryPlanner : public testing::TestWithParam<Named>
    {
        const Quiet quiet_;

    protected:
        void expectToSolve(TeamStateSpace::Metric metric)
        {
            // These leak states in OMPL 1.5.2: they clone goals, samples and propagations that they never free.
            static const std::set<std::string> leaking{"LazyLBTRRT", "LazyPRM", "LazyPRMstar", "SORRTstar", "SST"};
            const ForgivenLeaks forgiven(leaking.count(GetParam().name) > 0);
            ompl::RNG::setSeed(1);
            const auto setup = easyProblem(metric);
            setup->setPlanner(GetParam().make(setup->getSpaceInformation()));
            // Mostly the first time is enough; the others are for a busy machine. Iterations are limited because OMPL's
            // LazyLBTRRT fails an assertion of its own after some random numbers. FMT starts from scratch each time,
            // with all its samples.
            const double seconds = std::string(GetParam().name).find("FMT") == std::string::npos ? 0.2 : 2.0;
            const auto end = ompl::time::now() + ompl::time::seconds(10.0);
            while (!setup->haveExactSolutionPath() && ompl::time::now() < end)
            {
                std::atomic<unsigned int> left{3000};
                const ob::PlannerTerminationCondition condition([&left] { return left == 0 || --left == 0; });
                ASSERT_NO_THROW(setup->solve(
                    ob::plannerOrTerminationCondition(condition, ob::timedPlannerTerminationCondition(seconds))));
            }
            ASSERT_TRUE(setup->haveExactSolutionPath());
            EXPECT_TRUE(setup->getSolutionPath().check());
        }
    };
}

TEST_P(EveryPlanner, SolvesAnEasyProblemInATeamSetup)
{
    expectToSolve(TeamStateSpace::EUCLIDEAN);
}

TEST_P(EveryPlanner, SolvesItInTheMetricOfACompoundStateSpace)
{
    expectToSolve(TeamStateSpace::SUM);
}

INSTANTIATE_TEST_SUITE_P(Ompl, EveryPlanner, testing::ValuesIn(PLANNERS),
                         [](const auto &test) { return std::string(test.param.name); });

/** BIT* finds no plan without a lower bound of the cost to the goal. */
TEST(EveryCost, IsLoweredByPlannersThatLookAhead)
{
    const Quiet quiet;
    for (const std::string &cost : objectiveNames())
        for (const Allocator planner : {Allocator(make<og::BITstar>), Allocator(make<og::ABITstar>)})
        {
            SCOPED_TRACE(cost);
            ompl::RNG::setSeed(1);
            auto team = std::make_shared<TeamStateSpace>();
            team->addRobot(RigidRobot::disc("disc", 0.5, cubeBounds(2, 6.0)));
            const auto setup = std::make_shared<TeamSetup>(
                team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(2.0, 6.0)}}, 2));
            const auto &si = setup->getSpaceInformation();
            setup->setPlanner(planner(si));
            setup->getPlanner()->params().setParam("stop_on_each_solution_improvement", "1");
            ob::ScopedState<> start(team), goal(team);
            start = std::vector<double>{-4.0, 0.0};
            goal = std::vector<double>{4.0, 0.0};
            setup->setStartAndGoalStates(start, goal);
            setup->setOptimizationObjective(makeObjective(cost, si, goal));
            setup->solve(10.0);
            ASSERT_TRUE(setup->haveExactSolutionPath());
            EXPECT_TRUE(setup->getSolutionPath().check());
        }
}

TEST(TeamObjective, IsThePathLengthUnlessThePlannerDoesSomethingElseWithout)
{
    const Quiet quiet;
    const auto setup = easyProblem();
    const auto &si = setup->getSpaceInformation();
    const auto objectiveWith = [&](const ob::PlannerPtr &planner)
    {
        setup->setPlanner(planner);
        setup->setup();
        return dynamic_cast<TeamPathLength *>(setup->getOptimizationObjective().get());
    };
    EXPECT_NE(objectiveWith(std::make_shared<og::BITstar>(si)), nullptr);
    EXPECT_EQ(objectiveWith(std::make_shared<og::PRM>(si)), nullptr);
    EXPECT_FALSE(setup->getProblemDefinition()->hasOptimizationObjective());
    EXPECT_NE(objectiveWith(std::make_shared<og::RRTstar>(si)), nullptr);
    EXPECT_EQ(objectiveWith(std::make_shared<og::LazyPRM>(si)), nullptr);
    EXPECT_EQ(objectiveWith(std::make_shared<og::TRRT>(si)), nullptr);
    EXPECT_EQ(objectiveWith(std::make_shared<og::BiTRRT>(si)), nullptr);
    EXPECT_NE(objectiveWith(std::make_shared<og::CForest>(si)), nullptr);

    // Without a planner, and with one that is set late
    const auto unplanned = easyProblem();
    unplanned->setup();
    EXPECT_NE(dynamic_cast<TeamPathLength *>(unplanned->getOptimizationObjective().get()), nullptr);
    const auto late = easyProblem();
    late->setPlannerAllocator([](const ob::SpaceInformationPtr &space) { return std::make_shared<og::PRM>(space); });
    late->setup();
    EXPECT_EQ(late->getPlanner()->getName(), "PRM");
    EXPECT_FALSE(late->getProblemDefinition()->hasOptimizationObjective());

    const auto chosen = std::make_shared<ob::MaximizeMinClearanceObjective>(si);
    setup->setOptimizationObjective(chosen);
    objectiveWith(std::make_shared<og::RRTstar>(si));
    EXPECT_EQ(setup->getOptimizationObjective(), chosen);
    objectiveWith(std::make_shared<og::PRM>(si));
    EXPECT_EQ(setup->getOptimizationObjective(), chosen);
}

/** It sets up its planners before it sets up the setup. */
TEST(TeamObjective, IsThereForPlannersOfOmplsBenchmark)
{
    const Quiet quiet;
    const auto setup = easyProblem();
    const auto &si = setup->getSpaceInformation();
    ompl::tools::Benchmark benchmark(*setup, "all");
    const std::vector<ob::PlannerPtr> planners{std::make_shared<og::RRTstar>(si),
                                               std::make_shared<og::InformedRRTstar>(si),
                                               std::make_shared<og::BITstar>(si)};
    for (const ob::PlannerPtr &planner : planners)
        benchmark.addPlanner(planner);
    unsigned int replaced = 0;
    benchmark.setPreRunEvent(
        [&](const ob::PlannerPtr &planner)
        {
            setup->prepare(*planner);
            replaced += useKdTree(*planner) ? 1 : 0;
        });
    benchmark.benchmark({0.1, 1000.0, 1, 0.05, false, false, false});
    EXPECT_EQ(replaced, 0U) << "GNATs were left";
    for (const auto &planner : benchmark.getRecordedExperimentData().planners)
        EXPECT_EQ(planner.runs.at(0).at("solved BOOLEAN"), "1") << planner.name;
    for (const ob::PlannerPtr &planner : planners)
        EXPECT_NE(dynamic_cast<TeamPathLength *>(planner->getProblemDefinition()->getOptimizationObjective().get()),
                  nullptr);
    EXPECT_THROW(setup->prepare(*std::make_shared<og::RRT>(easyProblem()->getSpaceInformation())), ompl::Exception);
}

TEST(TeamObjective, LetsPrmStopAtItsFirstSolution)
{
    const Quiet quiet;
    const auto setup = easyProblem();
    setup->setPlanner(std::make_shared<og::PRM>(setup->getSpaceInformation()));
    EXPECT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_LT(setup->getLastPlanComputationTime(), 30.0);
}

TEST(TeamObjective, SamplesWhatCanImproveASolutionInBothMetrics)
{
    for (const auto metric : {TeamStateSpace::EUCLIDEAN, TeamStateSpace::SUM})
    {
        auto team = std::make_shared<TeamStateSpace>(metric);
        team->addRobot(RigidRobot::disc("disc", 0.3, cubeBounds(2, 2.0)), 3.0);
        team->addRobot(RigidRobot::inSE2("box", Body::box(0.5, 0.3), cubeBounds(2, 2.0)), 0.5);
        const auto si = std::make_shared<ob::SpaceInformation>(team);
        si->setStateValidityChecker([](const ob::State *) { return true; });
        si->setup();
        const auto problem = std::make_shared<ob::ProblemDefinition>(si);
        ob::ScopedState<> start(team), goal(team), state(team);
        start = std::vector<double>{-1.0, 0.5, 1.0, -1.0, 0.0};
        goal = std::vector<double>{1.0, 0.8, -1.0, -1.0, 0.5};
        problem->setStartAndGoalStates(start, goal);
        problem->setOptimizationObjective(std::make_shared<TeamPathLength>(si));
        const double most = 1.5 * team->distance(start.get(), goal.get());
        const auto sampler = problem->getOptimizationObjective()->allocInformedStateSampler(problem, 10000);
        double longest = 0.0;
        for (int i = 0; i < 200; ++i)
        {
            ASSERT_TRUE(sampler->sampleUniform(state.get(), ob::Cost(most)));
            const double length = team->distance(start.get(), state.get()) + team->distance(state.get(), goal.get());
            EXPECT_LT(length, most);
            longest = std::max(longest, length);
        }
        EXPECT_GT(longest, 0.95 * most);
    }
}

TEST(TeamObjective, CostsWhatOmplsOwnPathLengthCosts)
{
    for (const auto metric : {TeamStateSpace::EUCLIDEAN, TeamStateSpace::SUM})
    {
        const auto setup = easyProblem(metric);
        const auto &si = setup->getSpaceInformation();
        const auto &problem = setup->getProblemDefinition();
        si->setup();
        const TeamPathLength ours(si);
        const ob::PathLengthOptimizationObjective ompls(si);
        Random random(1);
        for (unsigned int i = 0; i < 100; ++i)
        {
            const auto a = randomState(random, si->getStateSpace()), b = randomState(random, si->getStateSpace());
            EXPECT_EQ(ours.motionCost(a.get(), b.get()).value(), ompls.motionCost(a.get(), b.get()).value());
            EXPECT_EQ(ours.stateCost(a.get()).value(), ompls.stateCost(a.get()).value());
            EXPECT_EQ(ours.costToGo(a.get(), problem->getGoal().get()).value(),
                      ompls.costToGo(a.get(), problem->getGoal().get()).value());
        }
        EXPECT_EQ(ours.getCostThreshold().value(), ompls.getCostThreshold().value());
    }
}
