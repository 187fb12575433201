#include "ompl_certificates/planning/ProvePath.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "support/Quiet.h"
#include "support/Random.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Exception.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    /** A disc of radius 0.2 on a floor with an obstacle at its middle, a pillar of radius 0.1, looked at every 0.6 */
    class ProvePathTest : public testing::Test
    {
    protected:
        static TeamSetupPtr floor(Method method = Method::SHARED_PROJECTION, const Body &obstacle = Body::disc(0.1))
        {
            ob::RealVectorBounds bounds(2);
            bounds.setLow(-3.0);
            bounds.setHigh(3.0);
            auto team = std::make_shared<TeamStateSpace>();
            team->addRobot(RigidRobot::disc("disc", 0.2, bounds));
            team->setLongestValidSegmentFraction(0.6 / team->getMaximumExtent());
            const std::vector<PlacedBody> placed{{obstacle, Pose::Identity()}};
            auto setup = std::make_shared<TeamSetup>(team, std::make_shared<FclObstacles>(placed, 2), method);
            setup->getSpaceInformation()->setup();
            return setup;
        }

        static og::PathGeometric through(const TeamSetup &setup, const std::vector<std::vector<double>> &points)
        {
            og::PathGeometric path(setup.getSpaceInformation());
            ob::ScopedState<> state(setup.getStateSpace());
            for (const auto &point : points)
            {
                state = point;
                path.append(state.get());
            }
            return path;
        }

    private:
        const Quiet quiet_;
    };
}

TEST_F(ProvePathTest, ProvesWhatIsFarFromEverything)
{
    const auto setup = floor();
    const PathProof proof =
        provePath(through(*setup, {{-2.0, -1.0}, {2.0, -1.0}, {2.0, 2.0}}), setup->getTeamChecker());
    EXPECT_TRUE(proof.isProved());
    EXPECT_EQ(proof.collision, nullptr);
    EXPECT_TRUE(provePath(through(*setup, {{1.0, 1.0}}), setup->getTeamChecker()).isProved());
    EXPECT_THROW(provePath(through(*setup, {}), setup->getTeamChecker()), ompl::Exception);
}

TEST_F(ProvePathTest, FindsWhatHappensBetweenTheSamples)
{
    const auto setup = floor();
    // A third of a segment before and behind the pillar's middle
    og::PathGeometric path = through(*setup, {{-2.0, 2.0}, {-0.25, 0.21}, {0.25, 0.21}, {2.0, 2.0}});
    ASSERT_TRUE(path.check());
    const PathProof proof = provePath(path, setup->getTeamChecker());
    EXPECT_EQ(proof.unproved, std::vector<std::size_t>{1});
    ASSERT_NE(proof.collision, nullptr);
    EXPECT_FALSE(setup->getTeamChecker()->isValid(proof.collision->get()));
    EXPECT_NEAR((*proof.collision)[1], 0.21, 1e-9);
    // Where it begins: the centers are 0.3 apart.
    EXPECT_NEAR((*proof.collision)[0], -std::sqrt(0.09 - 0.21 * 0.21), 0.6 / 100);
}

TEST_F(ProvePathTest, NeedsAPathOfTheTeam)
{
    const auto setup = floor();
    const auto space = std::make_shared<ob::RealVectorStateSpace>(3);
    const og::PathGeometric path(std::make_shared<ob::SpaceInformation>(space));
    EXPECT_THROW(provePath(path, setup->getTeamChecker()), ompl::Exception);
    // Of as many dimensions, and another team
    EXPECT_THROW(provePath(through(*floor(), {{2.0, 0.0}, {2.0, 1.0}}), setup->getTeamChecker()), ompl::Exception);
}

TEST_F(ProvePathTest, IsOfASingleStateWhetherThatIsValid)
{
    const auto setup = floor();
    EXPECT_TRUE(provePath(through(*setup, {{2.0, 0.0}}), setup->getTeamChecker()).isProved());
    const PathProof proof = provePath(through(*setup, {{0.1, 0.0}}), setup->getTeamChecker());
    EXPECT_EQ(proof.unproved, std::vector<std::size_t>{0});
    ASSERT_TRUE(proof.collision);
    EXPECT_EQ((*proof.collision)[0], 0.1);
}

TEST_F(ProvePathTest, FindsNothingWhereThereIsHardlyRoom)
{
    const auto setup = floor();
    const PathProof proof = provePath(through(*setup, {{-0.25, 0.301}, {0.25, 0.301}}), setup->getTeamChecker());
    EXPECT_EQ(proof.unproved, std::vector<std::size_t>{0});
    EXPECT_EQ(proof.collision, nullptr);
}

