#include "support/Checkers.h"
#include "support/CrowdProblem.h"
#include "support/Message.h"
#include "support/TeamOf.h"

#include "ompl_certificates/neighbors/PlannerKdTree.h"
#include "ompl_certificates/validity/Basic.h"
#include "ompl_certificates/validity/Partial.h"
#include "ompl_certificates/validity/SharedProjection.h"

#include <gtest/gtest.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>
#include <ompl/datastructures/NearestNeighborsGNATNoThreadSafety.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    ObstaclesPtr noObstacles(unsigned int dimension)
    {
        return std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, dimension);
    }

    /** RRT that shows its nearest-neighbor structure */
    struct OpenRrt : ompl::geometric::RRT
    {
        using RRT::RRT;

        template <template <typename> class Structure>
        bool uses() const
        {
            return dynamic_cast<const Structure<Motion *> *>(nn_.get()) != nullptr;
        }
    };
}

TEST(TeamSetup, GivesItsPlannerAKdTreeUnlessToldOtherwise)
{
    const auto team = teamOfDiscs();
    const auto planner = [&](TeamSetup &setup)
    {
        ob::ScopedState<> start(team), goal(team);
        start = std::vector<double>{0.0, 0.0, 3.0, 0.0, -3.0, 0.0};
        goal = std::vector<double>{0.0, 3.0, 3.0, 3.0, -3.0, 3.0};
        setup.setStartAndGoalStates(start, goal);
        const auto rrt = std::make_shared<OpenRrt>(setup.getSpaceInformation());
        setup.setPlanner(rrt);
        return rrt;
    };
    TeamSetup standard(team, noObstacles(2));
    const auto first = planner(standard);
    standard.setup();
    EXPECT_TRUE(first->uses<PlannerKdTree>());
    EXPECT_THROW(standard.setNearestStructure(NearestStructure::GNAT), ompl::Exception);
    EXPECT_TRUE(standard.solve(1.0));
    EXPECT_TRUE(first->uses<PlannerKdTree>());
    const auto second = planner(standard);  // the next planner gets one, too
    standard.setup();
    EXPECT_TRUE(second->uses<PlannerKdTree>());

    TeamSetup gnat(team, noObstacles(2));
    gnat.setNearestStructure(NearestStructure::GNAT);
    const auto stock = planner(gnat);
    gnat.setup();
    EXPECT_TRUE(stock->uses<ompl::NearestNeighborsGNATNoThreadSafety>());

    TeamSetup chosen(team, noObstacles(2));
    const auto linear = planner(chosen);
    linear->setNearestNeighbors<ompl::NearestNeighborsLinear>();
    chosen.setup();
    EXPECT_TRUE(linear->uses<ompl::NearestNeighborsLinear>());

    EXPECT_EQ(allNearestStructures().front(), NearestStructure::KD_TREE);
    for (const NearestStructure structure : allNearestStructures())
        EXPECT_EQ(nearestStructureOf(nameOf(structure)), structure);
    EXPECT_THROW(nearestStructureOf("best"), ompl::Exception);
}

TEST(TeamSetup, PutsCheckerAndMotionValidatorOfTheMethodInPlace)
{
    const auto team = teamOfDiscs();
    for (const Method method : allMethods())
    {
        const TeamSetup setup(team, noObstacles(2), method);
        EXPECT_EQ(setup.getTeamChecker()->getMethod(), method);
        EXPECT_EQ(setup.getSpaceInformation()->getStateValidityChecker(), setup.getTeamChecker());
        EXPECT_EQ(&setup.getTeam(), team.get());
        const auto *validator =
            dynamic_cast<CertificateMotionValidator *>(setup.getSpaceInformation()->getMotionValidator().get());
        ASSERT_NE(validator, nullptr);
        EXPECT_EQ(validator->getMode(), CertificateMotionValidator::DISCRETE);
    }
    EXPECT_EQ(TeamSetup(team, noObstacles(2)).getTeamChecker()->getMethod(), Method::SHARED_PROJECTION);
}

/** RRT leaves detours on the way around the block, which the simplifier takes away. */
TEST(TeamSetup, TellsTheLengthOfTheSimplifiedSolution)
{
    const auto team = teamOf({RigidRobot::disc("disc", 0.1, cubeBounds(2, HALF))});
    TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(1.0, 4.0)}}, 2));
    ob::ScopedState<> start(team), goal(team);
    start = std::vector<double>{-3.0, 0.0};
    goal = std::vector<double>{3.0, 0.0};
    setup.setStartAndGoalStates(start, goal);
    setup.setPlanner(std::make_shared<OpenRrt>(setup.getSpaceInformation()));
    ASSERT_TRUE(setup.solve(10.0));
    const double before = setup.getSolutionPath().length();
    setup.simplifySolution(evaluations(1000));
    EXPECT_LT(setup.getSolutionPath().length(), before);
    EXPECT_EQ(setup.getProblemDefinition()->getSolutions().front().length_, setup.getSolutionPath().length());
}

