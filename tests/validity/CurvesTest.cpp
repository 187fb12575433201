#include "support/ErrorsOnly.h"
#include "support/Teams.h"

#include "ompl_certificates/planning/TeamPathSimplifier.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/team/TeamPathLength.h"
#include "ompl_certificates/validity/SharedProjection.h"

#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    constexpr double RADIUS = 1.0;

    /** A body that drives along the curves of its space, as a user may write it */
    class CurveRobot : public Robot
    {
    public:
        explicit CurveRobot(const std::shared_ptr<ob::SE2StateSpace> &space, const Body &body = Body::disc(0.1),
                            double radius = RADIUS)
          : Robot("car", prepared(space), {body}), radius_(radius)
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            const auto *place = state->as<ob::SE2StateSpace::StateType>();
            poses[0] = planarPose(place->getX(), place->getY(), place->getYaw());
        }

        void computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const override
        {
            const double length = getStateSpace()->distance(from, to);
            bounds[0] = {length, length / radius_};
        }

    private:
        static ob::StateSpacePtr prepared(const std::shared_ptr<ob::SE2StateSpace> &space)
        {
            space->setBounds(cubeBounds(2, 10.0));
            return space;
        }

        double radius_;
    };

    class Curves : public ErrorsOnly<std::string>
    {
    protected:
        static RobotPtr robot()
        {
            const Body disc = Body::disc(0.1);
            if (GetParam() == "ReedsShepp")
                return RigidRobot::inReedsShepp("car", disc, RADIUS, cubeBounds(2, 10.0));
            const bool symmetric = GetParam() == "SymmetricDubins";
            return std::make_shared<CurveRobot>(std::make_shared<ob::DubinsStateSpace>(RADIUS, symmetric));
        }
    };
}

/** Between states within the bounds, curves may leave them. */
TEST_P(Curves, MayBeSimplifiedWhereTheyLeaveTheBounds)
{
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(robot());
    const TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>(), 2));
    const auto &si = setup.getSpaceInformation();
    si->setup();
    Random random(2);
    for (unsigned int i = 0; i < scaled(20); ++i)
    {
        ompl::geometric::PathGeometric path(si);
        for (int k = 0; k < 5; ++k)
        {
            ob::ScopedState<> state(team);
            state = std::vector<double>{9.9, random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)};
            path.append(state.get());
        }
        // The corners on the way are then what is moved.
        path.interpolate(20);
        TeamPathSimplifier(si, std::make_shared<TeamPathLength>(si))
            .simplify(path, 200, ob::plannerNonTerminatingCondition());
        EXPECT_TRUE(path.check());
    }
}

/** Of curves that are equally long, one is taken on the way there and another on the way back: each is proved as it is
    driven. */
TEST_P(Curves, AreProvedInTheDirectionInWhichTheyAreDriven)
{
    const auto car = robot();
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(car);
    Random random(1);
    ob::ScopedState<> from(team), to(team), middle(team);
    const auto choose = [&](ob::ScopedState<> &state)
    {
        state = std::vector<double>{std::floor(random.uniform(-4.0, 5.0)), std::floor(random.uniform(-4.0, 5.0)),
                                    0.5 * M_PI * std::floor(random.uniform(-2.0, 2.0))};
    };
    for (unsigned int i = 0; i < scaled(500); ++i)
    {
        SCOPED_TRACE("motion " + std::to_string(i));
        choose(from);
        choose(to);
        team->interpolate(from.get(), to.get(), 0.5, middle.get());
        Pose pose;
        car->computePoses(middle->as<ob::CompoundState>()->components[0], &pose);
        const auto there = std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::disc(0.2), pose}}, 2);
        const TeamSetup setup(team, there, Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS);
        setup.getSpaceInformation()->setup();
        ASSERT_FALSE(setup.getSpaceInformation()->checkMotion(from.get(), to.get()));
    }
}

