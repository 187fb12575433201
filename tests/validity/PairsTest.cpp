#include "certificates/CertifiedEnvironment.h"
#include "validity/RobotPairs.h"

#include "support/Checkers.h"
#include "support/ErrorsOnly.h"
#include "support/Fcl.h"
#include "support/TeamOf.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    bool touchEachOther(const TeamStateSpace &team, const ob::State *state)
    {
        std::vector<std::vector<Pose>> poses;
        for (unsigned int i = 0; i < team.getRobotCount(); ++i)
        {
            poses.emplace_back(team.getRobot(i).getBodies().size());
            team.getRobot(i).computePoses(state->as<ob::CompoundState>()->components[i], poses.back().data());
        }
        for (unsigned int i = 0; i < team.getRobotCount(); ++i)
            for (unsigned int j = i + 1; j < team.getRobotCount(); ++j)
                for (std::size_t a = 0; a < poses[i].size(); ++a)
                    for (std::size_t b = 0; b < poses[j].size(); ++b)
                        if (touchForFcl(team.getRobot(i).getBodies()[a], poses[i][a], team.getRobot(j).getBodies()[b],
                                        poses[j][b]))
                            return true;
        return false;
    }

    /** Robots of random bodies, some of them equal, in so little room that they often touch */
    TeamStateSpacePtr crowdedTeam(Random &random, unsigned int dimension)
    {
        const auto bounds = cubeBounds(dimension, 0.8);
        auto team = std::make_shared<TeamStateSpace>();
        Body last = randomBody(random, dimension, 0.5);
        for (unsigned int i = 0, count = 2 + random.below(3); i < count; ++i)
        {
            if (random.chance(0.6))
                last = randomBody(random, dimension, 0.5);
            const std::string name = "robot" + std::to_string(i);
            if (dimension == 3)
                team->addRobot(RigidRobot::inSE3(name, last, bounds));
            else if (random.chance(0.3))
                team->addRobot(std::make_shared<CarWithTrailer>(name, last, Body::box(0.3, 0.2), 0.4, bounds));
            else
                team->addRobot(RigidRobot::inSE2(name, last, bounds));
        }
        return team;
    }
}

class Pairs : public ErrorsOnly<unsigned int>
{
};

TEST_P(Pairs, TouchIfFclSaysSoOfTheirBodies)
{
    unsigned int touching = 0, apart = 0;
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto team = crowdedTeam(random, GetParam());
        const auto none = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, GetParam());
        const Checkers checkers(team, none);
        for (int i = 0; i < 40; ++i)
        {
            const auto state = randomState(random, team);
            const bool touch = touchEachOther(*team, state.get());
            ++(touch ? touching : apart);
            for (const auto &setup : checkers.setups)
            {
                ASSERT_EQ(setup->getTeamChecker()->isValid(state.get()), !touch)
                    << nameOf(setup->getTeamChecker()->getMethod());
                const std::string words = setup->getTeamChecker()->describeCollision(state.get());
                ASSERT_EQ(words.empty(), !touch) << words;
            }
        }
    }
    EXPECT_GT(touching, scaled(400));
    EXPECT_GT(apart, scaled(1000));
}

INSTANTIATE_TEST_SUITE_P(Dimension, Pairs, testing::Values(2U, 3U));

TEST(RobotPairs, AreAllPairsOfTheTeam)
{
    const Team team(teamOfDiscs());
    const RobotPairs pairs(team, Method::STANDARD, nullptr);
    ASSERT_EQ(pairs.getPairCount(), 3U);
    for (unsigned int i = 0; i < 3; ++i)
    {
        EXPECT_LT(pairs.getFirst(i), pairs.getSecond(i));
        EXPECT_EQ(pairs.find(pairs.getFirst(i), pairs.getSecond(i)), i);
        EXPECT_EQ(pairs.find(pairs.getSecond(i), pairs.getFirst(i)), i);
    }
    EXPECT_THROW(pairs.find(1, 1), ompl::Exception);
    EXPECT_THROW(pairs.find(0, 3), ompl::Exception);
}

TEST(RobotPairs, OfDiscsTouchAtTheSumOfTheirRadii)
{
    const auto team = teamOfDiscs();  // 0.1, 0.2 and 0.3
    const Checkers checkers(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2));
    ob::ScopedState<> state(team);
    for (const auto &setup : checkers.setups)
    {
        state = std::vector<double>{0.0, 0.0, 0.30001, 0.0, -4.0, 0.0};
        EXPECT_TRUE(setup->getTeamChecker()->isValid(state.get()));
        EXPECT_NEAR(setup->getTeamChecker()->clearance(state.get()), 0.00001, 1e-9);
        state = std::vector<double>{0.0, 0.0, 0.29999, 0.0, -4.0, 0.0};
        EXPECT_FALSE(setup->getTeamChecker()->isValid(state.get()));
        EXPECT_EQ(setup->getTeamChecker()->describeCollision(state.get()),
                  "robots 'small' and 'middle' touch each other");
    }
}

