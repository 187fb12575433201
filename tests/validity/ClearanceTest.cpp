#include "support/Checkers.h"
#include "support/ErrorsOnly.h"
#include "support/MeshObstacles.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** An upper bound of the team's distance to a contact: the smallest over points of the robots' bodies */
    double sampledDistance(Random &random, const TeamStateSpace &team, const Obstacles &obstacles,
                           const ob::State *state)
    {
        struct Placed
        {
            unsigned int robot;
            Body body;
            Pose pose;
        };
        std::vector<Placed> bodies;
        for (unsigned int i = 0; i < team.getRobotCount(); ++i)
        {
            const Robot &robot = team.getRobot(i);
            std::vector<Pose> poses(robot.getBodies().size());
            robot.computePoses(state->as<ob::CompoundState>()->components[i], poses.data());
            for (std::size_t k = 0; k < poses.size(); ++k)
                bodies.push_back({i, robot.getBodies()[k], poses[k]});
        }
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto &placed : bodies)
            for (int i = 0; i < 100; ++i)
            {
                const Eigen::Vector3d point = placed.pose * surfacePointOf(random, placed.body);
                nearest = std::min(nearest, obstacles.clearance(point));
                for (const auto &other : bodies)
                    if (other.robot != placed.robot)
                        nearest = std::min(nearest, other.body.signedDistance(other.pose.inverse() * point));
            }
        return nearest;
    }
}

class Clearance : public ErrorsOnly<unsigned int>
{
};

TEST_P(Clearance, IsALowerBoundAndPositiveOnlyIfTheStateIsValid)
{
    unsigned int positive = 0, valid = 0;
    for (unsigned int seed = 0; seed < scaled(30); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto team = anyTeam(GetParam());
        const auto obstacles = anyObstacles(random, GetParam(), 8);
        const Checkers checkers(team, obstacles);
        for (int i = 0; i < 40; ++i)
        {
            const auto state = randomState(random, team);
            const double clearance = checkers.reference().getTeamChecker()->clearance(state.get());
            const bool isValid = checkers.isValid(state.get());
            // For an invalid state only the sign is promised.
            const double nearest = sampledDistance(random, *team, *obstacles, state.get());
            ASSERT_LE(clearance, isValid ? nearest + 1e-9 : 0.0);
            ASSERT_EQ(clearance > 0.0, isValid);
            positive += clearance > 0.0 ? 1 : 0;
            valid += isValid ? 1 : 0;
            for (const auto &setup : checkers.compared())
                ASSERT_EQ(setup->getTeamChecker()->clearance(state.get()), clearance);
        }
    }
    EXPECT_GT(positive, valid * 8 / 10) << "too loose to be of use";
}

TEST_P(Clearance, IsDeclaredABoundedApproximation)
{
    const auto team = anyTeam(GetParam());
    const Checkers checkers(team,
                            std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, team->getWorkspaceDimension()));
    for (const auto &setup : checkers.setups)
        EXPECT_EQ(setup->getTeamChecker()->getSpecs().clearanceComputationType,
                  ob::StateValidityCheckerSpecs::BOUNDED_APPROXIMATE);
}

INSTANTIATE_TEST_SUITE_P(Kind, Clearance, testing::Values(0U, 1U, 2U, 4U));

/** What is left between a car and a wall may be less than what the car's sphere tree sticks out. */
TEST(Clearances, ArePositiveWhereSphereTreesTouch)
{
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::inSE2("car", Body::box(0.9, 0.4), cubeBounds(2, 5.0)));
    team->addRobot(RigidRobot::inSE2("other", Body::box(0.9, 0.4), cubeBounds(2, 5.0)));
    const auto wall =
        std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(1.0, 10.0), planarPose(2.5, 0.0)}}, 2);
    const TeamSetup setup(team, wall);
    ob::ScopedState<> state(team);
    const double tolerance = 2.0 * (wall->getTolerance() + exactCheckTolerance(1.0));
    EXPECT_LT(tolerance, 1e-4);
    for (const double gap : {0.1, 0.01, 0.001, 1e-5, 1e-7})
    {
        SCOPED_TRACE(gap);
        state = std::vector<double>{1.55 - gap, 0.0, 0.0, -3.0, 0.0, 0.0};
        const double toWall = setup.getTeamChecker()->clearance(state.get());
        EXPECT_LE(toWall, gap + 1e-12);
        EXPECT_GE(toWall, (gap > 0.05 ? 0.5 : 0.9) * gap - tolerance);
        EXPECT_GT(toWall, 0.0);
        state = std::vector<double>{-2.0, 1.0, 0.0, -2.0, 1.4 + gap, 0.0};
        const double toOther = setup.getTeamChecker()->clearance(state.get());
        EXPECT_LE(toOther, gap + 1e-12);
        EXPECT_GE(toOther, (gap > 0.05 ? 0.5 : 0.9) * gap - tolerance);
        EXPECT_GT(toOther, 0.0);
    }
    state = std::vector<double>{1.6, 0.0, 0.0, -3.0, 0.0, 0.0};
    EXPECT_LT(setup.getTeamChecker()->clearance(state.get()), 0.0);
}

TEST(Clearances, OfDiscsAreExact)
{
    const auto team = teamOfDiscs();  // 0.1, 0.2 and 0.3
    const auto wall =
        std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(1.0, 10.0), planarPose(4.5, 0.0)}}, 2);
    const TeamSetup setup(team, wall);
    ob::ScopedState<> state(team);
    state = std::vector<double>{3.0, 0.0, 0.0, 0.0, -2.0, 0.0};
    EXPECT_NEAR(setup.getTeamChecker()->clearance(state.get()), 0.9, 1e-9);
    state = std::vector<double>{-4.0, 4.0, 0.0, 0.0, -2.0, 0.0};
    EXPECT_NEAR(setup.getTeamChecker()->clearance(state.get()), 1.5, 1e-9);
}