/** The robots' own spaces, and those of OMPL's programs, whose robots are not told of the curves */
TEST_P(Curves, HaveTheVerdictsOfOmplsOwnMotionValidators)
{
    Random random(4);
    const auto own = robot();
    const auto plain = RigidRobot::inSE2("car", own->getBodies().front(), cubeBounds(2, 10.0));
    unsigned int free = 0, blocked = 0;
    for (unsigned int world = 0; world < scaled(20); ++world)
    {
        const auto obstacles = scatteredObstacles(random, 2, 3);
        for (const Method method : {Method::STANDARD, Method::FCL, Method::BASIC, Method::SHARED_PROJECTION})
            for (const RobotPtr &driver : {own, plain})
            {
                SCOPED_TRACE(nameOf(method) + " " + std::to_string(world));
                const auto si = std::make_shared<ob::SpaceInformation>(own->getStateSpace());
                const auto checker =
                    std::make_shared<TeamValidityChecker>(si, obstacles, std::vector<RobotPtr>{driver}, method);
                checker->setAdaptive(false);
                si->setStateValidityChecker(checker);
                si->setup();
                const CertificateMotionValidator validator(checker);
                const ob::MotionValidatorPtr expected = si->getMotionValidator();
                for (unsigned int i = 0; i < 20; ++i)
                {
                    // Not on the way to another one: OMPL 1.5 aborts at some states that are in line.
                    const auto from = randomState(random, own->getStateSpace());
                    const auto to = randomState(random, own->getStateSpace());
                    if (!si->isValid(from.get()))
                        continue;
                    std::pair<ob::State *, double> last{nullptr, 1.0}, lastExpected{nullptr, 1.0};
                    const bool valid = expected->checkMotion(from.get(), to.get());
                    ASSERT_EQ(validator.checkMotion(from.get(), to.get()), valid);
                    ASSERT_EQ(expected->checkMotion(from.get(), to.get(), lastExpected), valid);
                    ASSERT_EQ(validator.checkMotion(from.get(), to.get(), last), valid);
                    ASSERT_EQ(last.second, lastExpected.second);
                    ++(valid ? free : blocked);
                }
            }
    }
    EXPECT_GT(free, scaled(100));
    EXPECT_GT(blocked, scaled(100));
}

/** A team's motions are checked robot by robot, with one curve for each. */
TEST_P(Curves, OfTeamsHaveTheVerdictsOfSamples)
{
    Random random(5);
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(robot());
    team->addRobot(RigidRobot::disc("disc", 0.3, cubeBounds(2, 10.0)));
    team->addRobot(RigidRobot::inReedsShepp("truck", Body::box(0.6, 0.3), 2.0, cubeBounds(2, 10.0)));
    unsigned int free = 0, blocked = 0;
    for (unsigned int world = 0; world < scaled(20); ++world)
    {
        const auto obstacles = scatteredObstacles(random, 2, 3);
        for (const Method method : {Method::STANDARD, Method::PARTIAL, Method::SHARED_PROJECTION})
        {
            SCOPED_TRACE(nameOf(method) + " " + std::to_string(world));
            const TeamSetup setup(team, obstacles, method);
            setup.getTeamChecker()->setAdaptive(false);
            const auto &si = setup.getSpaceInformation();
            si->setup();
            const ob::DiscreteMotionValidator expected(si);
            for (unsigned int i = 0; i < 20; ++i)
            {
                const auto from = randomState(random, team), to = randomState(random, team);
                if (!si->isValid(from.get()))
                    continue;
                const bool valid = expected.checkMotion(from.get(), to.get());
                ASSERT_EQ(si->checkMotion(from.get(), to.get()), valid);
                ++(valid ? free : blocked);
            }
        }
    }
    EXPECT_GT(free, scaled(100));
    EXPECT_GT(blocked, scaled(100));
}