TEST_F(ProvePathTest, ProvesNoPathThatStartsOrEndsInAnObstacle)
{
    const auto setup = floor();
    for (const auto &points : {std::vector<std::vector<double>>{{0.0, 0.0}, {0.0, 2.0}}, {{0.0, 2.0}, {0.0, 0.0}}})
    {
        const PathProof proof = provePath(through(*setup, points), setup->getTeamChecker());
        EXPECT_EQ(proof.unproved.size(), 1U);
        EXPECT_NE(proof.collision, nullptr);
    }
}

TEST_F(ProvePathTest, EndsWhereItIsToldTo)
{
    const auto setup = floor();
    const og::PathGeometric path = through(*setup, {{-2.0, -1.0}, {2.0, -1.0}, {2.0, 0.0}, {-2.0, 0.0}});
    const PathProof whole = provePath(path, setup->getTeamChecker());
    EXPECT_EQ(whole.unproved, std::vector<std::size_t>{2});
    EXPECT_NE(whole.collision, nullptr);
    unsigned int motions = 0;
    const PathProof first =
        provePath(path, setup->getTeamChecker(), ob::PlannerTerminationCondition([&motions] { return ++motions > 1; }));
    EXPECT_EQ(first.unproved, (std::vector<std::size_t>{1, 2}));
    EXPECT_EQ(first.collision, nullptr);
    EXPECT_EQ(first.unseen, 2U);
    EXPECT_EQ(whole.unseen, 0U);
}

TEST_F(ProvePathTest, NeedsNoCheckerThatMakesCertificates)
{
    for (const Method method : {Method::FCL, Method::STANDARD})
    {
        SCOPED_TRACE(nameOf(method));
        const auto setup = floor(method);
        const og::PathGeometric path = through(*setup, {{-2.0, -1.0}, {2.0, -1.0}, {2.0, 0.0}, {-2.0, 0.0}});
        const PathProof proof = provePath(path, setup->getTeamChecker());
        EXPECT_EQ(proof.unproved, std::vector<std::size_t>{2});
        EXPECT_NE(proof.collision, nullptr);
        EXPECT_EQ(setup->getTeamChecker()->getCertificateCount(), 0U);
        // Among the obstacles as they are now
        const auto empty = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2);
        setup->getTeamChecker()->changeObstacles(ObstacleChange{empty, nullptr, nullptr});
        EXPECT_TRUE(provePath(path, setup->getTeamChecker()).isProved());
    }
}

TEST_F(ProvePathTest, AsksTheCheckerItselfOfWhereMotionsStart)
{
    struct RefusesTheStart : TeamValidityChecker
    {
        using TeamValidityChecker::TeamValidityChecker;

        bool isValid(const ob::State *state) const override
        {
            return *getSpaceInformation()->getStateSpace()->getValueAddressAtIndex(state, 0) != -2.0 &&
                   TeamValidityChecker::isValid(state);
        }
    };
    const auto setup = floor();
    const auto checker = std::make_shared<RefusesTheStart>(setup->getSpaceInformation(),
                                                           std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2),
                                                           Method::SHARED_PROJECTION);
    const PathProof proof = provePath(through(*setup, {{-2.0, -1.0}, {0.0, -1.0}, {2.0, -1.0}}), checker);
    EXPECT_EQ(proof.unproved, std::vector<std::size_t>{0});
    ASSERT_NE(proof.collision, nullptr);
    EXPECT_EQ((*proof.collision)[0], -2.0);
}

/** Plans past a thin wall, which look where the disc is each 0.6: some go through the wall, and those are not proved.
    */
TEST_F(ProvePathTest, NeverProvesAPlanThatCollides)
{
    unsigned int proved = 0, colliding = 0;
    for (std::uint64_t seed = 1; seed <= std::max(20U, scaled(200)); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed));
        Random random(seed);
        const auto setup = floor(Method::SHARED_PROJECTION, Body::box(0.02, 3.0));
        ob::ScopedState<> start(setup->getStateSpace()), goal(setup->getStateSpace());
        start = std::vector<double>{-2.0, random.uniform(-2.5, 2.5)};
        goal = std::vector<double>{2.0, random.uniform(-2.5, 2.5)};
        setup->setStartAndGoalStates(start, goal);
        setup->setPlanner(std::make_shared<og::RRTConnect>(setup->getSpaceInformation()));
        ASSERT_EQ(setup->solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
        const og::PathGeometric &path = setup->getSolutionPath();
        const PathProof proof = provePath(path, setup->getTeamChecker());
        og::PathGeometric dense = path;
        dense.interpolate(3000);
        bool collides = false;
        for (const ob::State *state : dense.getStates())
            collides = collides || !setup->getTeamChecker()->isValid(state);
        EXPECT_FALSE(proof.isProved() && collides);
        EXPECT_FALSE(proof.isProved() && proof.collision);
        proved += proof.isProved() ? 1 : 0;
        colliding += proof.collision ? 1 : 0;
    }
    EXPECT_GT(proved, 0U);
    EXPECT_GT(colliding, 0U);
    std::cout << proved << " plans proved, " << colliding << " that collide\n";
}
