#include "support/Teams.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    const TeamStateSpace::StateType &typed(const ob::State *state)
    {
        return *state->as<TeamStateSpace::StateType>();
    }

    void refer(const ob::State *state, TeamStateSpace::Reference first)
    {
        for (unsigned int i = 0; i < 3; ++i)
            typed(state).setReference(i, first + i);
    }

    void expectReferences(const ob::State *state, TeamStateSpace::Reference first)
    {
        for (unsigned int i = 0; i < 3; ++i)
            EXPECT_EQ(typed(state).getReference(i),
                      first == TeamStateSpace::NO_REFERENCE ? TeamStateSpace::NO_REFERENCE : first + i)
                << i;
    }

    class References : public testing::TestWithParam<unsigned int>
    {
    protected:
        void SetUp() override
        {
            team_ = anyTeam(GetParam());
            team_->setup();
            a_ = team_->allocState();
            b_ = team_->allocState();
            Random random(1);
            randomize(random, team_, a_);
            randomize(random, team_, b_);
        }

        void TearDown() override
        {
            team_->freeState(a_);
            team_->freeState(b_);
        }

        TeamStateSpacePtr team_;
        ob::State *a_, *b_;
    };
}

TEST_P(References, AreNoneInANewState)
{
    expectReferences(a_, TeamStateSpace::NO_REFERENCE);
}

TEST_P(References, ArePassedOnByCopies)
{
    refer(a_, 10);
    team_->copyState(b_, a_);
    expectReferences(b_, 10);
    EXPECT_TRUE(team_->equalStates(a_, b_));
    ob::State *clone = team_->cloneState(a_);
    expectReferences(clone, 10);
    EXPECT_TRUE(team_->equalStates(a_, clone));
    team_->freeState(clone);
    const ob::ScopedState<> scoped(team_, a_);
    expectReferences(scoped.get(), 10);
    team_->copyState(a_, a_);
    expectReferences(a_, 10);
}

TEST_P(References, ArePassedOnByInterpolationFromTheNearState)
{
    refer(a_, 10);
    refer(b_, 20);
    ob::State *middle = team_->allocState();
    for (const double t : {0.0, 0.4, 1.0})
    {
        team_->clearReferences(middle);
        team_->interpolate(a_, b_, t, middle);
        expectReferences(middle, 10);
    }
    team_->freeState(middle);
    team_->interpolate(a_, b_, 0.5, b_);
    expectReferences(b_, 10);
}

TEST_P(References, AreForgottenBySamplers)
{
    for (const auto &sampler : {team_->allocDefaultStateSampler(), team_->allocStateSampler()})
    {
        refer(a_, 10);
        sampler->sampleUniform(a_);
        expectReferences(a_, TeamStateSpace::NO_REFERENCE);
        refer(a_, 10);
        sampler->sampleUniformNear(a_, b_, 0.1);
        expectReferences(a_, TeamStateSpace::NO_REFERENCE);
        refer(a_, 10);
        sampler->sampleGaussian(a_, b_, 0.1);
        expectReferences(a_, TeamStateSpace::NO_REFERENCE);
        EXPECT_TRUE(team_->satisfiesBounds(a_));
    }
}

TEST_P(References, AreNotPartOfAStatesValue)
{
    team_->copyState(b_, a_);
    refer(a_, 10);
    refer(b_, 20);
    EXPECT_TRUE(team_->equalStates(a_, b_));
    EXPECT_EQ(team_->distance(a_, b_), 0.0);
    std::vector<char> first(team_->getSerializationLength()), second(team_->getSerializationLength());
    team_->serialize(first.data(), a_);
    team_->serialize(second.data(), b_);
    EXPECT_EQ(first, second);
}

TEST_P(References, AreForgottenByDeserializationWhichKeepsTheRest)
{
    std::vector<char> data(team_->getSerializationLength());
    team_->serialize(data.data(), a_);
    refer(b_, 20);
    team_->deserialize(b_, data.data());
    EXPECT_TRUE(team_->equalStates(a_, b_));
    EXPECT_EQ(realsOf(*team_, a_), realsOf(*team_, b_));
    expectReferences(b_, TeamStateSpace::NO_REFERENCE);
}

TEST_P(References, AreClearedTogether)
{
    refer(a_, 10);
    team_->clearReferences(a_);
    expectReferences(a_, TeamStateSpace::NO_REFERENCE);
}

INSTANTIATE_TEST_SUITE_P(Kind, References, testing::Values(0U, 1U, 2U));
