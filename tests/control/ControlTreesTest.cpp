#include "DynamicProblems.h"

#include "support/ForgivenLeaks.h"
#include "support/IterationLimit.h"
#include "support/Message.h"
#include "support/Quiet.h"
#include "support/Random.h"
#include "support/Warnings.h"

#include "ompl_certificates/obstacles/ObstacleSet.h"
#include "ompl_certificates/validity/Revalidation.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/control/PlannerData.h>
#include <ompl/control/planners/est/EST.h>
#include <ompl/control/planners/kpiece/KPIECE1.h>
#include <ompl/control/planners/pdst/PDST.h>
#include <ompl/control/planners/rrt/RRT.h>
#include <ompl/control/planners/sst/SST.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace oc = ompl::control;

namespace
{
    using Mode = CertificateMotionValidator::Mode;

    ob::PlannerPtr makePlanner(const std::string &name, const oc::SpaceInformationPtr &si)
    {
        if (name == "SST")
            return std::make_shared<oc::SST>(si);
        if (name == "EST")
            return std::make_shared<oc::EST>(si);
        if (name == "KPIECE1")
            return std::make_shared<oc::KPIECE1>(si);
        if (name == "PDST")
            return std::make_shared<oc::PDST>(si);
        return std::make_shared<oc::RRT>(si);
    }

    /** The states and edges of the tree that a planner grows */
    std::vector<std::vector<double>> treeOf(TeamControlSetup &setup, const std::string &planner, unsigned int seed,
                                            unsigned int iterations)
    {
        const Quiet quiet;
        ompl::RNG::setSeed(seed);
        setup.setPlanner(makePlanner(planner, setup.getSpaceInformation()));
        setup.setup();
        ob::IterationTerminationCondition limit(iterations);
        {
            // OMPL's SST forgets some of its witnesses.
            const ForgivenLeaks forgiven(planner == "SST");
            setup.solve(limit);
        }
        ob::PlannerData data(setup.getSpaceInformation());
        setup.getPlanner()->getPlannerData(data);
        std::vector<std::vector<double>> tree;
        for (unsigned int i = 0; i < data.numVertices(); ++i)
        {
            tree.emplace_back();
            setup.getStateSpace()->copyToReals(tree.back(), data.getVertex(i).getState());
            std::vector<unsigned int> edges;
            data.getEdges(i, edges);
            tree.back().insert(tree.back().end(), edges.begin(), edges.end());
        }
        return tree;
    }
}

namespace
{
    /** The edges of a tree, from state to state, in an order that does not depend on the structure */
    std::vector<std::vector<double>> edgesOf(const std::vector<std::vector<double>> &tree, std::size_t coordinates)
    {
        const auto begin = [&](std::size_t vertex) { return tree[vertex].begin(); };
        std::vector<std::vector<double>> edges;
        for (std::size_t i = 0; i < tree.size(); ++i)
            for (std::size_t k = coordinates; k < tree[i].size(); ++k)
            {
                const auto end = static_cast<std::size_t>(tree[i][k]);
                edges.emplace_back(begin(i), begin(i) + static_cast<std::ptrdiff_t>(coordinates));
                edges.back().insert(edges.back().end(), begin(end),
                                    begin(end) + static_cast<std::ptrdiff_t>(coordinates));
            }
        std::sort(edges.begin(), edges.end());
        return edges;
    }
}

TEST(ControlTreesTest, AreThoseOfGnat)
{
    constexpr std::size_t coordinates = 13;
    for (const char *planner : {"RRT", "SST"})
        for (unsigned int seed = 1; seed <= scaled(3); ++seed)
        {
            const auto byGnat = makeSetup(Method::STANDARD), byDefault = makeSetup(Method::STANDARD);
            byGnat->setNearestStructure(NearestStructure::GNAT);
            const auto expected = edgesOf(treeOf(*byGnat, planner, seed, 1500), coordinates);
            EXPECT_GT(expected.size(), 50U) << planner;
            EXPECT_TRUE(edgesOf(treeOf(*byDefault, planner, seed, 1500), coordinates) == expected)
                << planner << ", seed " << seed;
            EXPECT_TRUE(useKdTree(*byGnat->getPlanner())) << planner << " had no GNAT to replace";
            EXPECT_FALSE(useKdTree(*byDefault->getPlanner())) << planner << " had a GNAT";
            EXPECT_THROW(byDefault->setNearestStructure(NearestStructure::GNAT), ompl::Exception);
        }
}

