#include "DynamicProblems.h"

#include "ompl_certificates/control/CheckDynamicRobot.h"
#include "ompl_certificates/robots/ConfinedRobot.h"
#include "support/Message.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace oc = ompl::control;

namespace
{
    constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
    constexpr double INFINITE = std::numeric_limits<double>::infinity();

    /** Steps of a team in a world with a wall of 2 mm along x = 0 */
    class StepTrials
    {
    public:
        explicit StepTrials(const std::shared_ptr<const DynamicRobot> &robot,
                            CertificateMotionValidator::Mode mode = CertificateMotionValidator::CONTINUOUS)
          : setup(teamOf({robot}), boxes({{{0.0, 0.0, 0.002, 6.0}}}), Method::SHARED_PROJECTION, mode)
          , si(setup.getSpaceInformation())
          , from(si)
          , to(si)
          , control(si->allocControl())
        {
            si->setup();
        }

        ~StepTrials()
        {
            si->freeControl(control);
        }

        StepTrials(const StepTrials &) = delete;
        StepTrials &operator=(const StepTrials &) = delete;

        void set(const std::vector<double> &state, const std::vector<double> &controls)
        {
            from = state;
            std::copy(controls.begin(), controls.end(), control->as<oc::RealVectorControlSpace::ControlType>()->values);
        }

        const TeamPropagator &getPropagator() const
        {
            return static_cast<const TeamPropagator &>(*si->getStatePropagator());
        }

        bool isFree(double duration) const
        {
            return isFree(*setup.getTeamChecker(), duration);
        }

        bool isFree(const TeamValidityChecker &checker, double duration) const
        {
            return getPropagator().isStepFree(checker, from.get(), control, duration, from.get());
        }

        /** Whether the state at the end of a step is free, limits or not */
        bool isAccepted(double duration)
        {
            getPropagator().propagate(from.get(), control, duration, to.get());
            return setup.getTeamChecker()->isValid(to.get());
        }

        TeamControlSetup setup;
        const oc::SpaceInformationPtr si;
        ob::ScopedState<> from, to;
        oc::Control *const control;
    };

    std::shared_ptr<const DynamicRobot> fastDisc(const std::string &name = "disc")
    {
        return Integrator::firstOrder(RigidRobot::disc(name, 0.1, within({3.0, 3.0})), within({10.0, 10.0}));
    }

    /** A disc whose state begins with a heading that turns nothing */
    class Compass : public Robot
    {
    public:
        Compass() : Robot("compass", makeSpace(), {Body::disc(0.1)})
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            const double *place = placeOf(state);
            poses[0] = planarPose(place[0], place[1]);
        }

        void computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const override
        {
            bounds[0] = {std::hypot(placeOf(from)[0] - placeOf(to)[0], placeOf(from)[1] - placeOf(to)[1]), 0.0};
        }

        static double *placeOf(const ob::State *state)
        {
            return state->as<ob::CompoundState>()->components[1]->as<ob::RealVectorStateSpace::StateType>()->values;
        }

    private:
        static ob::StateSpacePtr makeSpace()
        {
            auto place = std::make_shared<ob::RealVectorStateSpace>(2);
            place->setBounds(within({3.0, 3.0}));
            auto space = std::make_shared<ob::CompoundStateSpace>();
            space->addSubspace(std::make_shared<ob::SO2StateSpace>(), 1.0);
            space->addSubspace(place, 1.0);
            return space;
        }
    };

    /** Its steps along x, with bounds of the test's choice */
    class Sailor : public DynamicRobot
    {
    public:
        Sailor()
          : DynamicRobot(std::make_shared<Compass>(), {}, ob::RealVectorBounds(0), {"speed", "nothing"},
                         within({10.0, 10.0}))
        {
        }

        void propagate(const ob::State *from, const double *control, double duration, ob::State *to) const override
        {
            getStateSpace()->copyState(to, from);
            Compass::placeOf(to)[0] += control[0] * duration;
        }

        void computeStepBounds(const ob::State * /*from*/, const double *control, double duration,
                               MotionBound *bounds) const override
        {
            bounds[0] = boundOf(std::abs(control[0]) * duration);
        }

        std::function<MotionBound(double)> boundOf{[](double way) { return MotionBound{way, 0.0}; }};
    };
}

