#include "support/Checkers.h"
#include "support/ErrorsOnly.h"
#include "support/TeamOf.h"

#include "validity/ContinuousMotionCheck.h"

#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    TeamSetupPtr continuousSetup(const TeamStateSpacePtr &team, const ObstaclesPtr &obstacles, Method method,
                                 double resolution)
    {
        auto setup = std::make_shared<TeamSetup>(team, obstacles, method, CertificateMotionValidator::CONTINUOUS);
        setup->getSpaceInformation()->setStateValidityCheckingResolution(resolution);
        setup->getSpaceInformation()->setup();
        return setup;
    }

    /** The time of the first of many samples up to \e end that collides, or a negative number */
    double firstCollision(const TeamValidityChecker &checker, const ob::ScopedState<> &from,
                          const ob::ScopedState<> &to, double end, unsigned int samples)
    {
        ob::ScopedState<> at(from.getSpace());
        for (unsigned int i = 0; i <= samples; ++i)
        {
            const double t = end * i / samples;
            from.getSpace()->interpolate(from.get(), to.get(), t, at.get());
            if (!checker.isValid(at.get()))
                return t;
        }
        return -1.0;
    }
}

class ContinuousMotions : public ErrorsOnly<unsigned int>
{
};

TEST_P(ContinuousMotions, ThatAreAcceptedNeverCollide)
{
    // Fewer than eight worlds may hold hardly any invalid motion.
    const unsigned int seeds = std::max(8U, scaled(GetParam() < FIRST_OF_MESHES ? 24 : 8));
    unsigned int accepted = 0, refused = 0;
    for (unsigned int seed = 0; seed < seeds; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto team = anyTeam(GetParam());
        const auto obstacles = anyObstacles(random, GetParam(), 3 + random.below(10));
        const double resolution = random.logUniform(0.005, 0.5);
        const auto setup = continuousSetup(team, obstacles, CERTIFIED[seed % 3], resolution);
        const TeamValidityChecker standard(setup->getSpaceInformation(), obstacles);
        const auto &validator = *setup->getSpaceInformation()->getMotionValidator();
        for (int i = 0; i < 40; ++i)
        {
            const auto from = randomState(random, team);
            if (!standard.isValid(from.get()))
                continue;
            const auto to = randomStateNear(random, from, random.logUniform(1e-4, 1.0));
            // A thousand times finer than a discrete check
            const unsigned int samples =
                std::min(scaled(20000), scaled(1000) * std::max(1U, team->validSegmentCount(from.get(), to.get())));
            ob::ScopedState<> last(team);
            std::pair<ob::State *, double> lastValid{last.get(), -7.0};
            const bool valid = validator.checkMotion(from.get(), to.get());
            ++(valid ? accepted : refused);
            if (valid)
            {
                ASSERT_LT(firstCollision(standard, from, to, 1.0, samples), 0.0);
            }
            const bool again = validator.checkMotion(from.get(), to.get(), lastValid);
            if (again)
            {
                ASSERT_EQ(lastValid.second, -7.0);
                ASSERT_TRUE(valid);
                continue;
            }
            ASSERT_GE(lastValid.second, 0.0);
            ASSERT_LE(lastValid.second, 1.0);
            ob::ScopedState<> expected(team);
            team->interpolate(from.get(), to.get(), lastValid.second, expected.get());
            ASSERT_EQ(realsOf(*team, last.get()), realsOf(*team, expected.get()));
            ASSERT_TRUE(standard.isValid(last.get()));
            ASSERT_LT(firstCollision(standard, from, to, lastValid.second, samples), 0.0);
        }
    }
    EXPECT_GT(accepted, seeds * 4);
    EXPECT_GT(refused, seeds * 2);
}

