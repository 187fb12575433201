#include "support/Checkers.h"
#include "support/ErrorsOnly.h"
#include "support/IterationLimit.h"

#include <atomic>
#include <chrono>
#include <gtest/gtest.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/util/Console.h>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** Checks a random walk of motions, the same for every method. */
    void walk(const TeamSetup &setup, const TeamStateSpacePtr &team, unsigned int steps)
    {
        Random random(5);
        // From a valid state: near an invalid one, hardly anything else would be checked.
        std::vector<ob::ScopedState<>> tree{randomState(random, team)};
        while (!setup.getSpaceInformation()->isValid(tree[0].get()))
            tree[0] = randomState(random, team);
        for (unsigned int i = 0; i < steps; ++i)
        {
            const auto &from = tree[random.below(tree.size())];
            const auto to = randomStateNear(random, from, random.uniform(0.02, 0.2));
            if (setup.getSpaceInformation()->isValid(to.get()) &&
                setup.getSpaceInformation()->checkMotion(from.get(), to.get()))
                tree.push_back(to);
        }
    }

    /** Obstacles whose clearances take longer than any exact check */
    class SlowClearances : public ExpensiveObstacles
    {
    public:
        using ExpensiveObstacles::ExpensiveObstacles;

        double findNearest(const Eigen::Vector3d &point, ObstaclePart &part) const override
        {
            pause();
            return ExpensiveObstacles::findNearest(point, part);
        }

        double clearance(const Eigen::Vector3d &point) const override
        {
            pause();
            return ExpensiveObstacles::clearance(point);
        }

    private:
        static void pause()
        {
            const auto end = std::chrono::steady_clock::now() + std::chrono::microseconds(250);
            while (std::chrono::steady_clock::now() < end)
                ;
        }
    };
}

class StatisticsOfATeam : public ErrorsOnly<unsigned int>
{
};

TEST_P(StatisticsOfATeam, AddUp)
{
    Random random(GetParam());
    const auto team = anyTeam(GetParam());
    const Checkers checkers(team, anyObstacles(random, GetParam(), 10));
    for (const auto &setup : checkers.setups)
    {
        SCOPED_TRACE(nameOf(setup->getTeamChecker()->getMethod()));
        setup->getStatistics().reset();
        walk(*setup, team, 500);
        const CheckCounts counts = setup->getStatistics().getCounts();
        EXPECT_EQ(counts.robotPoses, counts.certifiedFree + counts.certifiedColliding + counts.asked);
        EXPECT_EQ(counts.asked, counts.byClearances + counts.byContact + counts.exact);
        EXPECT_LE(counts.askedColliding, counts.asked);
        EXPECT_LE(counts.exact, counts.exactCalls);
        EXPECT_LE(counts.pairExact, counts.pairPoses * 2);
        EXPECT_GT(counts.motions, 0U);
        EXPECT_LE(counts.motions, 500U);
        EXPECT_GE(counts.motionSamples, counts.motions);
        EXPECT_LE(counts.motionSamplesSkipped, counts.motionSamples);
        EXPECT_GT(setup->getStatistics().getCheckingSeconds(), 0.0);
        EXPECT_LT(setup->getStatistics().getCheckingSeconds(), 60.0);
        if (makesCertificates(setup->getTeamChecker()->getMethod()))
        {
            EXPECT_GT(counts.certifiedFree, 0U);
            EXPECT_GT(counts.motionSamplesSkipped, 0U);
            EXPECT_GT(setup->getTeamChecker()->getCertificateCount(), 0U);
        }
        else
        {
            EXPECT_EQ(counts.asked, counts.robotPoses);
            EXPECT_EQ(counts.byClearances, 0U);
            if (nameOf(setup->getTeamChecker()->getMethod()) == "fcl")
            {
                EXPECT_EQ(counts.exact, counts.robotPoses);
                EXPECT_EQ(counts.contactTests, 0U);
            }
            else
            {
                EXPECT_GT(counts.contactTests, 0U);
            }
            EXPECT_EQ(counts.motionSamplesSkipped, 0U);
            EXPECT_EQ(counts.clearanceQueries, 0U);
        }
        setup->getStatistics().reset();
        EXPECT_EQ(setup->getStatistics().getCounts().robotPoses, 0U);
        EXPECT_EQ(setup->getStatistics().getCheckingSeconds(), 0.0);
    }
}

