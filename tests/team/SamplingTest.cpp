#include "support/RandomTrees.h"
#include "support/Teams.h"

#include <gtest/gtest.h>
#include <ompl/base/ProjectionEvaluator.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

class TeamSampling : public testing::TestWithParam<unsigned int>
{
};

TEST_P(TeamSampling, MovesEveryRobot)
{
    const auto team = anyTeam(GetParam());
    team->setup();
    const auto sampler = team->allocStateSampler();
    ob::ScopedState<> a(team), b(team);
    sampler->sampleUniform(a.get());
    sampler->sampleUniform(b.get());
    for (unsigned int i = 0; i < 3; ++i)
        EXPECT_GT(team->getSubspace(i)->distance(a->as<ob::CompoundState>()->components[i],
                                                 b->as<ob::CompoundState>()->components[i]),
                  0.0);
}

TEST_P(TeamSampling, NearAStateStaysNearIt)
{
    const auto team = anyTeam(GetParam());
    team->setup();
    const auto sampler = team->allocStateSampler();
    ob::ScopedState<> a(team), b(team);
    double farthest = 0.0;
    for (int i = 0; i < 200; ++i)
    {
        sampler->sampleUniform(a.get());
        sampler->sampleUniformNear(b.get(), a.get(), 0.5);
        farthest = std::max(farthest, team->distance(a.get(), b.get()));
    }
    // OMPL's samplers keep the distance in each coordinate.
    EXPECT_LE(farthest, 0.5 * 2.0 * std::sqrt(3.0 * 3.0 * 2.0));
    EXPECT_GT(farthest, 0.0);
}

TEST_P(TeamSampling, NearAStateOutsideTheBoundsEndsWithinThem)
{
    // Cars' curves may leave the bounds. OMPL's own samplers end the program there.
    const auto team = anyTeam(GetParam());
    team->setup();
    const auto sampler = team->allocStateSampler();
    ob::ScopedState<> outside(team), state(team);
    std::vector<double> reals;
    sampler->sampleUniform(outside.get());
    reals = outside.reals();
    reals[0] = 1000.0;
    outside = reals;
    ASSERT_FALSE(team->satisfiesBounds(outside.get()));
    for (int i = 0; i < 100; ++i)
    {
        sampler->sampleUniformNear(state.get(), outside.get(), 0.1);
        EXPECT_TRUE(team->satisfiesBounds(state.get()));
    }
    EXPECT_EQ(outside.reals(), reals);
}

TEST_P(TeamSampling, ProjectsSoThatEveryRobotCounts)
{
    const auto team = anyTeam(GetParam());
    team->setup();
    ASSERT_TRUE(team->hasDefaultProjection());
    const auto projection = team->getDefaultProjection();
    EXPECT_EQ(projection->getDimension(), team->getWorkspaceDimension());
    Random random(1);
    auto state = randomState(random, team);
    Eigen::VectorXd before(projection->getDimension()), after(projection->getDimension());
    projection->project(state.get(), before);
    for (unsigned int i = 0; i < 3; ++i)
    {
        auto moved = state;
        randomize(random, team->getSubspace(i), moved->as<ob::CompoundState>()->components[i]);
        projection->project(moved.get(), after);
        EXPECT_GT((after - before).norm(), 1e-6) << "robot " << i;
    }
}

/** No joint moves the origin of a head that turns about it, with a box about its middle. */
TEST(TeamProjection, SeesEachJointOfAnArm)
{
    KinematicTree head("base");
    head.addLink("base", joint("pan", KinematicTree::JointType::REVOLUTE, {0.0, 0.0, 0.5}), "neck");
    head.addLink("neck", joint("tilt", KinematicTree::JointType::REVOLUTE, {0.0, 0.0, 0.0}, Eigen::Vector3d::UnitY()),
                 "head", Body::box(1.0, 0.1, 0.1));
    const std::vector<std::string> joints{"pan", "tilt"};
    const auto arm = std::make_shared<Arm>("head", head, joints);
    const auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(arm);
    team->setup();
    const auto projection = team->getDefaultProjection();
    Eigen::VectorXd before(3), after(3);
    ob::ScopedState<> state(team);
    for (std::size_t i = 0; i < joints.size(); ++i)
    {
        std::vector<double> values{0.3, 0.4};
        state = values;
        projection->project(state.get(), before);
        values[i] += 0.5;
        state = values;
        projection->project(state.get(), after);
        EXPECT_GT((after - before).norm(), 0.05) << joints[i];
    }
}

INSTANTIATE_TEST_SUITE_P(Kind, TeamSampling, testing::Values(0U, 1U, 2U));
