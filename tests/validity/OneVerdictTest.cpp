// In continuous mode a motion has one verdict: that of its geometry.

#include "ompl_certificates/planning/Planners.h"
#include "support/Checkers.h"
#include "support/ErrorsOnly.h"
#include "support/ForwardingObstacles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    /** A box that turns among 25 turned boxes */
    TeamStateSpacePtr boxTeam()
    {
        ob::RealVectorBounds bounds(2);
        bounds.setLow(0.0);
        bounds.setHigh(10.0);
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(RigidRobot::inSE2("box", Body::box(0.6, 0.3), bounds));
        return team;
    }

    ObstaclesPtr boxGrid()
    {
        std::vector<PlacedBody> boxes;
        for (int i = 0; i < 25; ++i)
            boxes.push_back({Body::box(0.6, 0.6), planarPose(1 + 2 * (i % 5), 1 + 2 * (i / 5), 0.3 * i)});
        return std::make_shared<FclObstacles>(boxes, 2);
    }

    /** The team of boxes, or one of anyTeam() */
    constexpr unsigned int BOX = TEAMS;

    struct World
    {
        explicit World(unsigned int kind, Random &random)
          : team(kind == BOX ? boxTeam() : anyTeam(kind))
          , obstacles(kind == BOX ? boxGrid() : anyObstacles(random, kind, 3 + random.below(10)))
        {
        }

        TeamSetupPtr setup(Method method, double resolution = 0.01) const
        {
            auto made = std::make_shared<TeamSetup>(team, obstacles, method, CertificateMotionValidator::CONTINUOUS);
            made->getSpaceInformation()->setStateValidityCheckingResolution(resolution);
            made->getSpaceInformation()->setup();
            made->getTeamChecker()->setCertificatesAfter(0);
            return made;
        }

        TeamStateSpacePtr team;
        ObstaclesPtr obstacles;
    };

    ob::ScopedState<> validState(Random &random, const TeamSetup &setup)
    {
        const auto &team = setup.getSpaceInformation()->getStateSpace();
        for (int i = 0; i < 1000; ++i)
            if (auto state = randomState(random, team); setup.getTeamChecker()->isValid(state.get()))
                return state;
        throw ompl::Exception("No valid state in a thousand");
    }

    /** A motion with its first verdict */
    struct Motion
    {
        ob::ScopedState<> from, to;
        bool valid;
        double fraction;
    };

    /** Whether the motion is valid, and up to where, by the overload that sets the last valid state */
    std::pair<bool, double> checkLast(const TeamSetup &setup, const ob::ScopedState<> &from,
                                      const ob::ScopedState<> &to)
    {
        ob::ScopedState<> state(from.getSpace());
        std::pair<ob::State *, double> last{state.get(), 1.0};
        const bool valid = setup.getSpaceInformation()->checkMotion(from.get(), to.get(), last);
        if (!valid)
        {
            // The valid part of a refused motion must be accepted by itself.
            EXPECT_TRUE(last.second == 0.0 || setup.getSpaceInformation()->checkMotion(from.get(), state.get()));
        }
        return {valid, last.second};
    }

    void expectAgain(const TeamSetup &setup, const Motion &motion)
    {
        const auto &si = *setup.getSpaceInformation();
        EXPECT_EQ(si.checkMotion(motion.from.get(), motion.to.get()), motion.valid);
        EXPECT_EQ(si.checkMotion(motion.to.get(), motion.from.get()), motion.valid);
        EXPECT_EQ(checkLast(setup, motion.to, motion.from).first, motion.valid);
        const auto [valid, fraction] = checkLast(setup, motion.from, motion.to);
        EXPECT_EQ(valid, motion.valid);
        if (motion.fraction >= 0.0)
        {
            EXPECT_EQ(fraction, motion.fraction);
        }
    }
}

class OneVerdict : public ErrorsOnly<unsigned int>
{
};

