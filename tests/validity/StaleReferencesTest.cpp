#include "support/Checkers.h"

#include <gtest/gtest.h>
#include <ompl/util/Console.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    class StaleReferences : public testing::TestWithParam<unsigned int>
    {
    protected:
        void SetUp() override
        {
            ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
            Random random(GetParam());
            team_ = anyTeam(GetParam());
            here_ = std::make_unique<Checkers>(team_, anyObstacles(random, GetParam(), 10));
            there_ = std::make_unique<Checkers>(team_, anyObstacles(random, GetParam(), 10));
            for (int i = 0; i < 300; ++i)
                states_.push_back(randomState(random, team_));
            for (std::size_t i = 0; i < states_.size(); ++i)
            {
                valid_.push_back(here_->isValid(states_[i].get()));
                free_.push_back(
                    here_->reference().getSpaceInformation()->checkMotion(states_[i].get(), after(i).get()));
            }
        }

        const ob::ScopedState<> &after(std::size_t i) const
        {
            return states_[(i + 1) % states_.size()];
        }

        /** Expects right verdicts among the obstacles here for the states as they are, with their references. */
        void expectRightVerdicts(std::size_t method)
        {
            const auto &setup = here_->setups[method];
            for (std::size_t i = 0; i < states_.size(); ++i)
            {
                const ob::ScopedState<> state = states_[i];  // with references
                ASSERT_EQ(setup->getSpaceInformation()->checkMotion(state.get(), after(i).get()), free_[i]);
                ASSERT_EQ(setup->getTeamChecker()->isValid(state.get()), valid_[i]);
            }
        }

        TeamStateSpacePtr team_;
        std::unique_ptr<Checkers> here_, there_;
        std::vector<ob::ScopedState<>> states_;
        /** Whether each state is valid, and its motion to the next one, as FCL alone says */
        std::vector<bool> valid_, free_;
    };
}

TEST_P(StaleReferences, FromBeforeClearChangeNoVerdict)
{
    for (std::size_t method = 0; method < here_->setups.size(); ++method)
    {
        const auto checker = here_->setups[method]->getTeamChecker();
        if (!makesCertificates(checker->getMethod()))
            continue;
        ASSERT_NO_FATAL_FAILURE(expectRightVerdicts(method));
        for (const auto &state : states_)
            checker->isValid(state.get());
        EXPECT_GT(checker->getCertificateCount(), 0U);
        EXPECT_EQ(checker->getCertificates().size(), checker->getCertificateCount());
        checker->clear();
        EXPECT_EQ(checker->getCertificateCount(), 0U);
        EXPECT_TRUE(checker->getCertificates().empty());
        ASSERT_NO_FATAL_FAILURE(expectRightVerdicts(method));
    }
}

TEST_P(StaleReferences, OfACheckerOfOtherObstaclesChangeNoVerdict)
{
    for (std::size_t method = 1; method < here_->setups.size(); ++method)
        for (std::size_t other = 1; other < there_->setups.size(); ++other)
        {
            for (const auto &state : states_)
                there_->setups[other]->getTeamChecker()->isValid(state.get());
            ASSERT_NO_FATAL_FAILURE(expectRightVerdicts(method));
        }
}

TEST_P(StaleReferences, ToAnythingChangeNoVerdict)
{
    Random random(7);
    for (int round = 0; round < 5; ++round)
        for (std::size_t method = 1; method < here_->setups.size(); ++method)
        {
            for (const auto &state : states_)
                for (unsigned int robot = 0; robot < team_->getRobotCount(); ++robot)
                    state->as<TeamStateSpace::StateType>()->setReference(
                        robot, random.chance(0.5) ? random.below(300) : random.below(std::size_t(1) << 32));
            ASSERT_NO_FATAL_FAILURE(expectRightVerdicts(method));
        }
}

TEST_P(StaleReferences, OfAnotherRobotOrStateChangeNoVerdict)
{
    for (std::size_t method = 1; method < here_->setups.size(); ++method)
    {
        for (const auto &state : states_)
            here_->setups[method]->getTeamChecker()->isValid(state.get());
        for (std::size_t i = 0; i < states_.size(); ++i)
            for (unsigned int robot = 0; robot < 3; ++robot)
                states_[i]->as<TeamStateSpace::StateType>()->setReference(
                    robot, states_[(7 * i + 3) % states_.size()]->as<TeamStateSpace::StateType>()->getReference(
                               (robot + 1) % 3));
        ASSERT_NO_FATAL_FAILURE(expectRightVerdicts(method));
    }
}

INSTANTIATE_TEST_SUITE_P(Kind, StaleReferences, testing::Range(0U, TEAMS));

TEST(References, OfADiscThatWasFoundFreeProveItFreeAgain)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    Random random(2);
    const auto team = teamOfDiscs();
    const auto obstacles = scatteredObstacles(random, 2, 10);
    for (const Method method : {Method::BASIC, Method::PARTIAL, Method::SHARED_PROJECTION})
    {
        const TeamSetup setup(team, obstacles, method);
        setup.getTeamChecker()->setAdaptive(false);
        unsigned int free = 0, asked = 0;
        for (int i = 0; i < 300; ++i)
        {
            const auto state = randomState(random, team);
            if (!setup.getTeamChecker()->isValid(state.get()))
                continue;
            ++free;
            setup.getStatistics().reset();
            ASSERT_TRUE(setup.getTeamChecker()->isValid(state.get()));
            asked += setup.getStatistics().getCounts().asked > 0 ? 1 : 0;
        }
        EXPECT_GT(free, 30U);
        EXPECT_EQ(asked, 0U) << nameOf(method);
    }
}
