#include "planning/LazyConstraintSearch.h"
#include "support/CrowdProblem.h"
#include "support/Quiet.h"

#include <gtest/gtest.h>
#include <ompl/util/RandomNumbers.h>
#include <queue>
#include <set>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    using Configuration = TeamRoadmaps::Configuration;
    using Path = TeamRoadmaps::Path;

    constexpr std::uint64_t NO_LIMIT = 10'000'000;

    /** Discs of radius 0.3 and their roadmap */
    struct Discs
    {
        Discs(unsigned int robots, const std::vector<PlacedBody> &obstacles)
        {
            auto team = std::make_shared<TeamStateSpace>();
            for (unsigned int i = 0; i < robots; ++i)
                team->addRobot(RigidRobot::disc("disc_" + std::to_string(i), 0.3, cubeBounds(2, 10.0)));
            setup = std::make_shared<TeamSetup>(team, std::make_shared<FclObstacles>(obstacles, 2));
            setup->getSpaceInformation()->setup();
            validator =
                dynamic_cast<CertificateMotionValidator *>(setup->getSpaceInformation()->getMotionValidator().get());
            roadmaps = std::make_unique<TeamRoadmaps>(*validator, true, 1);
        }

        Roadmap::Vertex add(double x, double y)
        {
            Roadmap &roadmap = roadmaps->getRoadmap(0);
            ob::ScopedState<> state(setup->getTeam().getRobot(0).getStateSpace());
            state = std::vector<double>{x, y};
            return roadmap.add(state.get());
        }

        bool isValid(const Configuration &configuration) const
        {
            ob::ScopedState<> state(setup->getStateSpace());
            roadmaps->copyTo(configuration, state.get());
            return setup->getSpaceInformation()->isValid(state.get());
        }

        std::optional<Path> search(const Configuration &start, const Configuration &goal,
                                   std::uint64_t steps = NO_LIMIT)
        {
            return LazyConstraintSearch(*roadmaps, start, goal).search(steps, ob::plannerNonTerminatingCondition());
        }

        void expectPath(const Path &path, const Configuration &start, const Configuration &goal)
        {
            EXPECT_EQ(path.front(), start);
            EXPECT_EQ(path.back(), goal);
            for (std::size_t step = 1; step < path.size(); ++step)
                EXPECT_TRUE(roadmaps->isStepFree(path[step - 1], path[step])) << "step " << step;
        }

        TeamSetupPtr setup;
        const CertificateMotionValidator *validator;
        std::unique_ptr<TeamRoadmaps> roadmaps;
    };

    /** Discs in a corridor along x, from 0 to 6, in which no two pass each other. Perhaps it has a niche at x = 3. */
    Discs corridor(unsigned int robots, bool hasNiche)
    {
        std::vector<PlacedBody> walls{{Body::box(10.0, 1.0), planarPose(3.0, -0.9, 0.0)}};
        if (hasNiche)
        {
            walls.push_back({Body::box(3.6, 1.0), planarPose(0.8, 0.9, 0.0)});
            walls.push_back({Body::box(3.6, 1.0), planarPose(5.2, 0.9, 0.0)});
        }
        else
            walls.push_back({Body::box(10.0, 1.0), planarPose(3.0, 0.9, 0.0)});
        return {robots, walls};
    }

    /** Whether any sequence of steps leads from \e start to \e goal: all are tried */
    bool isReachable(TeamRoadmaps &roadmaps, const Configuration &start, const Configuration &goal)
    {
        const Roadmap::Vertex size = roadmaps.getRoadmap(0).size();
        std::set<Configuration> known{start};
        std::queue<Configuration> open({start});
        for (; !open.empty(); open.pop())
        {
            Configuration next(start.size(), 0);
            for (bool isLast = false; !isLast;)
            {
                if (known.count(next) == 0 && roadmaps.isStepFree(open.front(), next))
                {
                    known.insert(next);
                    open.push(next);
                }
                std::size_t robot = 0;
                while (robot < next.size() && ++next[robot] == size)
                    next[robot++] = 0;
                isLast = robot == next.size();
            }
        }
        return known.count(goal) > 0;
    }
}

