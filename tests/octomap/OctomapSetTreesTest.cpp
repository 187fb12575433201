// Plans in a map that changes: the trees are those of a fresh map. Checks of other threads see one map or the other.

#include "MapTeams.h"
#include "MapTrees.h"
#include "RandomMaps.h"
#include "ompl_certificates/octomap/OctomapSet.h"

#include <atomic>
#include <gtest/gtest.h>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    constexpr double CELL_SIZE = 0.2;

    OctomapOptions optionsFor(unsigned int dimension)
    {
        OctomapOptions options;
        if (dimension == 2)
            options.slice = {-0.5, 0.5};
        return options;
    }
}

TEST(OctomapSetTrees, AreThoseOfAFreshMap)
{
    std::size_t numbers = 0, kept = 0;
    for (unsigned int seed = 1; seed <= scaled(4); ++seed)
        for (const unsigned int dimension : {2U, 3U})
        {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", dimension " + std::to_string(dimension));
            Random random(seed);
            const auto team = teamFor(dimension);
            const auto map = randomMap(random, CELL_SIZE);
            OctomapSet set(*map, optionsFor(dimension));
            const Checkers changed(team, set.takeChange().after);
            for (const auto &setup : changed.certified())
                setup->getTeamChecker()->setAdaptive(false);
            for (int round = 0; round < 4; ++round)
            {
                const ObstacleChange change = set.takeChange();
                for (const auto &setup : changed.setups)
                    setup->getTeamChecker()->changeObstacles(change);
                const auto now = std::make_shared<OctomapObstacles>(*map, optionsFor(dimension));
                TeamSetup fresh(team, now, Method::FCL);
                const auto start = validState(random, team, fresh), goal = validState(random, team, fresh);
                for (const char *planner : {"RRT", "RRTConnect"})
                {
                    const auto expected = growTree(fresh, planner, seed, start, goal);
                    numbers += expected.size();
                    for (const auto &setup : changed.setups)
                        ASSERT_EQ(growTree(*setup, planner, seed, start, goal), expected)
                            << planner << ", " << nameOf(setup->getTeamChecker()->getMethod());
                }
                kept += changed.certified().back()->getTeamChecker()->getCertificates().size();
                scan(random, *map);
            }
        }
    EXPECT_GT(numbers, scaled(4) * 400U);
    EXPECT_GT(kept, 0U);
}

/** Some threads check states while another lets the map change again and again. A verdict must be that of one of the
    maps there were during the check. */
TEST(OctomapSetThreads, SeeOneMapOrTheOther)
{
    for (const unsigned int dimension : {2U, 3U})
        for (unsigned int seed = 1; seed <= scaled(3); ++seed)
        {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", dimension " + std::to_string(dimension));
            Random random(seed);
            const auto team = teamFor(dimension);
            const auto map = randomMap(random, CELL_SIZE);
            OctomapSet set(*map, optionsFor(dimension));
            TeamSetup setup(team, set.takeChange().after);
            const auto checker = setup.getTeamChecker();
            setup.getSpaceInformation()->setup();
            checker->setAdaptive(false);

            constexpr unsigned int rounds = 12, count = 200;
            std::vector<ob::ScopedState<>> states;
            for (unsigned int i = 0; i < count; ++i)
                states.push_back(randomState(random, team));
            // The maps that there will be, and what each says
            std::vector<ObstacleChange> changes;
            std::vector<std::vector<bool>> valid;
            for (unsigned int round = 0; round <= rounds; ++round)
            {
                TeamSetup fresh(team, std::make_shared<OctomapObstacles>(*map, optionsFor(dimension)),
                                Method::STANDARD);
                fresh.getSpaceInformation()->setup();
                valid.emplace_back();
                for (const auto &state : states)
                    valid.back().push_back(fresh.getTeamChecker()->isValid(state.get()));
                scan(random, *map);
                changes.push_back(set.takeChange());
            }
            // While change i is made, the map is the one before or the one after it.
            std::atomic<unsigned int> begun{0}, ended{0}, wrong{0}, checks{0};
            std::vector<std::thread> readers;
            for (unsigned int reader = 0; reader < 2; ++reader)
                readers.emplace_back(
                    [&, reader]
                    {
                        Random own(100 * seed + reader);
                        while (ended < rounds)
                        {
                            const unsigned int i = own.below(count), from = ended;
                            const bool verdict = checker->isValid(states[i].get());
                            const unsigned int to = begun;
                            bool known = false;
                            for (unsigned int at = from; at <= to; ++at)
                                known |= valid[at][i] == verdict;
                            wrong += known ? 0 : 1;
                            ++checks;
                        }
                    });
            for (unsigned int round = 0; round < rounds; ++round)
            {
                const unsigned int before = checks;
                while (checks < before + 50)
                    std::this_thread::yield();
                ++begun;
                checker->changeObstacles(changes[round]);
                ++ended;
            }
            for (auto &reader : readers)
                reader.join();
            EXPECT_EQ(wrong, 0U);
        }
}
