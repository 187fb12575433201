#include "support/IterationLimit.h"
#include "support/Quiet.h"
#include "support/Teams.h"

#include "ompl_certificates/planning/TeamSetup.h"

#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/PlannerData.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    constexpr unsigned int METRICS = 4;

    TeamStateSpacePtr teamOf(unsigned int kind)
    {
        auto team = std::make_shared<TeamStateSpace>(TeamStateSpace::SUM);
        const unsigned int dimension = kind == 2 ? 3 : 2;
        const auto bounds = cubeBounds(dimension, HALF);
        for (unsigned int i = 0; i < 3; ++i)
        {
            const std::string name = std::to_string(i);
            const double weight = 1.0 + 0.37 * i;
            if (kind == 0)
                team->addRobot(RigidRobot::disc(name, 0.3, bounds), weight);
            else if (kind == 1)
                team->addRobot(RigidRobot::inSE2(name, Body::box(0.7, 0.3), bounds), weight);
            else if (kind == 2)
                team->addRobot(RigidRobot::inSE3(name, Body::box(0.7, 0.3, 0.4), bounds), weight);
            else if (i == 1)
                team->addRobot(
                    std::make_shared<CarWithTrailer>(name, Body::box(0.5, 0.3), Body::box(0.3, 0.3), 0.6, bounds),
                    weight);
            else
                team->addRobot(RigidRobot::inR2(name, Body::box(0.7, 0.3), bounds), weight);
        }
        return team;
    }

    /** OMPL's own space of the same components and weights */
    std::shared_ptr<ob::CompoundStateSpace> plainSpaceOf(unsigned int kind)
    {
        const auto team = teamOf(kind);
        auto plain = std::make_shared<ob::CompoundStateSpace>();
        for (unsigned int i = 0; i < team->getSubspaceCount(); ++i)
            plain->addSubspace(team->getSubspace(i), team->getSubspaceWeight(i));
        return plain;
    }

    /** The states of a planner's tree with their parents', sorted: each structure lists states in its own order. */
    std::vector<std::vector<double>> treeOf(const og::SimpleSetup &setup)
    {
        ob::PlannerData data(setup.getSpaceInformation());
        setup.getPlanner()->getPlannerData(data);
        std::vector<std::vector<double>> tree;
        for (unsigned int i = 0; i < data.numVertices(); ++i)
        {
            tree.push_back(realsOf(*setup.getStateSpace(), data.getVertex(i).getState()));
            std::vector<unsigned int> parents;
            data.getIncomingEdges(i, parents);
            for (const unsigned int parent : parents)
                for (const double value : realsOf(*setup.getStateSpace(), data.getVertex(parent).getState()))
                    tree.back().push_back(value);
        }
        std::sort(tree.begin(), tree.end());
        return tree;
    }

    template <typename Planner>
    std::vector<std::vector<double>> grow(og::SimpleSetup &setup, const std::vector<double> &from,
                                          const std::vector<double> &to, const std::shared_ptr<Planner> &planner)
    {
        ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
        start = from;
        goal = to;
        setup.setStartAndGoalStates(start, goal, 1e-9);
        setup.setPlanner(planner);
        setup.setup();
        ob::IterationTerminationCondition condition(600);
        setup.solve(condition);
        return treeOf(setup);
    }

    class SumMetric : public testing::TestWithParam<unsigned int>
    {
        const Quiet quiet_;

    protected:
        template <typename Planner>
        void expectEqualTrees();

        /** Returns the size of the tree */
        template <typename Planner>
        std::size_t compareTrees(unsigned int seed);
    };

    template <typename Planner>
    void SumMetric::expectEqualTrees()
    {
        std::size_t states = 0;
        for (unsigned int seed = 0; seed < scaled(8); ++seed)
        {
            SCOPED_TRACE("seed " + std::to_string(seed));
            states += compareTrees<Planner>(seed);
        }
        EXPECT_GT(states, scaled(30));
    }

    template <typename Planner>
    std::size_t SumMetric::compareTrees(unsigned int seed)
    {
        Random random(seed);
        const auto obstacles = scatteredObstacles(random, GetParam() == 2 ? 3 : 2, 25);
        const auto judge = teamOf(GetParam());
        TeamSetup standard(judge, obstacles, Method::STANDARD);
        std::vector<std::vector<double>> ends;
        while (ends.size() < 2)
            if (const auto state = randomState(random, judge); standard.getTeamChecker()->isValid(state.get()))
                ends.push_back(state.reals());

        // The user's original program
        ompl::RNG::setSeed(11);
        og::SimpleSetup plain(plainSpaceOf(GetParam()));
        plain.setStateValidityChecker(
            [&](const ob::State *state)
            {
                ob::ScopedState<> copy(judge);
                copy = realsOf(*plain.getStateSpace(), state);
                return standard.getTeamChecker()->isValid(copy.get());
            });
        plain.getSpaceInformation()->setMotionValidator(
            std::make_shared<ob::DiscreteMotionValidator>(plain.getSpaceInformation()));
        auto stock = std::make_shared<Planner>(plain.getSpaceInformation());
        const auto expected = grow(plain, ends[0], ends[1], stock);
        for (const Method method : allMethods())
        {
            ompl::RNG::setSeed(11);
            TeamSetup setup(teamOf(GetParam()), obstacles, method);
            setup.getTeamChecker()->setCertificatesAfter(0);
            const auto tree = grow(setup, ends[0], ends[1], std::make_shared<Planner>(setup.getSpaceInformation()));
            EXPECT_TRUE(tree == expected)
                << nameOf(method) << ": " << tree.size() << " states, not " << expected.size();
        }
        return expected.size();
    }
}

TEST_P(SumMetric, IsThatOfACompoundStateSpaceToTheLastBit)
{
    const auto team = teamOf(GetParam());
    const auto plain = plainSpaceOf(GetParam());
    EXPECT_EQ(team->getMetric(), TeamStateSpace::SUM);
    team->setup();
    plain->setup();
    EXPECT_NO_THROW(team->sanityChecks());
    EXPECT_EQ(team->getMaximumExtent(), plain->getMaximumExtent());
    EXPECT_EQ(team->getLongestValidSegmentLength(), plain->getLongestValidSegmentLength());
    Random random(GetParam());
    for (unsigned int i = 0; i < scaled(1000); ++i)
    {
        const auto a = randomState(random, team), b = randomState(random, team);
        ob::ScopedState<> x(plain), y(plain);
        x = a.reals();
        y = b.reals();
        EXPECT_EQ(team->distance(a.get(), b.get()), plain->distance(x.get(), y.get()));
        EXPECT_EQ(team->validSegmentCount(a.get(), b.get()), plain->validSegmentCount(x.get(), y.get()));
    }
}

TEST_P(SumMetric, GrowsTheTreesOfRrtInACompoundStateSpace)
{
    expectEqualTrees<og::RRT>();
}

TEST_P(SumMetric, GrowsTheTreesOfRrtConnectInACompoundStateSpace)
{
    expectEqualTrees<og::RRTConnect>();
}

INSTANTIATE_TEST_SUITE_P(Kind, SumMetric, testing::Range(0U, METRICS));

TEST(SumMetric, IsNotTheDefault)
{
    EXPECT_EQ(TeamStateSpace().getMetric(), TeamStateSpace::EUCLIDEAN);
}
