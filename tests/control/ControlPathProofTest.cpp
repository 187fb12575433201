#include "DynamicProblems.h"

#include "ompl_certificates/control/PathSteps.h"
#include "ompl_certificates/control/ProvePath.h"
#include "support/Message.h"
#include "support/Quiet.h"
#include "support/Random.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace oc = ompl::control;

namespace
{
    /** A disc of radius 0.1 that is pushed at up to 10 m/s, in steps of 0.1 s, about a wall of 2 mm along x = 0, as
        high as y = 1 */
    class ControlPathProof : public testing::Test
    {
    protected:
        static TeamControlSetupPtr
        setupFor(Method method = Method::SHARED_PROJECTION,
                 CertificateMotionValidator::Mode mode = CertificateMotionValidator::DISCRETE)
        {
            const auto disc =
                Integrator::firstOrder(RigidRobot::disc("disc", 0.1, within({3.0, 3.0})), within({10.0, 10.0}));
            auto setup =
                std::make_shared<TeamControlSetup>(teamOf({disc}), boxes({{{0.0, -1.0, 0.002, 4.0}}}), method, mode);
            setup->getSpaceInformation()->setup();
            return setup;
        }

        /** From a point on, some speeds for some time each */
        static oc::PathControl driven(const TeamControlSetup &setup, const std::vector<double> &from,
                                      const std::vector<std::array<double, 3>> &controls)
        {
            const auto si = setup.getSpaceInformation();
            oc::PathControl path(si);
            ob::ScopedState<> state(si);
            state = from;
            path.append(state.get());
            const TeamPropagator propagator(si);
            oc::Control *control = si->allocControl();
            for (const auto &[vx, vy, duration] : controls)
            {
                double *values = control->as<oc::RealVectorControlSpace::ControlType>()->values;
                values[0] = vx, values[1] = vy;
                propagator.propagate(path.getState(static_cast<unsigned int>(path.getControlCount())), control,
                                     duration, state.get());
                path.append(state.get(), control, duration);
            }
            si->freeControl(control);
            return path;
        }

    private:
        const Quiet quiet_;
    };
}

TEST_F(ControlPathProof, ProvesTheWayAboutAWall)
{
    const TeamControlSetupPtr setup = setupFor();
    const oc::PathControl path = driven(*setup, {-1.0, 0.0}, {{0.0, 5.0, 0.4}, {5.0, 0.0, 0.4}, {0.0, -5.0, 0.4}});
    const PathProof proof = provePath(path, setup->getTeamChecker());
    EXPECT_TRUE(proof.isProved());
    EXPECT_FALSE(proof.collision);
    EXPECT_TRUE(path.check());
}

TEST_F(ControlPathProof, FindsTheWallBetweenTheEndsOfAStep)
{
    for (const auto mode : {CertificateMotionValidator::DISCRETE, CertificateMotionValidator::CONTINUOUS})
        for (const Method method : {Method::FCL, Method::STANDARD, Method::SHARED_PROJECTION})
        {
            if (mode == CertificateMotionValidator::CONTINUOUS && !makesCertificates(method))
                continue;
            const TeamControlSetupPtr setup = setupFor(method, mode);
            // Steps of half a meter: from x = -0.25 to 0.25, with the ends clear of the wall.
            const oc::PathControl path = driven(*setup, {-1.25, 0.0}, {{5.0, 0.0, 0.3}, {5.0, 0.0, 0.2}});
            const PathProof proof = provePath(path, setup->getTeamChecker());
            EXPECT_EQ(proof.unproved, std::vector<std::size_t>{2});
            ASSERT_TRUE(proof.collision);
            EXPECT_LT(std::abs(proof.collision->reals()[0]), 0.11);
            EXPECT_FALSE(setup->getTeamChecker()->isValid(proof.collision->get()));
            EXPECT_EQ(path.check(), mode == CertificateMotionValidator::DISCRETE);
        }
}

/** Steps that are proved no longer end where they lead, not in states that are not numbers. */
TEST_F(ControlPathProof, HasTheSameStepsWhateverIsInTheirWay)
{
    const TeamControlSetupPtr setup = setupFor(Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS);
    const oc::PathControl path = driven(*setup, {-2.0, 0.0}, {{0.0, 5.0, 0.4}, {5.0, 0.0, 0.25}});
    oc::PathControl interpolated(path);
    interpolated.interpolate();
    const auto expectSteps = [&](oc::PathControl steps)
    {
        EXPECT_EQ(steps.getStateCount(), steps.getControlCount() + 1);
        ASSERT_EQ(steps.getStateCount(), interpolated.getStateCount());
        for (unsigned int i = 0; i < steps.getStateCount(); ++i)
            EXPECT_TRUE(setup->getStateSpace()->equalStates(steps.getStates()[i], interpolated.getStates()[i])) << i;
        EXPECT_NEAR(steps.length(), path.length(), 1e-12) << "nothing of a control is left out";
    };
    expectSteps(pathSteps(path));
    const ObstaclesPtr post = boxes({{{-2.0, 1.0, 0.5, 0.5}}});
    setup->getTeamChecker()->changeObstacles(ObstacleChange::replacing(post, post));
    oc::PathControl blocked(path);
    blocked.interpolate();
    EXPECT_TRUE(std::any_of(
        blocked.getStates().begin(), blocked.getStates().end(),
        [&](const ob::State *state)
        { return std::isnan(state->as<ob::CompoundState>()->as<ob::RealVectorStateSpace::StateType>(0)->values[0]); }))
        << "nothing is in the way";
    expectSteps(pathSteps(path));
}

