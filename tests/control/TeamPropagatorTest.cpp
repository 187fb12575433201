#include "DynamicProblems.h"

#include "support/IterationLimit.h"
#include "support/Message.h"
#include "support/Quiet.h"
#include "support/Random.h"
#include "support/Warnings.h"

#include "ompl_certificates/control/LimitedValidityChecker.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/control/planners/est/EST.h>
#include <ompl/control/planners/rrt/RRT.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace oc = ompl::control;

TEST(TeamPropagatorTest, HandsHintsOn)
{
    const auto setup = makeSetup(Method::SHARED_PROJECTION);
    const auto &si = setup->getSpaceInformation();
    setup->setup();
    ob::ScopedState<TeamStateSpace> from(setup->getStateSpace()), to(setup->getStateSpace());
    si->copyState(from.get(), setup->getProblemDefinition()->getStartState(0));
    oc::Control *control = si->allocControl();
    auto *values = control->as<oc::RealVectorControlSpace::ControlType>()->values;
    std::fill_n(values, 6, 0.1);
    for (std::size_t body = 0; body < 4; ++body)
        from.get()->setReference(body, static_cast<TeamStateSpace::Reference>(7 + body));
    setup->getStatePropagator()->propagate(from.get(), control, 0.1, to.get());
    for (std::size_t body = 0; body < 4; ++body)
        EXPECT_EQ(to.get()->getReference(body), 7 + body);

    // One certificate of each body serves several steps: few are made for many.
    Statistics &statistics = setup->getStatistics();
    setup->getTeamChecker()->setAdaptive(false);
    si->copyState(from.get(), setup->getProblemDefinition()->getStartState(0));
    ASSERT_TRUE(si->isValid(from.get()));
    statistics.reset();
    EXPECT_EQ(si->propagateWhileValid(from.get(), control, 10, to.get()), 10u);
    EXPECT_EQ(statistics.getCounts().robotPoses, 30u);
    EXPECT_GE(statistics.getCounts().certifiedFree, 24u);
    si->freeControl(control);
}

TEST(TeamPropagatorTest, AStepThatIsNotProvedEndsNowhere)
{
    // A wall of 2 mm, and a disc that jumps 1 m in a step
    const auto space = within({3.0, 3.0});
    for (const auto mode : {CertificateMotionValidator::DISCRETE, CertificateMotionValidator::CONTINUOUS})
    {
        TeamControlSetup setup(
            teamOf({Integrator::firstOrder(RigidRobot::disc("disc", 0.1, space), within({10.0, 10.0}))}),
            boxes({{{0.0, 0.0, 0.002, 6.0}}}), Method::SHARED_PROJECTION, mode);
        const auto &si = setup.getSpaceInformation();
        ob::ScopedState<> from(setup.getStateSpace()), to(setup.getStateSpace());
        si->setup();
        from = std::vector<double>{-0.5, 0.0};
        oc::Control *control = si->allocControl();
        auto *values = control->as<oc::RealVectorControlSpace::ControlType>()->values;
        const auto isAccepted = [&](double x, double y)
        {
            values[0] = x;
            values[1] = y;
            return si->propagateWhileValid(from.get(), control, 1, to.get()) == 1;
        };
        EXPECT_EQ(isAccepted(10.0, 0.0), mode == CertificateMotionValidator::DISCRETE);
        EXPECT_TRUE(isAccepted(0.0, 10.0)) << "along the wall";
        EXPECT_TRUE(isAccepted(3.0, 0.0)) << "up to 0.1 m from it";
        EXPECT_TRUE(isAccepted(0.0, 0.0)) << "standing";
        EXPECT_FALSE(isAccepted(4.0, 0.0)) << "into it";
        si->freeControl(control);
    }
}