TEST(ControlTreesTest, EqualUnderAllMethods)
{
    for (const char *planner : {"RRT", "SST", "KPIECE1", "EST", "PDST"})
        for (unsigned int seed = 1; seed <= scaled(2); ++seed)
        {
            const auto expected = treeOf(*makeSetup(Method::FCL), planner, seed, 1500);
            EXPECT_GT(expected.size(), 50u) << planner;
            for (const Method method : allMethods())
            {
                const auto setup = makeSetup(method);
                setup->getTeamChecker()->setAdaptive(seed % 2 == 0);
                EXPECT_EQ(treeOf(*setup, planner, seed, 1500), expected)
                    << planner << ", " << nameOf(method) << ", seed " << seed;
            }
        }
}

TEST(ControlTreesTest, AreThoseOfASetupThatSharesItsChecker)
{
    for (const Mode mode : {CertificateMotionValidator::DISCRETE, CertificateMotionValidator::CONTINUOUS})
    {
        const auto first = makeSetup(Method::SHARED_PROJECTION, mode);
        first->getTeamChecker()->setAdaptive(false);
        const auto expected = treeOf(*first, "RRT", 1, 500);
        const std::uint64_t asked = first->getStatistics().getCounts().asked;
        EXPECT_GT(expected.size(), 50U);

        TeamControlSetup second(first->getTeamChecker(), mode);
        ob::ScopedState<> start(second.getStateSpace());
        start = first->getProblemDefinition()->getStartState(0);
        second.setStartState(start);
        second.setGoal(first->getGoal());
        second.getStatistics().reset();
        EXPECT_EQ(treeOf(second, "RRT", 1, 500), expected);
        EXPECT_LT(second.getStatistics().getCounts().asked, asked);
    }
}

TEST(ControlTreesTest, AreRefusedWithoutACheckerOfATeam)
{
    EXPECT_THROW(TeamControlSetup(std::shared_ptr<TeamValidityChecker>()), ompl::Exception);
    const auto disc = RigidRobot::disc("disc", 0.1, within({1.0, 1.0}));
    const ObstaclesPtr obstacles = boxes({{{0.0, 0.0, 0.1, 0.1}}});
    const auto plain = std::make_shared<TeamValidityChecker>(
        std::make_shared<ob::SpaceInformation>(disc->getStateSpace()), obstacles, std::vector<RobotPtr>{disc});
    EXPECT_NE(messageOf([&] { TeamControlSetup setup(plain); }).find("TeamStateSpace"), std::string::npos);
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(disc);
    const auto undriven =
        std::make_shared<TeamValidityChecker>(std::make_shared<ob::SpaceInformation>(team), obstacles);
    EXPECT_NE(messageOf([&] { TeamControlSetup setup(undriven); }).find("is no DynamicRobot"), std::string::npos);
}

TEST(ControlTreesTest, StayWithinLimits)
{
    const auto setup = makeSetup(Method::SHARED_PROJECTION);
    treeOf(*setup, "RRT", 1, 1500);
    ob::PlannerData data(setup->getSpaceInformation());
    setup->getPlanner()->getPlannerData(data);
    EXPECT_GT(data.numVertices(), 100U);
    for (unsigned int i = 0; i < data.numVertices(); ++i)
        EXPECT_TRUE(setup->getStateSpace()->satisfiesBounds(data.getVertex(i).getState()));
}

