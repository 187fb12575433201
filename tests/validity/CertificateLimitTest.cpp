#include "ompl_certificates/certificates/CertificateTree.h"
#include "support/Checkers.h"

#include <gtest/gtest.h>
#include <malloc.h>
#include <ompl/util/Console.h>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    class CertificateLimits : public testing::TestWithParam<unsigned int>
    {
    protected:
        void SetUp() override
        {
            ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
        }

        void check(const Checkers &checkers, const TeamSetup &setup, unsigned int seed) const
        {
            Random random(seed);
            ob::ScopedState<> previous = randomState(random, checkers.team);
            for (unsigned int i = 0; i < scaled(300); ++i)
            {
                const ob::ScopedState<> state = randomState(random, checkers.team);
                EXPECT_EQ(setup.getTeamChecker()->isValid(state.get()), checkers.isValid(state.get()));
                setup.getSpaceInformation()->checkMotion(previous.get(), state.get());
                previous = state;
            }
        }
    };
}

TEST_P(CertificateLimits, HoldForManyThreadsAndChangeNoVerdict)
{
    Random random(GetParam());
    const TeamStateSpacePtr team = anyTeam(GetParam());
    const Checkers checkers(team, scatteredObstacles(random, team->getWorkspaceDimension(), 10));
    for (const auto &setup : checkers.certified())
    {
        const auto checker = setup->getTeamChecker();
        // However the clock goes, certificates enough are wanted.
        checker->setAdaptive(false);
        constexpr std::size_t most = 23;
        checker->params().setParam("max_certificates", std::to_string(most));
        EXPECT_EQ(checker->getMaxCertificates(), most);
        for (const char *const none : {"-5", "", "many", "1.5", "99999999999999999999999"})
            EXPECT_FALSE(checker->params().setParam("max_certificates", none)) << none;
        EXPECT_EQ(checker->getMaxCertificates(), most);
        std::atomic<bool> done{false};
        std::size_t largest = 0;
        std::thread watching(
            [&]
            {
                while (!done)
                    largest = std::max(largest, checker->getKeptCertificates());
            });
        std::vector<std::thread> threads;
        for (unsigned int i = 0; i < 3; ++i)
            threads.emplace_back([&, i] { check(checkers, *setup, 10 + i); });
        for (auto &thread : threads)
            thread.join();
        done = true;
        watching.join();
        EXPECT_LE(largest, most) << nameOf(checker->getMethod());
        EXPECT_LE(checker->getCertificates().size(), most);
        // Basic keeps certificates of whole teams, of up to four bodies, or nothing.
        EXPECT_GT(checker->getKeptCertificates(), most - 4);
        EXPECT_LE(checker->getCertificateCount(), checker->getKeptCertificates());

        checker->clear();
        EXPECT_EQ(checker->getKeptCertificates(), 0U);
        checker->setMaxCertificates(0);
        check(checkers, *setup, 20);
        EXPECT_EQ(checker->getKeptCertificates(), 0U);
        checker->setMaxCertificates(1000000);
        check(checkers, *setup, 20);
        EXPECT_GT(checker->getKeptCertificates(), most);
    }
}

INSTANTIATE_TEST_SUITE_P(Kind, CertificateLimits, testing::Range(0U, 3U));

TEST(Memory, OfCertificatesIsThatOfTheDocumentation)
{
    for (const unsigned int dimension : {2U, 3U})
    {
        Random random(dimension);
        CertificateTree tree(dimension);
        for (unsigned int i = 0; i < 100000; ++i)
            tree.insert({random.point(dimension, 1.0), random.uniform(0.0, 0.1)});
        const double bytes = static_cast<double>(tree.bytes()) / static_cast<double>(tree.size());
        RecordProperty("bytes", std::to_string(bytes));
        std::printf("%u dimensions: %.0f bytes for each certificate\n", dimension, bytes);
        EXPECT_LT(bytes, 300.0);
    }
}

// OMPL_CERTIFICATES_TEST_SCALE=100 makes a million motions for each method.
TEST(Memory, StaysAsItIsOnceTheLimitIsReached)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    Random random(1);
    const TeamStateSpacePtr team = anyTeam(0);
    const Checkers checkers(team, scatteredObstacles(random, team->getWorkspaceDimension(), 60));
    constexpr std::size_t most = 100;
    for (const auto &setup : checkers.certified())
    {
        const auto checker = setup->getTeamChecker();
        checker->setMaxCertificates(most);
        ob::ScopedState<> from = randomState(random, team), to = from;
        const unsigned int motions = scaled(10000);
        std::size_t early = 0;
        for (unsigned int i = 0; i <= motions; ++i)
        {
            if (i % (motions / 10) == 0)
            {
                const std::size_t heap = mallinfo2().uordblks;
                std::printf("%s, %u motions: %zu certificates, heap %zu bytes\n", nameOf(checker->getMethod()).c_str(),
                            i, checker->getKeptCertificates(), heap);
                if (i == 2 * (motions / 10))
                    early = heap;
                if (early > 0)
                {
                    EXPECT_LE(heap, early + 4096);
                }
            }
            to = randomState(random, team);
            team->interpolate(from.get(), to.get(), 0.1, to.get());
            if (checker->isValid(to.get()) && setup->getSpaceInformation()->checkMotion(from.get(), to.get()))
                from = to;
            else if (i % 50 == 0)
                from = randomState(random, team);
        }
        EXPECT_GT(checker->getKeptCertificates(), most - team->getRobotCount());
    }
}

TEST(Memory, OfTeamStatesIsThatOfTheDocumentation)
{
    const auto bounds = cubeBounds(2, HALF);
    for (const unsigned int robots : {1U, 3U, 5U})
    {
        auto team = std::make_shared<TeamStateSpace>();
        for (unsigned int i = 0; i < robots; ++i)
            team->addRobot(RigidRobot::disc(std::to_string(i), 0.1, bounds));
        team->setup();
        constexpr std::size_t count = 20000;
        std::vector<ob::State *> states;
        states.reserve(count);
        const std::size_t before = mallinfo2().uordblks;
        while (states.size() < count)
            states.push_back(team->allocState());
        const double bytes = static_cast<double>(mallinfo2().uordblks - before) / count;
        for (ob::State *state : states)
            team->freeState(state);
        std::printf("%u discs: %.0f bytes for each state\n", robots, bytes);
        EXPECT_LT(bytes, 80.0 + 64.0 * robots);
    }
}