TEST(TeamPropagatorTest, ProvenPathsNeverCrossThinWalls)
{
    // Steps of 0.1 s at 10 m/s; the walls are thinner than any step, and have one gap each.
    const auto space = within({3.0, 3.0});
    unsigned int solved = 0;
    for (unsigned int seed = 1; seed <= scaled(4); ++seed)
    {
        TeamControlSetup setup(
            teamOf({Integrator::firstOrder(RigidRobot::disc("disc", 0.1, space), within({10.0, 10.0})),
                    Unicycle::firstOrder(RigidRobot::inSE2("box", Body::box(0.5, 0.25), space), within({10.0, 5.0}))}),
            boxes({{{-0.8, -1.0, 0.002, 4.0}, {0.8, 1.0, 0.002, 4.0}}}), Method::SHARED_PROJECTION,
            CertificateMotionValidator::CONTINUOUS);
        const Quiet quiet;
        ompl::RNG::setSeed(seed);
        const auto &si = setup.getSpaceInformation();
        si->setMinMaxControlDuration(1, 3);
        ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
        start = std::vector<double>{-2.0, -2.0, -2.0, 1.0, 0.0};
        goal = std::vector<double>{2.0, 2.0, 2.0, -1.0, 0.0};
        setup.setStartAndGoalStates(start, goal, 1.5);
        setup.setPlanner(std::make_shared<oc::RRT>(si));
        setup.setup();
        ob::IterationTerminationCondition limit(20000);
        if (setup.solve(limit) != ob::PlannerStatus::EXACT_SOLUTION)
            continue;
        ++solved;
        // Any state of the path at any time, by FCL alone
        const TeamValidityChecker fcl(si, boxes({{{-0.8, -1.0, 0.002, 4.0}, {0.8, 1.0, 0.002, 4.0}}}), Method::FCL);
        oc::PathControl path = setup.getSolutionPath();
        path.interpolate();
        const TeamPropagator propagator(si);
        ob::ScopedState<> between(setup.getStateSpace());
        for (unsigned int i = 0; i + 1 < path.getStateCount(); ++i)
            for (int k = 0; k <= 1000; ++k)
            {
                propagator.propagate(path.getState(i), path.getControl(i), path.getControlDuration(i) * k / 1000.0,
                                     between.get());
                ASSERT_TRUE(fcl.isValid(between.get())) << "seed " << seed << " motion " << i << " at " << k;
            }
    }
    EXPECT_GT(solved, 0u);
}

namespace
{
    /** A space that does not tell where its numbers are, as OMPL's own base class does not */
    class Addressless : public ob::SE2StateSpace
    {
    public:
        double *getValueAddressAtIndex(ob::State * /*state*/, unsigned int /*index*/) const override
        {
            return nullptr;
        }
    };

    /** A unicycle's steps in such a space */
    class Wanderer : public DynamicRobot
    {
    public:
        Wanderer(const RobotPtr &shape, const std::shared_ptr<const DynamicRobot> &model)
          : DynamicRobot(shape, {}, ob::RealVectorBounds(0), model->getControlNames(), model->getControlBounds())
          , model_(model)
        {
        }

        void propagate(const ob::State *from, const double *control, double duration, ob::State *to) const override
        {
            model_->propagate(from, control, duration, to);
        }

        void computeStepBounds(const ob::State *from, const double *control, double duration,
                               MotionBound *bounds) const override
        {
            model_->computeStepBounds(from, control, duration, bounds);
        }

    private:
        const std::shared_ptr<const DynamicRobot> model_;
    };

    /** A disc in such a space */
    class AddresslessDisc : public Robot
    {
    public:
        AddresslessDisc() : Robot("wanderer", makeSpace(), {Body::disc(0.2)})
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            const auto *place = state->as<ob::SE2StateSpace::StateType>();
            poses[0] = planarPose(place->getX(), place->getY(), place->getYaw());
        }

        void computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const override
        {
            bounds[0] = {getStateSpace()->distance(from, to), 3.2};
        }

    private:
        static ob::StateSpacePtr makeSpace()
        {
            auto space = std::make_shared<Addressless>();
            space->setBounds(within({3.0, 3.0}));
            return space;
        }
    };
}

TEST(TeamPropagatorTest, RefusesProofsWhereItCannotRefuseSteps)
{
    const auto team = teamOf({std::make_shared<Wanderer>(std::make_shared<AddresslessDisc>(), allKinds()[2])});
    EXPECT_EQ(messageOf([&] { TeamControlSetup(team, boxes({}), Method::SHARED_PROJECTION); }), "");
    EXPECT_NE(
        messageOf(
            [&]
            { TeamControlSetup(team, boxes({}), Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS); })
            .find("getValueAddressAtIndex()"),
        std::string::npos);
}