TEST(ControlTreesTest, RevalidationPropagatesEdgesAgain)
{
    ObstacleSet set(2);
    for (int i = 0; i < 60; ++i)
        set.add({Body::box(0.05, 0.05), planarPose(-2.9 + 0.1 * i, 2.8)});
    const auto robots = allKinds();
    TeamControlSetup setup(teamOf({robots[1], robots[3], robots[5]}), set.takeChange().after);
    ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
    start = std::vector<double>{-1.5, 0.0, 0.0, 0.0, -1.0, -2.0, 0.0, 0.0, 0.0, 1.5, 0.0, 3.0, 3.0};
    goal = std::vector<double>{1.5, 1.0, 0.0, 0.0, -1.0, 0.7, 0.0, 0.0, 0.0, 1.5, -1.5, 3.0, 3.0};
    setup.setStartAndGoalStates(start, goal, 0.5);
    treeOf(setup, "RRT", 2, 2000);
    oc::PlannerData controls(setup.getSpaceInformation());
    setup.getPlanner()->getPlannerData(controls);
    ASSERT_GT(controls.numVertices(), 100U);

    for (const double y : {-1.5, 0.3, 1.0})
        set.add({Body::box(0.15, 0.3), planarPose(0.0, y)});
    const ObstacleChange change = set.takeChange();
    setup.getTeamChecker()->changeObstacles(change);
    const Revalidation revalidation(*setup.getTeamChecker(), change);
    const auto found = revalidation.findInvalid(controls);

    const auto &si = setup.getSpaceInformation();
    std::vector<unsigned int> vertices, ends;
    std::vector<std::pair<unsigned int, unsigned int>> edges;
    unsigned int between = 0;
    ob::ScopedState<> state(si->getStateSpace());
    for (unsigned int i = 0; i < controls.numVertices(); ++i)
    {
        const ob::State *from = controls.getVertex(i).getState();
        const bool isValid = setup.getTeamChecker()->isValid(from);
        if (!isValid)
            vertices.push_back(i);
        controls.getEdges(i, ends);
        std::sort(ends.begin(), ends.end());
        for (const unsigned int end : ends)
        {
            const auto &edge = static_cast<const oc::PlannerDataEdgeControl &>(controls.getEdge(i, end));
            const auto steps =
                static_cast<unsigned int>(std::lround(edge.getDuration() / si->getPropagationStepSize()));
            const bool isWayFree =
                si->propagateWhileValid(from, edge.getControl(), static_cast<int>(steps), state.get()) == steps;
            between += isValid && !isWayFree && setup.getTeamChecker()->isValid(controls.getVertex(end).getState());
            if (!isValid || !isWayFree)
                edges.emplace_back(i, end);
        }
    }
    EXPECT_EQ(found.vertices, vertices);
    EXPECT_EQ(found.edges, edges);
    EXPECT_FALSE(vertices.empty());
    EXPECT_GT(between, 0U) << "no edge is invalid between valid ends";

    for (const auto &[from, to] : edges)
    {
        const auto &edge = static_cast<const oc::PlannerDataEdgeControl &>(controls.getEdge(from, to));
        oc::PathControl one(si);
        one.append(controls.getVertex(from).getState());
        one.append(controls.getVertex(to).getState(), edge.getControl(), edge.getDuration());
        EXPECT_EQ(revalidation.findInvalidEdges(one), std::vector<std::size_t>{0});
    }
    {
        // Who makes a validator is told that planners by controls ask none; who asks what has changed is not.
        const Warnings warnings("ask no motion validator");
        const Revalidation proved(*setup.getTeamChecker(), change, Mode::CONTINUOUS,
                                  [](const auto &.../*step*/) { return true; });
        EXPECT_EQ(warnings.count, 0U);
        const CertificateMotionValidator own(setup.getTeamChecker(), Mode::CONTINUOUS);
        EXPECT_EQ(warnings.count, 1U);
    }
    const auto withoutControls = std::make_shared<ob::SpaceInformation>(setup.getStateSpace());
    const TeamValidityChecker geometric(withoutControls, change.after, Method::SHARED_PROJECTION);
    EXPECT_NE(messageOf([&] { Revalidation(geometric, change).findInvalid(controls); }).find("controls need a checker"),
              std::string::npos);
}

TEST(ControlTreesTest, ProvenTreesAreEqualUnderAllMethodsWithCertificates)
{
    const auto mode = CertificateMotionValidator::CONTINUOUS;
    for (const char *planner : {"RRT", "SST"})
    {
        const auto expected = treeOf(*makeSetup(Method::SHARED_PROJECTION, mode), planner, 1, 500);
        EXPECT_GT(expected.size(), 50u);
        for (const Method method : {Method::BASIC, Method::PARTIAL})
            EXPECT_EQ(treeOf(*makeSetup(method, mode), planner, 1, 500), expected) << planner << nameOf(method);
    }
}