/** A ball beside its frame moves where this only turns, and passes through a post. */
TEST(RobotPairs, OfBodiesBesideTheirFramesMoveWhenTheseTurn)
{
    const auto swing =
        RigidRobot::inSE2("swing", Body::join({{Body::disc(0.2), planarPose(2.0, 0.0)}}), cubeBounds(2, HALF));
    const auto post = RigidRobot::disc("post", 0.2, cubeBounds(2, HALF));
    const auto none = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2);
    const std::vector<double> place{2.0 * std::cos(1.5), 2.0 * std::sin(1.5)};
    for (const bool swingsFirst : {true, false})
    {
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(swingsFirst ? swing : post);
        team->addRobot(swingsFirst ? post : swing);
        ob::ScopedState<> from(team), to(team);
        from = swingsFirst ? std::vector<double>{0.0, 0.0, 0.0, place[0], place[1]}
                           : std::vector<double>{place[0], place[1], 0.0, 0.0, 0.0};
        to = from.reals();
        to[swingsFirst ? 2 : 4] = 3.0;
        for (const auto mode : {CertificateMotionValidator::DISCRETE, CertificateMotionValidator::CONTINUOUS})
        {
            const TeamSetup setup(team, none, Method::SHARED_PROJECTION, mode);
            const auto &si = setup.getSpaceInformation();
            si->setup();
            EXPECT_TRUE(si->isValid(from.get()) && si->isValid(to.get()));
            EXPECT_FALSE(si->checkMotion(from.get(), to.get())) << swingsFirst;
        }
    }
}

TEST(RobotPairs, ThatStayApartDoSoForAsLongAsTheySay)
{
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        const auto space = crowdedTeam(random, dimension);
        const Team team(space);
        const RobotPairs pairs(team, Method::SHARED_PROJECTION, nullptr);
        CheckContext context(team, pairs.getBodyPairCount());
        ++context.motion;
        const auto from = randomState(random, space), to = randomState(random, space);
        ob::ScopedState<> at(space);
        const auto moveTo = [&](double time)
        {
            space->interpolate(from.get(), to.get(), time, at.get());
            for (unsigned int i = 0; i < team.getRobotCount(); ++i)
            {
                const std::size_t first = team.getFirstBody(i);
                team.getRobot(i).computePoses(team.getRobotState(at.get(), i), context.poses.data() + first);
                team.getRobot(i).computeMotionBounds(team.getRobotState(from.get(), i), team.getRobotState(to.get(), i),
                                                     context.motionBounds.data() + first);
            }
        };
        for (unsigned int pair = 0; pair < pairs.getPairCount(); ++pair)
        {
            const auto expectFree = [&](double first, double last)
            {
                for (int i = 0; first < last && i < 30; ++i)
                {
                    moveTo(random.uniform(std::max(first, 0.0), std::min(last, 1.0)));
                    ASSERT_FALSE(pairs.findCollision(pair, context));
                }
            };
            moveTo(0.0);
            expectFree(0.0, pairs.provenInterval(pair, context));
            // What is known of earlier times takes part in the later ones.
            for (int i = 0; i < 4; ++i)
            {
                const double time = random.uniform(0.0, 1.0);
                moveTo(time);
                const SubjectVerdict verdict = pairs.settle(pair, context, {true, 0.0, i % 2 == 0 ? 0.0 : 10.0, time});
                ASSERT_EQ(verdict.free, !pairs.findCollision(pair, context));
                ASSERT_TRUE(!verdict.free || pairs.distance(pair, context) > -1.0);
                if (verdict.free)
                    expectFree(time - verdict.before, time + verdict.after);
            }
        }
    }
}

/** Whatever is asked at another time of that interval proves the same. */
TEST(RobotPairs, ThatAreDiscsMeetNoSoonerThanTheirGapLessTheMarginSays)
{
    const auto space = teamOf(
        {RigidRobot::disc("left", 1.0, cubeBounds(2, HALF)), RigidRobot::disc("right", 1.0, cubeBounds(2, HALF))});
    const Team team(space);
    const RobotPairs pairs(team, Method::SHARED_PROJECTION, nullptr);
    CheckContext context(team, pairs.getBodyPairCount());
    const double gap = 0.5, speed = 4.0;
    context.poses = {planarPose(-1.0 - 0.5 * gap, 0.0), planarPose(1.0 + 0.5 * gap, 0.0)};
    context.motionBounds = {{0.5 * speed, 0.0}, {0.5 * speed, 0.0}};
    const SubjectVerdict verdict = pairs.settle(0, context, {true});
    const double margin = 2.0 * exactCheckTolerance(2.0) * (1.0 + CertifiedEnvironment::PROOF_CUSHION);
    EXPECT_TRUE(verdict.free);
    EXPECT_NEAR(verdict.after * speed, gap - margin, 1e-10);
    EXPECT_NEAR(pairs.provenInterval(0, context) * speed, gap - margin, 1e-10);
}