TEST(TeamSetup, SaysThatItNeedsAGoalOrAPlanner)
{
    const auto team = teamOfDiscs();
    TeamSetup setup(team, noObstacles(2));
    EXPECT_THROW(setup.setup(), ompl::Exception);
    EXPECT_THROW(setup.solve(0.1), ompl::Exception);
    setup.getSpaceInformation()->setup();
    ob::ScopedState<> state(team);
    state = std::vector<double>{0.0, 0.0, 3.0, 0.0, -3.0, 0.0};
    EXPECT_TRUE(setup.getSpaceInformation()->isValid(state.get()));
    setup.setPlanner(std::make_shared<OpenRrt>(setup.getSpaceInformation()));
    EXPECT_NO_THROW(setup.setup());
}

TEST(TeamSetup, KnowsTheNamesOfTheMethods)
{
    EXPECT_EQ(allMethods().size(), 5U);
    EXPECT_EQ(allMethods().front(), Method::FCL);
    for (const Method method : allMethods())
        EXPECT_EQ(methodOf(nameOf(method)), method);
    try
    {
        methodOf("best");
        FAIL() << "accepted";
    }
    catch (const ompl::Exception &error)
    {
        const std::string text = error.what();
        EXPECT_NE(text.find("'best'"), std::string::npos);
        for (const Method method : allMethods())
            EXPECT_NE(text.find(nameOf(method)), std::string::npos);
    }
    EXPECT_NE(messageOf([] { methodOf("shraed"); }).find("; did you mean shared?"), std::string::npos);
}

TEST(TeamSetup, RefusesMissingObstaclesOtherDimensionsAndEmptyTeams)
{
    for (const Method method : allMethods())
    {
        SCOPED_TRACE(nameOf(method));
        EXPECT_THROW(TeamSetup(teamOfDiscs(), nullptr, method), ompl::Exception);
        EXPECT_THROW(TeamSetup(teamOfDiscs(), noObstacles(3), method), ompl::Exception);
        EXPECT_THROW(TeamSetup(spatialTeam(), noObstacles(2), method), ompl::Exception);
        EXPECT_THROW(TeamSetup(std::make_shared<TeamStateSpace>(), noObstacles(2), method), ompl::Exception);
    }
}

TEST(Checkers, RefuseRobotsBeyondTheZIntervalOfTheObstacles)
{
    const auto obstacles = [](const ZInterval &zInterval)
    {
        const Body wall = Body::planarMesh(boxMesh({1.0, 1.0, 9.0}));
        return std::make_shared<FclObstacles>(std::vector<PlacedBody>{{wall}}, 2, zInterval);
    };
    const ZInterval all = planarMeshTeam()->getZInterval();
    EXPECT_NO_THROW(TeamSetup(planarMeshTeam(), obstacles(all)));
    EXPECT_THROW(TeamSetup(planarMeshTeam(), obstacles({all.low, 0.5 * all.high})), ompl::Exception);
    // Primitives have an unbounded z-interval.
    EXPECT_NO_THROW(TeamSetup(teamOfDiscs(), obstacles({})));
    EXPECT_THROW(TeamSetup(teamOfDiscs(), obstacles(all)), ompl::Exception);
    TeamSetup setup(teamOfDiscs(), obstacles({}));
    EXPECT_THROW(setup.getTeamChecker()->changeObstacles({obstacles(all), {}, {}}), ompl::Exception);
}

TEST(Checkers, RefuseSpacesThatAreNotTeams)
{
    const auto si = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::SE2StateSpace>());
    EXPECT_THROW(TeamValidityChecker(si, noObstacles(2)), ompl::Exception);
    EXPECT_THROW(Basic(si, noObstacles(2)), ompl::Exception);
    EXPECT_THROW(Partial(si, noObstacles(2)), ompl::Exception);
    EXPECT_THROW(SharedProjection(si, noObstacles(2)), ompl::Exception);
    EXPECT_THROW(CertificateMotionValidator(nullptr), ompl::Exception);
}

