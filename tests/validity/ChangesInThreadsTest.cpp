#include "support/Checkers.h"

#include "ompl_certificates/obstacles/ObstacleSet.h"

#include <atomic>
#include <chrono>
#include <gtest/gtest.h>
#include <ompl/util/Console.h>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    class ChangesInThreads : public testing::Test
    {
    protected:
        void SetUp() override
        {
            ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
        }

        PlacedBody randomObstacle(Random &random)
        {
            const Body body = randomBody(random, 2, random.uniform(0.3, 2.0));
            return {body, random.pose(2, HALF)};
        }
    };
}

TEST_F(ChangesInThreads, WaitForChecksOfOtherThreads)
{
    // Two worlds in turns: all verdicts are of one or the other, never of a mixture.
    const TeamStateSpacePtr team = teamOfDiscs();
    ObstacleSet set(2);
    const auto at = [](double x) { return Pose(Eigen::Translation3d(x, 0.0, 0.0)); };
    const ObstacleSet::Id left = set.add({Body::box(4.0, 9.0), at(-2.5)});
    TeamSetup setup(team, set.takeChange().after);
    setup.getSpaceInformation()->setup();
    const auto checker = setup.getTeamChecker();
    checker->setCertificatesAfter(0);
    std::atomic<bool> done{false};
    std::atomic<unsigned int> checks{0}, wrong{0};
    // The robots are on both sides of the middle, so one of them always touches the box.
    const auto check = [&]
    {
        ob::ScopedState<> state(team);
        Random random(2);
        while (!done)
        {
            double side = 1.0;
            for (unsigned int robot = 0; robot < team->getRobotCount(); ++robot, side = -side)
            {
                auto *values = state->as<ob::CompoundState>()
                                   ->components[robot]
                                   ->as<ob::RealVectorStateSpace::StateType>()
                                   ->values;
                values[0] = side * random.uniform(1.0, 4.0);
                values[1] = -3.0 + 3.0 * robot;
            }
            ++checks;
            if (checker->isValid(state.get()))
                ++wrong;
        }
    };
    std::thread first(check), second(check);
    for (int i = 0; i < 200; ++i)
    {
        set.move(left, at(i % 2 == 0 ? 2.5 : -2.5));
        checker->changeObstacles(set.takeChange());
    }
    while (checks < 2000)
        std::this_thread::yield();
    done = true;
    first.join();
    second.join();
    EXPECT_EQ(wrong, 0U);
}

TEST_F(ChangesInThreads, EndWhateverOtherThreadsCheckMeanwhile)
{
    // Checks that make certificates again as fast as the change withdraws them
    const TeamStateSpacePtr team = teamOfDiscs();
    Random random(5);
    ObstacleSet set(2);
    for (int i = 0; i < 1000; ++i)
        set.add({Body::box(0.02, 0.02), random.pose(2, HALF)});
    TeamSetup setup(team, set.takeChange().after);
    setup.getSpaceInformation()->setup();
    const auto checker = setup.getTeamChecker();
    checker->setAdaptive(false);
    std::vector<ob::ScopedState<>> states;
    for (int i = 0; i < 5000; ++i)
        states.push_back(randomState(random, team));
    for (const auto &state : states)
        checker->isValid(state.get());
    const std::size_t before = checker->getCertificateCount();
    ASSERT_GT(before, 1000U);
    std::atomic<bool> done{false};
    const auto check = [&](unsigned int seed)
    {
        Random own(seed);
        while (!done)
        {
            const auto world = checker->holdObstacles();
            for (int i = 0; i < 300; ++i)
                checker->isValid(states[own.below(states.size())].get());
        }
    };
    std::thread first(check, 1), second(check, 2);
    for (int i = 0; i < 1000; ++i)
        set.add({Body::disc(0.01), random.pose(2, HALF)});
    std::atomic<bool> ended{false};
    std::thread change(
        [&]
        {
            checker->changeObstacles(set.takeChange());
            ended = true;
        });
    // Some ten milliseconds; a test that fails ends, too: once no others check
    for (int i = 0; i < 3000 && !ended; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_TRUE(ended);
    done = true;
    for (std::thread *thread : {&first, &second, &change})
        thread->join();
    EXPECT_LT(checker->getCertificateCount(), 6 * before);
}

TEST_F(ChangesInThreads, WaitWhileObstaclesAreHeld)
{
    const TeamStateSpacePtr team = teamOfDiscs();
    for (const Method method : {Method::BASIC, Method::SHARED_PROJECTION})
    {
        Random random(3);
        ObstacleSet set(2);
        for (int i = 0; i < 40; ++i)
            set.add(randomObstacle(random));
        const ObstacleSet::Id crate = set.add({Body::box(1.0, 1.0)});
        TeamSetup setup(team, set.takeChange().after, method);
        setup.getSpaceInformation()->setup();
        const auto checker = setup.getTeamChecker();
        checker->setAdaptive(false);
        std::atomic<bool> done{false};
        std::atomic<std::size_t> seen{0}, wrong{0};
        std::thread reader(
            [&]
            {
                while (!done)
                {
                    const auto world = checker->holdObstacles();
                    const Obstacles &obstacles = checker->getObstacles();
                    for (const Certificate &certificate : checker->getCertificates())
                    {
                        ++seen;
                        if (!(std::abs(certificate.clearance - obstacles.clearance(certificate.point)) < 1e-3))
                            ++wrong;
                    }
                }
            });
        for (int i = 0; i < 200; ++i)
        {
            for (int k = 0; k < 3; ++k)
                checker->isValid(randomState(random, team).get());
            set.move(crate, planarPose(random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0)));
            checker->changeObstacles(set.takeChange());
        }
        // On a busy machine the reader may not have had its turn yet.
        while (seen == 0 && checker->getCertificateCount() > 0)
            std::this_thread::yield();
        done = true;
        reader.join();
        EXPECT_GT(seen, 0U) << nameOf(checker->getMethod()) << " " << checker->getCertificateCount();
        EXPECT_EQ(wrong, 0U);
    }
}

TEST_F(ChangesInThreads, AreNotKeptWaitingByOneHoldAfterTheOther)
{
    const TeamStateSpacePtr team = teamOfDiscs();
    Random random(8);
    ObstacleSet set(2);
    for (int i = 0; i < 60; ++i)
        set.add(randomObstacle(random));
    TeamSetup setup(team, set.takeChange().after);
    setup.getSpaceInformation()->setup();
    const auto checker = setup.getTeamChecker();
    checker->setCertificatesAfter(0);
    checker->setAdaptive(false);
    while (checker->getCertificateCount() < 2000)
        checker->isValid(randomState(random, team).get());
    std::atomic<bool> done{false};
    std::atomic<int> holds{0};
    std::thread planner(
        [&]
        {
            while (!done)
            {
                const auto world = checker->holdObstacles();
                ++holds;
                std::this_thread::sleep_for(std::chrono::milliseconds(30));
            }
        });
    while (holds == 0)
        std::this_thread::yield();
    // One that fills the workspace concerns all certificates, so the change takes many steps.
    set.add({Body::box(2.0 * HALF, 2.0 * HALF)});
    const ObstacleChange change = set.takeChange();
    const int before = holds;
    checker->changeObstacles(change);
    EXPECT_LE(holds - before, 5);
    done = true;
    planner.join();
}