TEST_P(OneVerdict, OfOverloadsDirectionsMethodsAndWhateverIsKnown)
{
    // By hand 10^5 motions: OMPL_CERTIFICATES_TEST_SCALE=25. In a single world, all motions may be refused.
    const unsigned int worlds = std::max<unsigned int>(scaled(4), 3);
    const unsigned int motionsPerWorld = std::clamp<unsigned int>(scaled(150), 60, 150) * (GetParam() == BOX ? 3 : 1);
    unsigned int accepted = 0, refused = 0;
    for (unsigned int seed = 0; seed < worlds; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(100 * GetParam() + seed);
        const World world(GetParam(), random);
        std::vector<TeamSetupPtr> setups;
        for (const Method method : CERTIFIED)
            setups.push_back(world.setup(method));
        std::vector<Motion> motions;
        for (unsigned int i = 0; i < motionsPerWorld; ++i)
        {
            // Each setup in turn is the first to see a motion.
            const TeamSetup &first = *setups[i % setups.size()];
            const auto from = validState(random, first), to = randomStateNear(random, from, random.uniform(0.0, 0.3));
            Motion motion{from, to, false, -1.0};
            if (random.chance(0.5))
                motion.valid = first.getSpaceInformation()->checkMotion(from.get(), to.get());
            else
                std::tie(motion.valid, motion.fraction) = checkLast(first, from, to);
            ++(motion.valid ? accepted : refused);
            for (const auto &setup : setups)
                expectAgain(*setup, motion);
            motions.push_back(motion);
        }
        // With all that was learned since, with little of it, and with nothing
        const auto fresh = world.setup(CERTIFIED[seed % 3]);
        const auto exact = world.setup(Method::SHARED_PROJECTION);
        exact->getTeamChecker()->setAdaptive(false);
        exact->getTeamChecker()->setMaxCertificates(10);
        for (const Motion &motion : motions)
        {
            expectAgain(*setups[seed % setups.size()], motion);
            expectAgain(*exact, motion);
            fresh->getTeamChecker()->clear();
            expectAgain(*fresh, motion);
        }
        if (HasFailure())
            return;
    }
    EXPECT_GT(accepted, worlds * motionsPerWorld / 20);
    EXPECT_GT(refused, worlds * motionsPerWorld / 20);
}

TEST_P(OneVerdict, InEveryThread)
{
    Random random(GetParam());
    const World world(GetParam(), random);
    const auto setup = world.setup(Method::SHARED_PROJECTION), alone = world.setup(Method::SHARED_PROJECTION);
    std::vector<Motion> motions;
    for (unsigned int i = 0; i < 200; ++i)
    {
        const auto from = validState(random, *alone), to = randomStateNear(random, from, random.uniform(0.0, 0.3));
        motions.push_back({from, to, alone->getSpaceInformation()->checkMotion(from.get(), to.get()), -1.0});
    }
    std::atomic<unsigned int> different{0};
    std::vector<std::thread> threads;
    for (unsigned int thread = 0; thread < 4; ++thread)
        threads.emplace_back(
            [&, thread]
            {
                for (std::size_t i = 0; i < motions.size(); ++i)
                {
                    const Motion &motion = motions[(i * (2 * thread + 1)) % motions.size()];
                    const ob::State *a = motion.from.get(), *b = motion.to.get();
                    if (thread % 2 == 1)
                        std::swap(a, b);
                    if (setup->getSpaceInformation()->checkMotion(a, b) != motion.valid)
                        ++different;
                }
            });
    for (std::thread &thread : threads)
        thread.join();
    EXPECT_EQ(different, 0U);
}

namespace
{
    /** Whether no state of the path collides, at a thousand times the resolution of a discrete check, or with a small
        scale of tests at a hundred times */
    bool isFreeThroughout(const og::PathGeometric &path, const TeamValidityChecker &standard)
    {
        const auto &space = path.getSpaceInformation()->getStateSpace();
        ob::ScopedState<> at(space);
        for (std::size_t i = 1; i < path.getStateCount(); ++i)
        {
            const ob::State *from = path.getState(static_cast<unsigned int>(i - 1)),
                            *to = path.getState(static_cast<unsigned int>(i));
            const unsigned int samples =
                std::clamp(scaled(1000), 100U, 1000U) * std::max(1U, space->validSegmentCount(from, to));
            for (unsigned int k = 0; k <= samples; ++k)
            {
                space->interpolate(from, to, static_cast<double>(k) / samples, at.get());
                if (!standard.isValid(at.get()))
                    return false;
            }
        }
        return true;
    }
}