/** Only it knows where its steps lead. */
TEST_F(ControlPathProof, HasTheStepsOfAPropagatorOfOnesOwn)
{
    class Slow : public TeamPropagator
    {
    public:
        using TeamPropagator::TeamPropagator;

        void propagate(const ob::State *state, const oc::Control *control, double duration,
                       ob::State *result) const override
        {
            TeamPropagator::propagate(state, control, 0.5 * duration, result);
        }
    };
    const TeamControlSetupPtr setup = setupFor();
    const auto &si = setup->getSpaceInformation();
    oc::PathControl path = driven(*setup, {-2.0, 0.0}, {{0.0, 5.0, 0.2}});
    setup->setStatePropagator(std::make_shared<Slow>(si));
    si->setup();
    const oc::PathControl steps = pathSteps(path);
    std::vector<double> reals;
    setup->getStateSpace()->copyToReals(reals, steps.getState(1));
    EXPECT_NEAR(reals[1], 0.25, 1e-12);
}

TEST_F(ControlPathProof, ProvesNoPathThatStartsOrEndsInAnObstacle)
{
    const TeamControlSetupPtr setup = setupFor();
    for (const double from : {0.0, -0.5})
    {
        const PathProof proof =
            provePath(driven(*setup, {from, 0.0}, {{from == 0.0 ? -5.0 : 5.0, 0.0, 0.1}}), setup->getTeamChecker());
        EXPECT_EQ(proof.unproved, std::vector<std::size_t>{0}) << from;
        EXPECT_TRUE(proof.collision) << from;
    }
}

/** After two steps the disc has not come to the wall; what is left of the control takes it through. */
TEST_F(ControlPathProof, LooksAtAllOfAControl)
{
    const TeamControlSetupPtr setup = setupFor();
    const oc::PathControl path = driven(*setup, {-2.2, 0.0}, {{10.0, 0.0, 0.24}});
    const PathProof proof = provePath(path, setup->getTeamChecker());
    EXPECT_EQ(proof.unproved, std::vector<std::size_t>{1});
    EXPECT_TRUE(proof.collision);

    setup->getSpaceInformation()->setPropagationStepSize(1.0);
    const PathProof whole = provePath(path, setup->getTeamChecker());
    EXPECT_EQ(whole.unproved, std::vector<std::size_t>{0});
    EXPECT_TRUE(whole.collision);
    setup->getSpaceInformation()->setPropagationStepSize(0.0);
    EXPECT_NE(messageOf([&] { provePath(path, setup->getTeamChecker()); }).find("step size"), std::string::npos);
    setup->getSpaceInformation()->setPropagationStepSize(1e-9);
    EXPECT_NE(messageOf([&] { provePath(path, setup->getTeamChecker()); }).find("million"), std::string::npos);
}

TEST_F(ControlPathProof, ProvesNoPathThatItsControlsDoNotLeadAlong)
{
    const TeamControlSetupPtr setup = setupFor();
    const oc::PathControl path = driven(*setup, {-2.0, 0.0}, {{0.0, 1.0, 0.5}, {0.0, 1.0, 0.2}});
    EXPECT_TRUE(provePath(path, setup->getTeamChecker()).isProved());
    path.getState(1)->as<ob::CompoundState>()->components[0]->as<ob::RealVectorStateSpace::StateType>()->values[0] =
        -1.9;
    const PathProof proof = provePath(path, setup->getTeamChecker());
    EXPECT_EQ(proof.unproved, (std::vector<std::size_t>{4, 6}));
    EXPECT_FALSE(proof.collision);
}

/** Neither bounds far apart nor a weight in the team's distance make a jump small. */
TEST_F(ControlPathProof, ProvesNoJumpWhateverBoundsAndWeightsAre)
{
    for (const auto &[half, weight] : {std::pair{3.0, 1.0}, {1e6, 1.0}, {3.0, 0.0}, {3.0, 1e-9}})
    {
        SCOPED_TRACE("bounds " + std::to_string(half) + ", weight " + std::to_string(weight));
        const auto disc = [half = half](const std::string &name) {
            return Integrator::firstOrder(RigidRobot::disc(name, 0.1, within({half, half})), within({10.0, 10.0}));
        };
        const auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(disc("rests"));
        team->addRobot(disc("jumps"), weight);
        TeamControlSetup setup(team, boxes({{{0.0, 0.0, 0.002, 6.0}}}));
        const auto si = setup.getSpaceInformation();
        si->setup();
        ob::ScopedState<> before(si), after(si);
        before = std::vector<double>{-2.0, -2.0, -0.2, 0.0};
        after = std::vector<double>{-2.0, -2.0, 0.2, 0.0};
        oc::Control *rest = si->allocControl();
        si->nullControl(rest);
        oc::PathControl jumps(si), rests(si);
        for (const auto &[path, end] : {std::pair{&jumps, &after}, {&rests, &before}})
        {
            path->append(before.get());
            path->append(end->get(), rest, 0.1);
        }
        EXPECT_FALSE(provePath(jumps, setup.getTeamChecker()).isProved());
        EXPECT_TRUE(provePath(rests, setup.getTeamChecker()).isProved());
        si->freeControl(rest);
    }
}