TEST_P(ContinuousMotions, ThatCollideAtAnEndAreRefused)
{
    Random random(3);
    const auto team = anyTeam(GetParam());
    const auto obstacles = anyObstacles(random, GetParam(), 12);
    for (const Method method : CERTIFIED)
    {
        const auto setup = continuousSetup(team, obstacles, method, 0.01);
        const TeamValidityChecker standard(setup->getSpaceInformation(), obstacles);
        for (int i = 0; i < 100; ++i)
        {
            const auto from = randomState(random, team), to = randomState(random, team);
            if (standard.isValid(from.get()) && standard.isValid(to.get()))
                continue;
            EXPECT_FALSE(setup->getSpaceInformation()->checkMotion(from.get(), to.get()));
            std::pair<ob::State *, double> lastValid{nullptr, -7.0};
            EXPECT_FALSE(setup->getSpaceInformation()->checkMotion(from.get(), to.get(), lastValid));
            EXPECT_GE(lastValid.second, 0.0);
            EXPECT_LE(lastValid.second, 1.0);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kind, ContinuousMotions, testing::Range(0U, TEAMS));

TEST(ContinuousMotion, StopsAtAWallThatADiscreteCheckStepsOver)
{
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::disc("disc", 0.01, cubeBounds(2, HALF)));
    // A wall thinner than a step, between two samples
    const auto wall =
        std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(0.001, 20.0), planarPose(0.13, 0.0)}}, 2);
    ob::ScopedState<> from(team), to(team);
    from = std::vector<double>{-1.0, 0.0};
    to = std::vector<double>{1.0, 0.0};
    const double resolution = 0.02;
    const Checkers checkers(team, wall, resolution);
    for (const auto &setup : checkers.setups)
        EXPECT_TRUE(setup->getSpaceInformation()->checkMotion(from.get(), to.get())) << "discrete";
    for (const Method method : CERTIFIED)
    {
        const auto setup = continuousSetup(team, wall, method, resolution);
        EXPECT_FALSE(setup->getSpaceInformation()->checkMotion(from.get(), to.get()));
        std::pair<ob::State *, double> lastValid{nullptr, 0.0};
        EXPECT_FALSE(setup->getSpaceInformation()->checkMotion(from.get(), to.get(), lastValid));
        EXPECT_LT(-1.0 + 2.0 * lastValid.second, 0.13 - 0.0005 - 0.01);
        EXPECT_GT(-1.0 + 2.0 * lastValid.second, 0.10);
    }
}

TEST(ContinuousMotion, KeepsTwoRobotsFromSwappingPlacesBetweenSamples)
{
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::disc("a", 0.01, cubeBounds(2, HALF)));
    team->addRobot(RigidRobot::inSE2("b", Body::box(0.02, 0.02), cubeBounds(2, HALF)));
    const auto none = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2);
    ob::ScopedState<> from(team), to(team);
    from = std::vector<double>{-1.0, 0.0, 1.03, 0.0, 0.0};
    to = std::vector<double>{1.0, 0.0, -0.97, 0.0, 0.0};
    const Checkers checkers(team, none, 0.02);
    for (const auto &setup : checkers.setups)
        EXPECT_TRUE(setup->getSpaceInformation()->checkMotion(from.get(), to.get())) << "discrete";
    for (const Method method : CERTIFIED)
    {
        const auto setup = continuousSetup(team, none, method, 0.02);
        EXPECT_FALSE(setup->getSpaceInformation()->checkMotion(from.get(), to.get()));
    }
}

TEST(ContinuousMotion, AcceptsWhatIsClearlyFree)
{
    for (unsigned int kind = 0; kind < TEAMS; ++kind)
    {
        const auto team = anyTeam(kind);
        const auto none = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, team->getWorkspaceDimension());
        Random random(kind);
        for (const Method method : CERTIFIED)
        {
            const auto setup = continuousSetup(team, none, method, 0.01);
            unsigned int accepted = 0, free = 0;
            const TeamValidityChecker standard(setup->getSpaceInformation(), none);
            for (int i = 0; i < 100; ++i)
            {
                const auto from = randomState(random, team), to = randomStateNear(random, from, 0.2);
                if (firstCollision(standard, from, to, 1.0, 500) >= 0.0)
                    continue;
                ++free;
                accepted += setup->getSpaceInformation()->checkMotion(from.get(), to.get()) ? 1 : 0;
            }
            EXPECT_GT(accepted, free * 8 / 10) << nameOf(method) << ", team " << kind;
        }
    }
}