TEST_P(OneVerdict, OfPlansAndSimplifiedPlans)
{
    // By hand 1000 plans: OMPL_CERTIFICATES_TEST_SCALE=30
    const std::array<const char *, 3> planners{"RRTConnect", "KPIECE1", "RRTstar"};
    unsigned int solved = 0;
    for (unsigned int seed = 0; seed < scaled(9); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(1000 * GetParam() + seed);
        const World world(GetParam(), random);
        const auto setup = world.setup(CERTIFIED[seed % 3], 0.02);
        const TeamValidityChecker standard(setup->getSpaceInformation(), world.obstacles);
        setup->setPlanner(makePlanner(planners[seed / 3 % 3], setup->getSpaceInformation()));
        setup->setStartAndGoalStates(validState(random, *setup), validState(random, *setup),
                                     0.05 * world.team->getMaximumExtent());
        unsigned int evaluations = 0;
        setup->solve(ob::PlannerTerminationCondition([&evaluations] { return ++evaluations > 2000; }));
        if (!setup->haveExactSolutionPath())
            continue;
        ++solved;
        og::PathGeometric &path = setup->getSolutionPath();
        ASSERT_TRUE(path.check()) << setup->getPlanner()->getName();
        const double length = path.length();
        // OMPL's own smoothing may add a little length.
        setup->simplifySolution();
        EXPECT_LE(path.length(), 1.05 * length);
        ASSERT_TRUE(path.check()) << setup->getPlanner()->getName();
        ASSERT_TRUE(isFreeThroughout(path, standard));
    }
    EXPECT_GT(solved, 0U);
    RecordProperty("solved", static_cast<int>(solved));
}

namespace
{
    /** Obstacles that know of half of the stretches of a motion that they are free, be they short or long */
    class Forgetful : public ForwardingObstacles
    {
    public:
        using ForwardingObstacles::ForwardingObstacles;

        bool staysFree(const Body &body, const Pose &pose, double distance) const override
        {
            const double sum = 1e3 * (pose.translation().sum() + M_PI * distance);
            return sum - std::floor(sum) < 0.5 && obstacles_->staysFree(body, pose, distance);
        }
    };
}

/** Two plates slide along a wall, so near that no clearance of points proves it. Which stretches of the way are proved
    differs from plate to plate: a whole segment, a quarter of it, or a cell. */
TEST(OneVerdictAmongOwnObstacles, IsThatOfAllMethods)
{
    const auto wall =
        std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(100.0, 1.0), planarPose(0.0, -0.5)}}, 2);
    auto team = std::make_shared<TeamStateSpace>();
    for (const char *name : {"left", "right"})
        team->addRobot(RigidRobot::inR2(name, Body::box(1.0, 0.2), cubeBounds(2, 50.0)));
    team->setLongestValidSegmentFraction(0.05 / team->getMaximumExtent());
    std::vector<TeamSetupPtr> setups;
    for (const Method method : CERTIFIED)
    {
        setups.push_back(std::make_shared<TeamSetup>(team, std::make_shared<Forgetful>(wall), method,
                                                     CertificateMotionValidator::CONTINUOUS));
        setups.back()->getSpaceInformation()->setup();
        setups.back()->getTeamChecker()->setCertificatesAfter(0);
    }
    unsigned int accepted = 0, refused = 0;
    Random random(1);
    for (unsigned int i = 0; i < std::max(200U, scaled(2000)); ++i)
    {
        SCOPED_TRACE("motion " + std::to_string(i));
        const double left = random.uniform(-40.0, -10.0), right = random.uniform(10.0, 40.0),
                     way = random.uniform(0.01, 0.1);
        ob::ScopedState<> from(team), to(team);
        from = std::vector<double>{left, 0.16, right, 0.16};
        to = std::vector<double>{left + way, 0.16, right - way, 0.16};
        const auto isFree = [&](const TeamSetup &setup)
        { return setup.getSpaceInformation()->checkMotion(from.get(), to.get()); };
        const bool expected = isFree(*setups.front());
        ++(expected ? accepted : refused);
        for (const auto &setup : setups)
        {
            EXPECT_EQ(isFree(*setup), expected) << nameOf(setup->getTeamChecker()->getMethod());
            ob::ScopedState<> state(team);
            std::pair<ob::State *, double> last{state.get(), 1.0};
            EXPECT_EQ(setup->getSpaceInformation()->checkMotion(from.get(), to.get(), last), expected);
        }
    }
    EXPECT_GT(accepted, 20U);
    EXPECT_GT(refused, 20U);
}

INSTANTIATE_TEST_SUITE_P(Kind, OneVerdict, testing::Range(0U, TEAMS + 1));