TEST(TeamPropagatorTest, RefusesBadParts)
{
    const auto space = within({3.0, 3.0});
    auto team = std::make_shared<TeamStateSpace>();
    const ObstaclesPtr obstacles = boxes({});
    EXPECT_NE(messageOf([&] { TeamControlSetup(team, obstacles); }).find("at least one robot"), std::string::npos);
    team->addRobot(RigidRobot::disc("disc", 0.1, space));
    EXPECT_EQ(messageOf([&] { TeamControlSetup(team, obstacles); }), "disc: is no DynamicRobot, so it has no controls");
    const auto controlled = teamOf({allKinds()[0]});
    EXPECT_EQ(
        messageOf(
            [&] { TeamControlSetup(controlled, obstacles, Method::STANDARD, CertificateMotionValidator::CONTINUOUS); }),
        "Steps are proved free by certificates, which the method standard does not have");
}

TEST(LimitedValidityChecker, FindsNoClearanceBeyondTheLimits)
{
    TeamControlSetup setup(teamOf({allKinds()[1]}), boxes({{{2.0, 0.0, 0.2, 0.2}}}));
    setup.getSpaceInformation()->setup();
    const auto checker =
        std::dynamic_pointer_cast<LimitedValidityChecker>(setup.getSpaceInformation()->getStateValidityChecker());
    ASSERT_TRUE(checker);
    ob::ScopedState<> state(setup.getStateSpace());
    state = std::vector<double>{0.0, 0.0, 0.4, 0.0};
    EXPECT_GT(checker->clearance(state.get()), 0.0);
    state[2] = 0.6;
    EXPECT_EQ(checker->clearance(state.get()), -std::numeric_limits<double>::infinity());
}

/** Steps are proved with the checker of the setup, which a change of the obstacles must reach. */
TEST(TeamControlSetup, WarnsWhereProofsAskAnotherCheckerThanStates)
{
    const auto warningsWith = [](CertificateMotionValidator::Mode mode, const auto &replace)
    {
        TeamControlSetup setup(teamOf({allKinds()[2]}), boxes({}), Method::SHARED_PROJECTION, mode);
        ob::ScopedState<> state(setup.getStateSpace());
        state = std::vector<double>(state.reals().size(), 0.0);
        setup.setStartAndGoalStates(state, state);
        replace(setup);
        const Warnings warnings("Give that to the propagator, too");
        setup.setup();
        return warnings.count;
    };
    const auto other = [](const TeamControlSetup &setup)
    { return std::make_shared<TeamValidityChecker>(setup.getSpaceInformation(), boxes({})); };
    const auto discrete = CertificateMotionValidator::DISCRETE, continuous = CertificateMotionValidator::CONTINUOUS;
    const auto setOther = [&](TeamControlSetup &setup) { setup.setStateValidityChecker(other(setup)); };
    EXPECT_EQ(warningsWith(continuous, setOther), 1U);
    EXPECT_EQ(warningsWith(continuous, [&](TeamControlSetup &setup)
                           { setup.setStateValidityChecker(std::make_shared<LimitedValidityChecker>(other(setup))); }),
              1U);
    EXPECT_EQ(warningsWith(discrete, setOther), 0U);
    EXPECT_EQ(warningsWith(continuous, [](TeamControlSetup & /*setup*/) {}), 0U);
}

TEST(TeamControlSetup, SaysThatItNeedsAGoalOrAPlanner)
{
    TeamControlSetup setup(teamOf({allKinds()[2]}), boxes({{0.0, 1.6, 0.2, 2.0}}));
    EXPECT_THROW(setup.setup(), ompl::Exception);
    EXPECT_THROW(setup.solve(0.1), ompl::Exception);
    setup.setPlanner(std::make_shared<oc::RRT>(setup.getSpaceInformation()));
    EXPECT_NO_THROW(setup.setup());
}