TEST_F(ControlPathProof, IsOfASingleStateWhetherThatIsValid)
{
    const TeamControlSetupPtr setup = setupFor();
    EXPECT_TRUE(provePath(driven(*setup, {-2.0, 0.0}, {}), setup->getTeamChecker()).isProved());
    const PathProof proof = provePath(driven(*setup, {0.05, 0.0}, {}), setup->getTeamChecker());
    EXPECT_EQ(proof.unproved, std::vector<std::size_t>{0});
    ASSERT_TRUE(proof.collision);
    EXPECT_EQ((*proof.collision)[0], 0.05);
}

TEST_F(ControlPathProof, EndsWhereItIsToldTo)
{
    const TeamControlSetupPtr setup = setupFor();
    const oc::PathControl path = driven(*setup, {-2.0, 0.0}, {{0.0, 1.0, 0.5}});
    int asked = 0;
    const PathProof proof =
        provePath(path, setup->getTeamChecker(), ob::PlannerTerminationCondition([&asked] { return ++asked > 2; }));
    EXPECT_EQ(proof.unproved, (std::vector<std::size_t>{2, 3, 4}));
    EXPECT_EQ(proof.unseen, 3U);
    EXPECT_FALSE(proof.collision);
}

TEST_F(ControlPathProof, NeedsACheckerOfTheTeam)
{
    const TeamControlSetupPtr setup = setupFor(), other = setupFor();
    const oc::PathControl path = driven(*setup, {-2.0, 0.0}, {{0.0, 1.0, 0.5}});
    EXPECT_NE(messageOf([&] { provePath(path, nullptr); }), "");
    const oc::PathControl empty(setup->getSpaceInformation());
    oc::PathControl single(setup->getSpaceInformation());
    single.append(path.getState(0));
    for (const oc::PathControl &one : {path, empty, single})
        EXPECT_NE(messageOf([&] { provePath(one, other->getTeamChecker()); }).find("not of the checker's"),
                  std::string::npos);
}

TEST_F(ControlPathProof, ProvesNoStepThatCollides)
{
    Random random(1);
    unsigned int proved = 0, unproved = 0, colliding = 0;
    for (unsigned int trial = 0; trial < std::max(20U, scaled(100)); ++trial)
    {
        const TeamControlSetupPtr setup = makeSetup(Method::SHARED_PROJECTION);
        const auto si = setup->getSpaceInformation();
        si->setup();
        oc::PathControl path(si);
        ob::ScopedState<> state(si);
        state.random();
        path.append(state.get());
        oc::Control *control = si->allocControl();
        const auto sampler = si->allocControlSampler();
        const TeamPropagator propagator(si);
        for (int i = 0; i < 4; ++i)
        {
            sampler->sample(control);
            const double duration = 0.1 * random.integer(1, 10);
            propagator.propagate(state.get(), control, duration, state.get());
            path.append(state.get(), control, duration);
        }
        si->freeControl(control);

        const PathProof proof = provePath(path, setup->getTeamChecker());
        colliding += proof.collision ? 1 : 0;
        path.interpolate();
        std::size_t next = 0;
        for (unsigned int step = 0; step < path.getControlCount(); ++step)
        {
            if (next < proof.unproved.size() && proof.unproved[next] == step)
            {
                ++next, ++unproved;
                continue;
            }
            ++proved;
            for (int i = 0; i <= 100; ++i)
            {
                propagator.propagate(path.getState(step), path.getControl(step),
                                     path.getControlDuration(step) * i / 100.0, state.get());
                ASSERT_TRUE(setup->getTeamChecker()->isValid(state.get())) << "trial " << trial << ", step " << step;
            }
        }
        EXPECT_EQ(next, proof.unproved.size());
    }
    std::cout << proved << " steps are proved, " << unproved << " are not; " << colliding << " drives collide\n";
    EXPECT_GT(proved, 0U);
    EXPECT_GT(colliding, 0U);
}

TEST_F(ControlPathProof, NeedsTheLastState)
{
    const TeamControlSetupPtr setup = setupFor();
    oc::PathControl path(driven(*setup, {-2.0, 0.0}, {{1.0, 0.0, 0.1}}));
    path.getSpaceInformation()->freeState(path.getStates().back());
    path.getStates().pop_back();
    EXPECT_EQ(messageOf([&] { provePath(path, setup->getTeamChecker()); }),
              "A path of 1 controls has 1 states, and no last one");
}