TEST(LazyConstraintSearch, FindsAPathWhereThereIsOneAndEndsWhereThereIsNone)
{
    const Quiet quiet;
    unsigned int reachable = 0;
    const unsigned int cases = scaled(60);
    for (unsigned int seed = 1; seed <= cases; ++seed)
    {
        ompl::RNG::setSeed(seed);
        Random random(seed);
        Discs discs(3, {{Body::box(0.3, 0.3)}});
        while (discs.roadmaps->getRoadmap(0).size() < 7)
        {
            const double x = random.uniform(-1.2, 1.2), y = random.uniform(-1.2, 1.2);
            ob::ScopedState<> state(discs.setup->getTeam().getRobot(0).getStateSpace());
            state = std::vector<double>{x, y};
            if (discs.setup->getTeamChecker()->isRobotFree(0, state.get()))
                discs.add(x, y);
        }
        const auto draw = [&]
        {
            for (unsigned int tries = 0; tries < 1000; ++tries)
                if (Configuration drawn{random.below(7U), random.below(7U), random.below(7U)}; discs.isValid(drawn))
                    return drawn;
            return Configuration();
        };
        const Configuration start = draw(), goal = draw();
        if (start.empty())
            continue;
        const auto path = discs.search(start, goal);
        ASSERT_EQ(path.has_value(), isReachable(*discs.roadmaps, start, goal)) << "seed " << seed;
        if (path)
            discs.expectPath(*path, start, goal);
        reachable += path && start != goal ? 1 : 0;
    }
    EXPECT_GT(reachable, cases / 10);
    EXPECT_LT(reachable, cases);
}

TEST(LazyConstraintSearch, LetsDiscsPassEachOtherByANiche)
{
    const Quiet quiet;
    for (unsigned int seed = 1; seed <= 5; ++seed)
    {
        ompl::RNG::setSeed(seed);
        Discs discs = corridor(3, true);
        for (unsigned int x = 0; x <= 6; ++x)
            discs.add(x, 0.0);
        discs.add(3.0, 1.0);
        const Configuration start{0, 1, 2}, goal{2, 1, 0};
        const auto path = discs.search(start, goal);
        ASSERT_TRUE(path) << "seed " << seed;
        discs.expectPath(*path, start, goal);
    }
}

TEST(LazyConstraintSearch, EndsWhereDiscsCannotPassEachOther)
{
    const Quiet quiet;
    Discs discs = corridor(2, false);
    for (unsigned int x = 0; x <= 6; ++x)
        discs.add(x, 0.0);
    EXPECT_FALSE(discs.search({0, 1}, {1, 0}));
    EXPECT_TRUE(discs.search({0, 1}, {5, 6}));
}

TEST(LazyConstraintSearch, StopsWhenItsStepsAreUsedUp)
{
    const Quiet quiet;
    Discs discs = corridor(2, false);
    for (unsigned int x = 0; x <= 6; ++x)
        discs.add(x, 0.0);
    const Configuration start{0, 1}, goal{5, 6};
    LazyConstraintSearch search(*discs.roadmaps, start, goal);
    EXPECT_FALSE(search.search(1, ob::plannerNonTerminatingCondition()));
    // What it has found so far is a path to somewhere nearer.
    const Path nearer = search.getNearest();
    discs.expectPath(nearer, start, nearer.back());
    EXPECT_GT(nearer.size(), 1U);
    EXPECT_FALSE(search.search(NO_LIMIT, ob::plannerAlwaysTerminatingCondition()));
    EXPECT_TRUE(search.search(NO_LIMIT, ob::plannerNonTerminatingCondition()));
}