TEST(ContinuousMotion, AcceptsFlatBodiesNearAFloor)
{
    const auto floor = std::make_shared<FclObstacles>(
        std::vector<PlacedBody>{{Body::box(6.0, 6.0, 0.1), poseAt({0.0, 0.0, -0.05})}}, 3);
    for (const Body &body :
         {Body::box(1.0, 1.0, 0.05), Body::cylinder(0.5, 0.05), meshBody(3, boxMesh({1.0, 1.0, 0.05}))})
    {
        const auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(RigidRobot::inR3("plate", body, cubeBounds(3, 3.0)));
        team->addRobot(RigidRobot::inR3("other", body, cubeBounds(3, 3.0)));
        const auto setup = continuousSetup(team, floor, Method::SHARED_PROJECTION, 0.01);
        const auto &validator = *setup->getSpaceInformation()->getMotionValidator();
        const auto slides = [&](double gap, double apart)
        {
            ob::ScopedState<> from(team), to(team);
            from = std::vector<double>{-2.0, -2.0, 0.025 + gap, -2.0, -1.0 + apart, 0.025 + gap};
            to = std::vector<double>{2.0, -1.5, 0.025 + gap, 2.0, -0.5 + apart, 0.025 + gap};
            return validator.checkMotion(from.get(), to.get());
        };
        // The bounding sphere of a plate reaches half a unit below it. A small part of a segment is 3 mm.
        EXPECT_TRUE(slides(0.02, 0.02));
        EXPECT_FALSE(slides(-0.001, 0.02));
        EXPECT_FALSE(slides(0.02, -0.05));
    }
}

namespace
{
    /** Two bars of length 2000 one above the other, and a post 0.05 beside a tip of the first. A turn of 1e-5 moves the
        tips by 0.01. */
    class LongBars
    {
    public:
        explicit LongBars(Method method) : setup_(continuousSetup(teamOfBars(), post(), method, 0.01))
        {
        }

        /** Where the bars move from z to -z. The first one is turned at one of the ends, the other at the second. */
        bool move(double z, double firstTurn, double secondTurn, double otherTurn, double apart) const
        {
            const auto from = stateAt(z, firstTurn, 0.0, apart), to = stateAt(-z, secondTurn, otherTurn, apart);
            const auto &si = *setup_->getSpaceInformation();
            std::pair<ob::State *, double> until{nullptr, 1.0};
            const bool isFree = si.checkMotion(from.get(), to.get());
            EXPECT_EQ(si.checkMotion(to.get(), from.get()), isFree);
            EXPECT_EQ(si.getMotionValidator()->checkMotion(from.get(), to.get(), until), isFree);
            if (isFree)
            {
                const TeamValidityChecker standard(setup_->getSpaceInformation(), post());
                EXPECT_LT(firstCollision(standard, from, to, 1.0, 500), 0.0);
                EXPECT_LT(firstCollision(standard, to, from, 1.0, 500), 0.0);
                EXPECT_TRUE(standard.isValid(from.get()) && standard.isValid(to.get()));
            }
            return isFree;
        }

    private:
        static TeamStateSpacePtr teamOfBars()
        {
            const auto team = std::make_shared<TeamStateSpace>();
            for (const char *name : {"bar", "other"})
                team->addRobot(RigidRobot::inSE3(name, Body::box(2000.0, 0.1, 0.1), cubeBounds(3, 3.0)));
            return team;
        }

        static ObstaclesPtr post()
        {
            return std::make_shared<FclObstacles>(
                std::vector<PlacedBody>{{Body::box(0.1, 0.1, 0.1), poseAt({999.0, 0.15, 0.0})}}, 3);
        }

        ob::ScopedState<> stateAt(double z, double turn, double otherTurn, double apart) const
        {
            ob::ScopedState<> state(setup_->getStateSpace());
            state = std::vector<double>{
                0.0, 0.0,          z, 0.0, 0.0, std::sin(0.5 * turn),      std::cos(0.5 * turn),
                0.0, -0.1 - apart, z, 0.0, 0.0, std::sin(0.5 * otherTurn), std::cos(0.5 * otherTurn)};
            return state;
        }

        TeamSetupPtr setup_;
    };
}

/** OMPL turns by so little only at the very end, and then at once; on the way back it turns at the other end. */
TEST(ContinuousMotion, MayTurnByNextToNothing)
{
    for (const Method method : CERTIFIED)
    {
        const LongBars bars(method);
        // Time runs from the state that sorts first, so each of both must be the one that is turned.
        for (const double z : {0.5, -0.5})
        {
            for (const double turn : {1e-11, 1e-7, 1e-5, -1e-5})
            {
                EXPECT_TRUE(bars.move(z, 0.0, turn, turn, 0.1)) << turn;
                EXPECT_TRUE(bars.move(z, turn, 0.0, turn, 0.1)) << turn;
            }
            // Turned, the bar passes the post midway.
            EXPECT_FALSE(bars.move(z, 8e-5, 0.0, 0.0, 1.0));
            EXPECT_FALSE(bars.move(z, 0.0, 8e-5, 0.0, 1.0));
            // The other one touches the first with a tip, but where it is turned.
            EXPECT_TRUE(bars.move(z, 0.0, 0.0, 0.0, 0.05));
            EXPECT_FALSE(bars.move(z, 0.0, 0.0, 8e-5, 0.05));
            bars.move(z, -8e-5, -8e-5, -8e-5, 0.05);
        }
    }
}