TEST(StepProof, NeedsACheckerOfTheSameTeam)
{
    StepTrials trials(fastDisc());
    trials.set({-0.5, 0.0}, {10.0, 0.0});
    const ObstaclesPtr wall = boxes({{{0.0, 0.0, 0.002, 6.0}}});
    EXPECT_FALSE(trials.isFree(0.1)) << "through the wall";
    EXPECT_TRUE(trials.isFree(0.01));
    for (const Method method : {Method::FCL, Method::STANDARD})
        EXPECT_EQ(messageOf([&] { trials.isFree(TeamValidityChecker(trials.si, wall, method), 0.1); }),
                  "Steps are proved free by certificates, which the method " + nameOf(method) + " does not have");

    const std::string otherTeam = "Steps are proved free by a checker of the same space and robots";
    const StepTrials others(fastDisc());
    EXPECT_EQ(messageOf([&] { trials.isFree(*others.setup.getTeamChecker(), 0.1); }), otherTeam);
    // The same space, and a robot without controls
    const auto still = std::make_shared<TeamValidityChecker>(
        trials.si, wall, std::vector<RobotPtr>{RigidRobot::disc("still", 0.1, within({3.0, 3.0}))},
        Method::SHARED_PROJECTION);
    EXPECT_EQ(messageOf([&] { trials.isFree(*still, 0.1); }), otherTeam);
    EXPECT_EQ(messageOf([&] { TeamPropagator(trials.si).requireProof(still); }), otherTeam);
}

TEST(StepProof, IsForStepsForward)
{
    const std::vector<std::vector<double>> starts{{-0.5, 0.0},      {-0.5, 0.0, -10.0, 0.0},
                                                  {-0.7, 0.0, 0.0}, {-0.7, 0.0, 0.0, -10.0, 0.0},
                                                  {-0.7, 0.0, 0.0}, {-0.7, 0.0, 0.0, 0.0}};
    const auto robots = allKinds();
    for (std::size_t i = 0; i < robots.size(); ++i)
    {
        StepTrials trials(robots[i]);
        const bool isSecondOrder = starts[i].size() > 3 && i != 5;
        trials.set(starts[i], {isSecondOrder ? 0.0 : -10.0, 0.0});
        for (const double duration : {-0.2, -INFINITE, NOT_A_NUMBER, INFINITE})
        {
            EXPECT_FALSE(trials.isFree(duration)) << robots[i]->getName() << " " << duration << " s";
            EXPECT_FALSE(trials.isAccepted(duration)) << robots[i]->getName() << " " << duration << " s";
        }
        EXPECT_EQ(trials.si->propagateWhileValid(trials.from.get(), trials.control, -2, trials.to.get()), 0U);
        EXPECT_TRUE(trials.isAccepted(0.0)) << robots[i]->getName() << " stands";
        EXPECT_TRUE(trials.isAccepted(0.1)) << robots[i]->getName() << " drives away from the wall";
    }
}

/** At one end of the step the disc is a hundredth of it in the wall, or just before the wall. */
TEST(StepProof, ReachesToTheEndsOfAStep)
{
    StepTrials trials(fastDisc());
    for (const double start : {-1.09, -1.102})
    {
        trials.set({start, 0.0}, {10.0, 0.0});
        EXPECT_EQ(trials.isFree(0.1), start < -1.1);
        trials.set({start + 1.0, 0.0}, {-10.0, 0.0});
        EXPECT_EQ(trials.isFree(0.1), start < -1.1);
    }
}

TEST(StepProof, NeedsBoundsThatAreNumbers)
{
    const auto sailor = std::make_shared<Sailor>();
    StepTrials trials(sailor);
    trials.set({0.0, -0.5, 0.0}, {10.0, 0.0});
    EXPECT_TRUE(trials.isFree(0.01));
    EXPECT_FALSE(trials.isFree(0.1));
    for (const MotionBound bound :
         {MotionBound{-1.0, 0.0}, MotionBound{0.0, -1.0}, MotionBound{NOT_A_NUMBER, 0.0},
          MotionBound{0.0, NOT_A_NUMBER}, MotionBound{INFINITE, 0.0}, MotionBound{0.0, INFINITE}})
    {
        sailor->boundOf = [=](double) { return bound; };
        EXPECT_FALSE(trials.isFree(0.01)) << bound.linear << ", " << bound.angular;
    }
}

TEST(StepProof, LeavesNoNumberOfARefusedStep)
{
    StepTrials trials(std::make_shared<Sailor>());
    trials.set({0.0, -0.5, 0.0}, {10.0, 0.0});
    EXPECT_FALSE(trials.isAccepted(0.1)) << "though the heading, which comes first, places nothing";
    for (const double number : trials.to.reals())
        EXPECT_TRUE(std::isnan(number));
}

TEST(TeamPropagatorTest, ControlsThatAreNoNumbersLeadNowhere)
{
    for (const auto &robot : allKinds())
        for (const std::vector<double> &controls : {std::vector<double>{NOT_A_NUMBER, 0.1}, {0.1, NOT_A_NUMBER}})
            for (const auto mode : {CertificateMotionValidator::DISCRETE, CertificateMotionValidator::CONTINUOUS})
            {
                StepTrials trials(robot, mode);
                std::vector<double> start(robot->getStateSpace()->getDimension(), 0.0);
                start[0] = -2.0;
                trials.set(start, controls);
                EXPECT_FALSE(trials.isAccepted(0.1)) << robot->getName();
            }
}