INSTANTIATE_TEST_SUITE_P(Kind, StatisticsOfATeam, testing::Values(0U, 1U, 2U, 4U));

TEST(Statistics, ShowFewerExactChecksTheMoreIsShared)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    Random random(11);
    const auto team = teamOfDiscs();
    const Checkers checkers(team, scatteredObstacles(random, 2, 10));
    std::vector<double> fractions;
    for (const auto &setup : checkers.setups)
    {
        setup->getTeamChecker()->setAdaptive(false);
        setup->getStatistics().reset();
        walk(*setup, team, 3000);
        const CheckCounts counts = setup->getStatistics().getCounts();
        fractions.push_back(static_cast<double>(counts.asked) / static_cast<double>(counts.robotPoses));
    }
    EXPECT_EQ(fractions[0], 1.0) << "fcl";
    EXPECT_EQ(fractions[1], 1.0) << "standard";
    EXPECT_LE(fractions[2], 1.0) << "basic";
    EXPECT_LE(fractions[3], fractions[2]) << "partial";
    EXPECT_LE(fractions[4], fractions[3]) << "shared";
    EXPECT_LT(fractions[4], 0.3);
}

TEST(Statistics, RepeatThemselvesWhereNoClockDecides)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    const auto team = mixedTeam();
    Random random(3);
    std::vector<PlacedBody> bodies;
    for (int i = 0; i < 10; ++i)
        bodies.push_back({randomBody(random, 2, random.uniform(0.3, 1.5)), random.pose(2, HALF)});
    const auto walkAmong = [&](const ObstaclesPtr &obstacles, bool adaptive)
    {
        const Checkers checkers(team, obstacles);
        std::vector<std::vector<std::uint64_t>> all;
        for (const auto &setup : checkers.certified())
        {
            EXPECT_TRUE(setup->getTeamChecker()->isAdaptive());
            setup->getTeamChecker()->setAdaptive(adaptive);
            setup->getStatistics().reset();
            walk(*setup, team, 500);
            const CheckCounts counts = setup->getStatistics().getCounts();
            all.push_back({counts.robotPoses, counts.certifiedFree, counts.exact, counts.contactTests,
                           counts.clearanceQueries, counts.steppedAside, counts.pairExact,
                           setup->getTeamChecker()->getCertificateCount()});
        }
        return all;
    };
    const auto quick = walkAmong(std::make_shared<ExpensiveObstacles>(bodies, 2), false);
    EXPECT_EQ(walkAmong(std::make_shared<SlowClearances>(bodies, 2), false), quick);
    const auto adapted = walkAmong(std::make_shared<SlowClearances>(bodies, 2), true);
    for (std::size_t method = 0; method < quick.size(); ++method)
    {
        EXPECT_EQ(quick[method][5], 0U);
        EXPECT_GT(adapted[method][5], 0U);
        EXPECT_GT(adapted[method][3], quick[method][3]);
    }
}

TEST(Statistics, SumExactlyOverThreadsThatShareASlot)
{
    // The first sixteen threads that count have slots of their own, and of the others every sixteenth has the same one.
    // So all threads count once, to be numbered, and then every sixteenth counts while the others of its slot do.
    constexpr std::uint64_t THREADS = 80, APART = 16, TIMES = 300000, ALL = THREADS + THREADS / APART * TIMES;
    Statistics statistics;
    std::atomic<std::uint64_t> numbered{0};
    std::vector<std::thread> threads;
    for (std::uint64_t i = 0; i < THREADS; ++i)
    {
        threads.emplace_back(
            [&, goesOn = i % APART == 0]
            {
                CheckCounts counts;
                counts.robotPoses = 2;
                counts.motionSamplesSkipped = 3;
                statistics.add(counts);
                ++numbered;
                if (!goesOn)
                    return;
                while (numbered < THREADS)
                    std::this_thread::yield();
                for (std::uint64_t k = 0; k < TIMES; ++k)
                    statistics.add(counts);
            });
        while (numbered <= i)
            std::this_thread::yield();
    }
    for (auto &thread : threads)
        thread.join();
    EXPECT_EQ(statistics.getCounts().robotPoses, 2 * ALL);
    EXPECT_EQ(statistics.getCounts().motionSamplesSkipped, 3 * ALL);
    EXPECT_EQ(statistics.getCount(&CheckCounts::robotPoses), 2 * ALL);
    EXPECT_EQ(statistics.getCounts().motions, 0U);
}