TEST(Checkers, AreAtHomeInAnOrdinarySpaceInformation)
{
    const auto si = std::make_shared<ob::SpaceInformation>(mixedTeam());
    Random random(1);
    const auto checker = std::make_shared<SharedProjection>(si, scatteredObstacles(random, 2, 5));
    si->setStateValidityChecker(checker);
    si->setMotionValidator(std::make_shared<CertificateMotionValidator>(checker));
    EXPECT_NO_THROW(si->setup());
    const auto state = randomState(random, si->getStateSpace());
    EXPECT_EQ(si->isValid(state.get()), checker->describeCollision(state.get()).empty());
}

TEST(Checkers, SayWhichRobotTouchesAnObstacle)
{
    const auto team = teamOfDiscs();
    const auto block =
        std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(1.0, 1.0), planarPose(3.0, 0.0)}}, 2);
    const TeamSetup setup(team, block);
    ob::ScopedState<> state(team);
    state = std::vector<double>{0.0, 0.0, 3.0, 0.0, -4.0, 0.0};
    EXPECT_EQ(setup.getTeamChecker()->describeCollision(state.get()), "robot 'middle' touches an obstacle");
    state = std::vector<double>{0.0, 0.0, 1.0, 0.0, -4.0, 0.0};
    EXPECT_EQ(setup.getTeamChecker()->describeCollision(state.get()), "");
}

TEST(Checkers, KeepTheTeamAsItIs)
{
    const auto team = teamOfDiscs();
    const TeamSetup setup(team, noObstacles(2));
    EXPECT_THROW(team->addRobot(RigidRobot::disc("late", 0.1, cubeBounds(2, HALF))), ompl::Exception);
}

// OMPL's simplifier goes on to goals that are nearer, and knows the goal that it was made with.
TEST(TeamSetup, SimplifiesToTheGoalThatTheProblemHasNow)
{
    const auto team = teamOfDiscs();
    ob::ScopedState<> start(team), old(team), goal(team);
    start = std::vector<double>{0.0, 0.0, 3.0, 0.0, -3.0, 0.0};
    old = std::vector<double>{0.0, 1.0, 3.0, 1.0, -3.0, 1.0};
    goal = std::vector<double>{3.0, 3.0, -3.0, 3.0, 0.0, 3.0};
    for (const bool knowsAnother : {false, true})
        for (unsigned int seed = 1; seed <= 5; ++seed)
        {
            ompl::RNG::setSeed(seed);
            TeamSetup setup(team, noObstacles(2));
            if (knowsAnother)
                setup.setStartAndGoalStates(start, old);
            const auto &problem = setup.getProblemDefinition();
            problem->clearStartStates();
            problem->clearGoal();
            problem->addStartState(start);
            problem->setGoalState(goal);
            setup.setPlanner(std::make_shared<ompl::geometric::RRT>(setup.getSpaceInformation()));
            ASSERT_EQ(setup.solve(evaluations(20000)), ob::PlannerStatus::EXACT_SOLUTION) << seed;
            setup.simplifySolution(evaluations(2000));
            EXPECT_TRUE(setup.getGoal()->isSatisfied(setup.getSolutionPath().getStates().back())) << seed;
        }
}

TEST(TeamSetup, TellsWhetherASimplifiedPathReachesTheGoal)
{
    const auto team = teamOfDiscs();
    ob::ScopedState<> start(team), goal(team);
    start = std::vector<double>{0.0, 0.0, 3.0, 0.0, -3.0, 0.0};
    goal = std::vector<double>{0.0, 3.0, 3.0, 3.0, -3.0, 3.0};
    unsigned int reached = 0;
    for (unsigned int seed = 1; seed <= 20; ++seed)
    {
        ompl::RNG::setSeed(seed);
        TeamSetup setup(team, noObstacles(2));
        setup.setStartAndGoalStates(start, goal);
        const auto rrt = std::make_shared<ompl::geometric::RRT>(setup.getSpaceInformation());
        rrt->setGoalBias(0.0);
        setup.setPlanner(rrt);
        if (setup.solve(evaluations(100)) != ob::PlannerStatus::APPROXIMATE_SOLUTION)
            continue;
        setup.simplifySolution(evaluations(2000));
        double distance = 0.0;
        const bool isReached = setup.getGoal()->isSatisfied(setup.getSolutionPath().getStates().back(), &distance);
        reached += isReached ? 1 : 0;
        EXPECT_EQ(setup.haveExactSolutionPath(), isReached) << seed;
        EXPECT_NEAR(setup.getProblemDefinition()->getSolutionDifference(), isReached ? 0.0 : distance, 1e-9) << seed;
        EXPECT_EQ(setup.getLastPlannerStatus(),
                  isReached ? ob::PlannerStatus::EXACT_SOLUTION : ob::PlannerStatus::APPROXIMATE_SOLUTION)
            << seed;
    }
    EXPECT_GT(reached, 0U);
}