TEST(StepProof, KeepsRobotsOutOfTheirZones)
{
    // A thin one across the way, and one far away, whose bounds are no part of the robot's.
    const std::vector<PlacedBody> zones{{Body::box(0.002, 1.0), planarPose(1.5, 0.0)},
                                        {Body::disc(0.1), planarPose(-2.8, -2.8)}};
    const auto space = within({3.0, 3.0});
    const auto confined = [&](const RobotPtr &shape) { return std::make_shared<const ConfinedRobot>(shape, zones); };
    const Body box = Body::box(0.2, 0.2);
    const std::vector<std::shared_ptr<const DynamicRobot>> robots{
        Integrator::firstOrder(confined(RigidRobot::disc("disc", 0.1, space)), within({10.0, 10.0})),
        Unicycle::firstOrder(confined(RigidRobot::inSE2("unicycle", box, space)), within({10.0, 0.5})),
        Car::alone(confined(RigidRobot::inSE2("car", box, space)), within({10.0, 0.5}), 0.25),
        Car::withTrailer(confined(std::make_shared<CarWithTrailer>("train", box, box, 0.3, space)), within({10.0, 0.5}),
                         0.25, 0.8)};
    for (const auto &robot : robots)
    {
        SCOPED_TRACE(robot->getName());
        EXPECT_NO_THROW(checkDynamicRobot(*robot, 0.3, 100));
        StepTrials trials(robot);
        std::vector<double> state(trials.from.reals().size(), 0.0);
        state[0] = 0.7;
        // It moves 1.6 from there: across the zone, or past it
        trials.set(state, {10.0, 0.0});
        EXPECT_FALSE(trials.isFree(0.16));
        StepTrials ends(robot, CertificateMotionValidator::DISCRETE);
        ends.set(state, {10.0, 0.0});
        EXPECT_TRUE(ends.isAccepted(0.16));
        state[1] = 1.5;
        trials.set(state, {10.0, 0.0});
        EXPECT_TRUE(trials.isFree(0.16));
    }
}

/** The other one rushes through the robot, which stands, and is out of its way at both ends of the step. */
TEST(StepProof, OfOneRobotFollowsTheOthersThatItNames)
{
    TeamControlSetup setup(teamOf({fastDisc(), fastDisc("other")}), boxes({}), Method::SHARED_PROJECTION,
                           CertificateMotionValidator::CONTINUOUS);
    const auto &si = setup.getSpaceInformation();
    si->setup();
    const auto &propagator = static_cast<const TeamPropagator &>(*si->getStatePropagator());
    oc::Control *control = si->allocControl();
    const std::vector<double> speeds{0.0, 0.0, 10.0, 0.0};
    std::copy(speeds.begin(), speeds.end(), control->as<oc::RealVectorControlSpace::ControlType>()->values);
    ob::ScopedState<> from(si);
    for (const double y : {0.0, 0.5})
    {
        from = std::vector<double>{0.0, 0.0, -0.5, y};
        EXPECT_EQ(propagator.isRobotStepFree(*setup.getTeamChecker(), from.get(), control, 0.1, 0, {1}), y > 0.0);
    }
    si->freeControl(control);
}

/** The trailer swings against its car faster than between two states that are interpolated. */
TEST(StepProof, SeesATrailerThatSwingsAgainstItsCar)
{
    const auto shape = std::make_shared<CarWithTrailer>("train", Body::box(0.4, 0.3), Body::box(0.4, 0.3), 0.43,
                                                        within({3.0, 3.0}), true);
    const auto train = Car::withTrailer(shape, within({10.0, 1.5}), 0.25, 3.1);
    StepTrials trials(train), samples(train, CertificateMotionValidator::DISCRETE);
    unsigned int touching = 0, proved = 0;
    for (double hinge = 0.0; hinge < 2.9; hinge += 0.05)
        for (const double speed : {-1.0, 1.0})
            for (const double duration : {0.05, 0.1, 0.2, 0.4})
            {
                const std::vector<double> state{1.5, 0.0, 0.0, hinge}, controls{speed, 1.0};
                samples.set(state, controls);
                bool touches = false;
                for (int i = 0; i <= 50 && !touches; ++i)
                    touches = !samples.isAccepted(duration * i / 50);
                trials.set(state, controls);
                const bool isProved = trials.isFree(duration);
                ASSERT_FALSE(touches && isProved) << hinge << ", " << speed << " m/s for " << duration << " s";
                touching += touches ? 1 : 0;
                proved += isProved ? 1 : 0;
            }
    EXPECT_GT(touching, 20U);
    EXPECT_GT(proved, 20U);
}