/** OMPL's own choice is KPIECE1, which seldom plans for several robots. */
TEST(TeamControlSetup, ChoosesAPlannerForItsTeam)
{
    const Quiet quiet;
    const auto chosen = [](unsigned int robots, const std::function<void(TeamControlSetup &)> &change)
    {
        const auto kinds = allKinds();
        const std::vector<std::shared_ptr<const DynamicRobot>> team(kinds.begin(), kinds.begin() + robots);
        TeamControlSetup setup(teamOf(team), boxes({{{2.9, 2.9, 0.1, 0.1}}}));
        ob::ScopedState<> state(setup.getStateSpace());
        state.random();
        setup.setStartAndGoalStates(state, state);
        change(setup);
        setup.setup();
        return setup.getPlanner()->getName();
    };
    const auto nothing = [](TeamControlSetup &) {};
    EXPECT_EQ(chosen(1, nothing), "RRT");
    EXPECT_EQ(chosen(2, nothing), "PrioritizedRRT");
    const auto planner = [](TeamControlSetup &setup)
    { setup.setPlanner(std::make_shared<oc::EST>(setup.getSpaceInformation())); };
    EXPECT_EQ(chosen(2, planner), "EST");
    const auto allocator = [](TeamControlSetup &setup)
    {
        setup.setPlannerAllocator(
            [](const ob::SpaceInformationPtr &si)
            { return std::make_shared<oc::EST>(std::static_pointer_cast<oc::SpaceInformation>(si)); });
    };
    EXPECT_EQ(chosen(2, allocator), "EST");
    // PrioritizedRRT could not use these.
    const auto propagator = [](TeamControlSetup &setup)
    { setup.setStatePropagator([](const ob::State *, const oc::Control *, double, ob::State *) {}); };
    EXPECT_NE(chosen(2, propagator), "PrioritizedRRT");
    const auto checker = [](TeamControlSetup &setup)
    { setup.setStateValidityChecker([](const ob::State *) { return true; }); };
    EXPECT_NE(chosen(2, checker), "PrioritizedRRT");
}

TEST(TeamControlSetup, RefusesAStepThatIsNotFinite)
{
    const TeamControlSetupPtr setup = makeSetup(Method::STANDARD);
    for (const double step : {std::nan(""), std::numeric_limits<double>::infinity()})
    {
        setup->getSpaceInformation()->setPropagationStepSize(step);
        EXPECT_THROW(setup->setup(), ompl::Exception);
    }
    setup->getSpaceInformation()->setPropagationStepSize(0.1);
    EXPECT_NO_THROW(setup->setup());
}

TEST(TeamControlSetup, WarnsOfAPropagatorThatReplacesTheOneThatProves)
{
    for (const auto mode : {CertificateMotionValidator::DISCRETE, CertificateMotionValidator::CONTINUOUS})
        for (const bool isReplaced : {false, true})
        {
            const Warnings warnings("another one has replaced");
            TeamControlSetup setup(teamOf({allKinds()[2]}), boxes({{0.0, 1.6, 0.2, 2.0}}), Method::SHARED_PROJECTION,
                                   mode);
            setup.setPlanner(std::make_shared<oc::RRT>(setup.getSpaceInformation()));
            if (isReplaced)
                setup.setStatePropagator(std::make_shared<TeamPropagator>(setup.getSpaceInformation()));
            setup.setup();
            EXPECT_EQ(warnings.count, isReplaced && mode == CertificateMotionValidator::CONTINUOUS ? 1U : 0U);
        }
}

TEST(TeamControlSetup, WarnsOfAMotionValidatorThatNoControlPlannerAsks)
{
    const TeamControlSetup setup(teamOf({allKinds()[2]}), boxes({{0.0, 1.6, 0.2, 2.0}}), Method::SHARED_PROJECTION,
                                 CertificateMotionValidator::CONTINUOUS);
    for (const auto mode : {CertificateMotionValidator::DISCRETE, CertificateMotionValidator::CONTINUOUS})
    {
        const Warnings warnings("proves nothing");
        const CertificateMotionValidator validator(setup.getTeamChecker(), mode);
        EXPECT_EQ(warnings.count, mode == CertificateMotionValidator::CONTINUOUS ? 1U : 0U);
    }
}