/** Back where it started, but for a little, a car that only drives ahead has gone a whole round. */
TEST_P(Curves, OfTeamsHaveSamplesAllAlong)
{
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(robot());
    const Body wall = Body::box(20.0, 0.2);
    const std::vector<PlacedBody> walls{{wall, planarPose(0.0, 1.0)}, {wall, planarPose(0.0, -1.0)}};
    const TeamSetup setup(team, std::make_shared<FclObstacles>(walls, 2));
    setup.getSpaceInformation()->setup();
    const double longest = 0.01 * team->as<ob::SE2StateSpace>(0)->getSubspace(0)->getMaximumExtent();
    ob::ScopedState<> from(team), to(team);
    from = std::vector<double>{0.0, 0.0, 0.0};
    for (const double y : {0.0, 0.1, 0.5, 4.0})
        for (const double yaw : {-3.0, 0.0, 1.0})
        {
            to = std::vector<double>{0.2, y, yaw};
            EXPECT_GE(team->validSegmentCount(from.get(), to.get()), team->distance(from.get(), to.get()) / longest);
        }
    to = std::vector<double>{std::nan(""), 0.0, 1.0};
    EXPECT_LT(team->validSegmentCount(from.get(), to.get()), 1000U);
    to = std::vector<double>{-0.1, 0.0, 0.0};
    const bool loops = GetParam() == "Dubins";
    EXPECT_EQ(team->distance(from.get(), to.get()) > 6.0 * RADIUS, loops);
    EXPECT_EQ(setup.getSpaceInformation()->checkMotion(from.get(), to.get()), !loops);
}

INSTANTIATE_TEST_SUITE_P(Of, Curves, ::testing::Values("ReedsShepp", "SymmetricDubins", "Dubins"));

/** For very short steps OMPL's curves of Dubins go straight ahead, wherever they should end. */
TEST(CurvesOfDubins, AreFreeOnlyIfTheirEndIs)
{
    constexpr double radius = 1e4, step = 0.9e-6 * radius;
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(
        std::make_shared<CurveRobot>(std::make_shared<ob::DubinsStateSpace>(radius), Body::box(1.0, 1.0), radius));
    const std::vector<PlacedBody> wall{{Body::box(100.0, 1.0), planarPose(5.0, 6.0 + 0.5 * step)}};
    TeamSetup setup(team, std::make_shared<FclObstacles>(wall, 2), Method::SHARED_PROJECTION,
                    CertificateMotionValidator::CONTINUOUS);
    const auto &si = setup.getSpaceInformation();
    si->setup();
    ob::ScopedState<> from(team), to(team), last(team);
    from = std::vector<double>{5.0, 5.0, 0.0};
    to = std::vector<double>{5.0, 5.0 + step, 0.0};
    ASSERT_TRUE(si->isValid(from.get()));
    ASSERT_FALSE(si->isValid(to.get()));
    EXPECT_FALSE(si->checkMotion(from.get(), to.get()));
    std::pair<ob::State *, double> lastValid(last.get(), 1.0);
    EXPECT_FALSE(si->checkMotion(from.get(), to.get(), lastValid));
    EXPECT_LT(lastValid.second, 1.0);
    EXPECT_TRUE(si->isValid(last.get()));
}

TEST(CurvesOfAnotherRadius, AreSampled)
{
    const auto robot = RigidRobot::inReedsShepp("car", Body::disc(0.1), RADIUS, cubeBounds(2, 10.0));
    auto space = std::make_shared<ob::ReedsSheppStateSpace>(4.0 * RADIUS);
    space->setBounds(cubeBounds(2, 10.0));
    const auto none = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2);
    const auto checkerFor = [&](const ob::StateSpacePtr &driven)
    { return std::make_shared<SharedProjection>(std::make_shared<ob::SpaceInformation>(driven), none, robot); };
    const auto own = checkerFor(robot->getStateSpace()), other = checkerFor(space);
    EXPECT_TRUE(own->getTeam().interpolatesRobots());
    EXPECT_FALSE(own->getTeam().isSymmetric());
    EXPECT_FALSE(other->getTeam().interpolatesRobots());
    EXPECT_NO_THROW(CertificateMotionValidator(own, CertificateMotionValidator::CONTINUOUS));
    EXPECT_THROW(CertificateMotionValidator(other, CertificateMotionValidator::CONTINUOUS), ompl::Exception);
}