TEST(ContinuousMotion, IsNotForTheStandardMethod)
{
    const auto none = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2);
    EXPECT_THROW(TeamSetup(teamOfDiscs(), none, Method::STANDARD, CertificateMotionValidator::CONTINUOUS),
                 ompl::Exception);
}

TEST(ContinuousMotion, EndsAtTheFinestResolutions)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    const auto team = teamOfDiscs();
    const auto none = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2);
    for (const double resolution : {1e-8, 3e-9, 1e-10})
    {
        const auto setup = continuousSetup(team, none, Method::SHARED_PROJECTION, resolution);
        ob::ScopedState<> from(team), to(team);
        from = std::vector<double>{-3.0, -3.0, 0.0, 0.0, 3.0, 3.0};
        to = std::vector<double>{-3.0, 3.0, 0.0, 0.0, 3.0, 3.0};
        const auto &validator = *setup->getSpaceInformation()->getMotionValidator();
        std::pair<ob::State *, double> last{nullptr, 1.0};
        EXPECT_TRUE(validator.checkMotion(from.get(), to.get()));
        EXPECT_TRUE(validator.checkMotion(from.get(), to.get(), last));
    }
}

TEST(ContinuousMotion, IsNotHinderedByDiscsThatStandNearlyTouching)
{
    const auto bounds = cubeBounds(2, 5.0);
    auto team = std::make_shared<TeamStateSpace>();
    for (const char *name : {"first", "second", "mover"})
        team->addRobot(RigidRobot::disc(name, 0.15, bounds));
    const auto none = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2);
    const auto setup = continuousSetup(team, none, Method::SHARED_PROJECTION, 0.01);
    ob::ScopedState<> from(team), to(team);
    for (const double distance : {0.3 + 1e-7, 0.3 - 1e-7})
    {
        from = std::vector<double>{0.0, 0.0, distance, 0.0, -4.0, 2.0};
        to = std::vector<double>{0.0, 0.0, distance, 0.0, 4.0, 2.0};
        EXPECT_EQ(setup->getSpaceInformation()->checkMotion(from.get(), to.get()), distance > 0.3);
    }
}

namespace
{
    /** Proves a robot free for one interval, and notes at which times it is asked */
    class ProvesAnInterval : public CheckMethod
    {
    public:
        ProvesAnInterval(double interval, std::vector<double> &times) : interval_(interval), times_(times)
        {
        }

        SubjectVerdict settleRobot(unsigned int /*robot*/, CheckContext & /*context*/,
                                   const MotionSample &sample) const override
        {
            times_.push_back(sample.time);
            return {true, interval_, interval_};
        }

        void clear() override
        {
        }

        void setObstacles(const ObstaclesPtr & /*obstacles*/) override
        {
        }

    private:
        double interval_;
        std::vector<double> &times_;
    };
}

/** Valid intervals are open, and rounded. */
TEST(ContinuousMotion, IsCheckedAgainInACellThatEndsWithAValidInterval)
{
    const auto space = teamOf({RigidRobot::disc("disc", 0.1, cubeBounds(2, HALF))});
    space->setLongestValidSegmentFraction(0.01);
    space->setup();
    ob::ScopedState<> from(space), to(space);
    from = std::vector<double>{0.0, 0.0};
    to = std::vector<double>{1.0, 0.0};
    ASSERT_EQ(space->validSegmentCount(from.get(), to.get()), 8U);
    std::vector<double> times, middles;
    // From the middle of a segment, one and a half of them end with the last cell of the next.
    const TeamCheck check(Team(space), std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2),
                          std::make_unique<ProvesAnInterval>(1.5 / 8.0, times));
    CheckContext context(check.getTeam(), 0);
    double freeUntil;
    EXPECT_TRUE(ContinuousMotionCheck(check, context, from.get(), to.get()).isFree(freeUntil));
    for (int segment = 0; segment < 8; ++segment)
        middles.push_back((segment + 0.5) / 8.0);
    EXPECT_EQ(times, middles);
}
