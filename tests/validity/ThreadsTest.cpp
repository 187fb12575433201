#include "support/Chain.h"
#include "support/Checkers.h"

#include <atomic>
#include <chrono>
#include <gtest/gtest.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

class Threads : public testing::TestWithParam<unsigned int>
{
};

TEST_P(Threads, OnOneCheckerGetTheVerdictsOfOneAlone)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    Random random(GetParam());
    const auto team = anyTeam(GetParam());
    const Checkers checkers(team, anyObstacles(random, GetParam(), 10));
    const auto &alone = *checkers.reference().getSpaceInformation();
    constexpr unsigned int count = 400;
    std::vector<ob::ScopedState<>> states;
    std::vector<bool> valid, motions;
    std::vector<double> lastValid;
    for (unsigned int i = 0; i <= count; ++i)
        states.push_back(i % 5 == 0 ? randomState(random, team) : randomStateNear(random, states.back(), 0.1));
    for (unsigned int i = 0; i < count; ++i)
    {
        valid.push_back(alone.isValid(states[i].get()));
        std::pair<ob::State *, double> last{nullptr, 1.0};
        motions.push_back(alone.checkMotion(states[i].get(), states[i + 1].get(), last));
        lastValid.push_back(last.second);
    }
    for (const auto &setup : checkers.setups)
        for (unsigned int round = 0; round < scaled(3); ++round)
        {
            SCOPED_TRACE(nameOf(setup->getTeamChecker()->getMethod()));
            setup->getTeamChecker()->clear();
            setup->getStatistics().reset();
            const auto &si = *setup->getSpaceInformation();
            si.getMotionValidator()->resetMotionCounter();
            std::atomic<unsigned int> wrong{0};
            std::vector<std::thread> threads;
            for (unsigned int thread = 0; thread < 4; ++thread)
                threads.emplace_back(
                    [&, thread]
                    {
                        // Each thread in another order, all on the same states with their references
                        for (unsigned int k = 0; k < count; ++k)
                        {
                            const unsigned int i = (k * (2 * thread + 1) + 100 * thread) % count;
                            std::pair<ob::State *, double> last{nullptr, 1.0};
                            if (si.isValid(states[i].get()) != valid[i] ||
                                si.checkMotion(states[i].get(), states[i + 1].get()) != motions[i] ||
                                si.checkMotion(states[i].get(), states[i + 1].get(), last) != motions[i] ||
                                (!motions[i] && last.second != lastValid[i]))
                                ++wrong;
                        }
                    });
            for (auto &thread : threads)
                thread.join();
            EXPECT_EQ(wrong, 0U);
            const CheckCounts counts = setup->getStatistics().getCounts();
            EXPECT_EQ(counts.robotPoses, counts.certifiedFree + counts.certifiedColliding + counts.asked);
            EXPECT_EQ(counts.motions, 4U * 2U * count);
            EXPECT_EQ(si.getMotionValidator()->getCheckedMotionCount(), 4U * 2U * count);
        }
}

TEST_P(Threads, MayCheckWhileAllIsForgotten)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    Random random(GetParam());
    const auto team = anyTeam(GetParam());
    const Checkers checkers(team, anyObstacles(random, GetParam(), 10));
    const auto &alone = *checkers.reference().getSpaceInformation();
    std::vector<ob::ScopedState<>> states;
    std::vector<bool> valid;
    for (unsigned int i = 0; i < 100; ++i)
    {
        states.push_back(randomState(random, team));
        valid.push_back(alone.isValid(states.back().get()));
    }
    for (const auto &setup : checkers.certified())
    {
        const auto checker = setup->getTeamChecker();
        SCOPED_TRACE(nameOf(checker->getMethod()));
        checker->setAdaptive(false);
        std::atomic<bool> done{false};
        std::atomic<unsigned int> wrong{0};
        std::vector<std::thread> threads;
        for (unsigned int thread = 0; thread < 2; ++thread)
            threads.emplace_back(
                [&]
                {
                    while (!done)
                        for (std::size_t i = 0; i < states.size(); ++i)
                            if (checker->isValid(states[i].get()) != valid[i])
                                ++wrong;
                });
        for (unsigned int i = 0; i < scaled(12); ++i)
        {
            checker->clear();
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
        done = true;
        for (auto &thread : threads)
            thread.join();
        EXPECT_EQ(wrong, 0U);
        const auto world = checker->holdObstacles();
        EXPECT_THROW(checker->clear(), ompl::Exception);
    }
}

TEST_P(Threads, MayAskForClearances)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    Random random(GetParam());
    const auto team = anyTeam(GetParam());
    const Checkers checkers(team, anyObstacles(random, GetParam(), 10));
    const auto &checker = *checkers.setups.back()->getTeamChecker();
    std::vector<ob::ScopedState<>> states;
    std::vector<double> clearances;
    for (int i = 0; i < 50; ++i)
    {
        states.push_back(randomState(random, team));
        clearances.push_back(checker.clearance(states.back().get()));
    }
    std::atomic<unsigned int> wrong{0};
    std::vector<std::thread> threads;
    for (unsigned int thread = 0; thread < 4; ++thread)
        threads.emplace_back(
            [&]
            {
                for (std::size_t i = 0; i < states.size(); ++i)
                    if (checker.clearance(states[i].get()) != clearances[i])
                        ++wrong;
            });
    for (auto &thread : threads)
        thread.join();
    EXPECT_EQ(wrong, 0U);
}

TEST(ThreadsOnArms, SettleTheJointCellsOfOneRobotForAllItsCheckers)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    for (unsigned int seed = 0; seed < scaled(10); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(randomChain(random, 3));
        const auto obstacles = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 3);
        const Checkers checkers(team, obstacles);
        const auto certified = checkers.certified();
        const auto &alone = *checkers.reference().getSpaceInformation();
        std::vector<ob::ScopedState<>> states;
        std::vector<bool> valid, motions;
        for (unsigned int i = 0; i <= 200; ++i)
            states.push_back(i % 5 == 0 ? randomState(random, team) : randomStateNear(random, states.back(), 0.1));
        for (std::size_t i = 0; i + 1 < states.size(); ++i)
        {
            valid.push_back(alone.isValid(states[i].get()));
            motions.push_back(alone.checkMotion(states[i].get(), states[i + 1].get()));
        }
        std::atomic<unsigned int> wrong{0};
        std::vector<std::thread> threads;
        for (unsigned int thread = 0; thread < 4; ++thread)
            threads.emplace_back(
                [&, thread]
                {
                    // Two of them have the same checker; all checkers share the robot's cells.
                    const auto &si = *certified[thread % certified.size()]->getSpaceInformation();
                    for (std::size_t i = 0; i < valid.size(); ++i)
                        if (si.isValid(states[i].get()) != valid[i] ||
                            si.checkMotion(states[i].get(), states[i + 1].get()) != motions[i])
                            ++wrong;
                });
        for (auto &thread : threads)
            thread.join();
        EXPECT_EQ(wrong, 0U);
    }
}

INSTANTIATE_TEST_SUITE_P(Kind, Threads, testing::Range(0U, TEAMS));
