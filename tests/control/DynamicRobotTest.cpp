#include "DynamicProblems.h"

#include "ompl_certificates/control/CheckDynamicRobot.h"

#include "support/Message.h"
#include "support/Random.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/SE2StateSpace.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** The rates of a robot's coordinates, as the models' textbooks have them */
    std::vector<double> ratesOf(const std::string &name, const std::vector<double> &q, const double *u)
    {
        if (name == "single")
            return {u[0], u[1]};
        if (name == "double")
            return {q[2], q[3], u[0], u[1]};
        if (name == "unicycle")
            return {u[0] * std::cos(q[2]), u[0] * std::sin(q[2]), u[1]};
        if (name == "unicycle2")
            return {q[3] * std::cos(q[2]), q[3] * std::sin(q[2]), q[4], u[0], u[1]};
        std::vector<double> rates{u[0] * std::cos(q[2]), u[0] * std::sin(q[2]), u[0] / 0.25 * std::tan(u[1])};
        if (name == "train")
            rates.push_back(u[0] / 0.5 * std::sin(q[2] - q[3]));
        return rates;
    }

    /** The midpoint method in very small steps */
    std::vector<double> integrated(const std::string &name, std::vector<double> q, const double *u, double duration)
    {
        constexpr int steps = 20000;
        for (int i = 0; i < steps; ++i)
        {
            std::vector<double> middle = q;
            const std::vector<double> first = ratesOf(name, q, u);
            for (std::size_t k = 0; k < q.size(); ++k)
                middle[k] += 0.5 * duration / steps * first[k];
            const std::vector<double> rates = ratesOf(name, middle, u);
            for (std::size_t k = 0; k < q.size(); ++k)
                q[k] += duration / steps * rates[k];
        }
        return q;
    }

    struct Step
    {
        ob::ScopedState<> from;
        std::vector<double> control;
        double duration;
    };

    Step randomStep(Random &random, const DynamicRobot &robot)
    {
        Step step{ob::ScopedState<>(robot.getStateSpace()), {}, random.uniform(0.01, 1.0)};
        for (unsigned int i = 0; i < robot.getStateSpace()->getDimension(); ++i)
            step.from[i] = random.uniform(-0.5, 0.5);
        for (std::size_t i = 0; i < robot.getControlBounds().low.size(); ++i)
            step.control.push_back(random.uniform(robot.getControlBounds().low[i], robot.getControlBounds().high[i]));
        return step;
    }
}

TEST(DynamicRobotTest, StepsEqualFineIntegration)
{
    for (const auto &robot : allKinds())
        for (unsigned int seed = 1; seed <= 10; ++seed)
        {
            Random random(seed);
            Step step = randomStep(random, *robot);
            std::vector<double> expected =
                integrated(robot->getName(), step.from.reals(), step.control.data(), step.duration);
            ob::ScopedState<> to(robot->getStateSpace());
            robot->propagate(step.from.get(), step.control.data(), step.duration, to.get());
            for (std::size_t i = 0; i < expected.size(); ++i)
            {
                const double difference = expected[i] - to[static_cast<unsigned int>(i)];
                EXPECT_NEAR(std::remainder(difference, 2.0 * M_PI), 0.0, 1e-8)
                    << robot->getName() << " seed " << seed << " coordinate " << i;
            }
            robot->propagate(step.from.get(), step.control.data(), step.duration, step.from.get());
            EXPECT_EQ(step.from.reals(), to.reals()) << robot->getName() << ": from and to are one state";
        }
}

TEST(DynamicRobotTest, NoPointMovesFasterThanTheStepBounds)
{
    for (const auto &robot : allKinds())
        for (unsigned int seed = 1; seed <= 100; ++seed)
        {
            Random random(seed);
            const Step step = randomStep(random, *robot);
            const std::size_t bodies = robot->getBodies().size();
            std::vector<MotionBound> bounds(bodies);
            robot->computeStepBounds(step.from.get(), step.control.data(), step.duration, bounds.data());
            ob::ScopedState<> a(robot->getStateSpace()), b(robot->getStateSpace());
            std::vector<Pose> first(bodies), second(bodies);
            const double s = random.uniform(0.0, 1.0), t = random.uniform(0.0, 1.0);
            robot->propagate(step.from.get(), step.control.data(), s * step.duration, a.get());
            robot->propagate(step.from.get(), step.control.data(), t * step.duration, b.get());
            robot->computePoses(a.get(), first.data());
            robot->computePoses(b.get(), second.data());
            for (std::size_t body = 0; body < bodies; ++body)
                for (const Eigen::Vector3d &point :
                     {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-0.3, 2, 0)})
                    EXPECT_LE((first[body] * point - second[body] * point).norm(),
                              bounds[body].at(point.norm()) * std::abs(s - t) * (1.0 + 1e-6) + 1e-12)
                        << robot->getName() << " seed " << seed << " body " << body;
        }
}

/** A trailer turns fastest where it stands across its car, which random states within its limits never are. */
TEST(DynamicRobotTest, TheStepBoundOfATrailerIsThatOfAnyHingeAngle)
{
    const auto train = allKinds()[5];
    ob::ScopedState<> from(train->getStateSpace()), to(train->getStateSpace());
    for (const double hinge : {M_PI_2, -M_PI_2})
        for (const double speed : {0.5, -0.5})
        {
            constexpr double duration = 0.01;
            from = std::vector<double>{0.0, 0.0, 0.3, 0.3 - hinge};
            const double control[] = {speed, 0.0};
            std::vector<MotionBound> bounds(train->getBodies().size());
            train->computeStepBounds(from.get(), control, duration, bounds.data());
            train->propagate(from.get(), control, duration, to.get());
            const double turn = std::abs(to[3] - from[3]);
            EXPECT_GE(bounds[1].angular, turn);
            EXPECT_LT(bounds[1].angular, 1.01 * turn);
        }
}

TEST(DynamicRobotTest, LimitsHoldVelocitiesAndHinge)
{
    const auto robots = allKinds();
    ob::ScopedState<> fast(robots[1]->getStateSpace()), train(robots[5]->getStateSpace());
    fast = std::vector<double>{0.0, 0.0, 0.4, -0.5};
    EXPECT_TRUE(robots[1]->isWithinLimits(fast.get()));
    fast[2] = 0.6;
    EXPECT_FALSE(robots[1]->isWithinLimits(fast.get()));
    train = std::vector<double>{0.0, 0.0, 3.0, -2.6};  // 0.68 rad, across pi
    EXPECT_TRUE(robots[5]->isWithinLimits(train.get()));
    train[3] = -2.4;
    EXPECT_FALSE(robots[5]->isWithinLimits(train.get()));

    const double none = std::nan(""), control[] = {0.1, 0.0};
    fast[2] = none;
    EXPECT_FALSE(robots[1]->isWithinLimits(fast.get()));
    train[3] = none;
    robots[5]->propagate(train.get(), control, 0.1, train.get());
    EXPECT_TRUE(std::isnan(train[3])) << "a heading comes from none";
}

namespace
{
    /** A robot whose bodies are moved from the frame of its state */
    class Moved : public Robot
    {
    public:
        Moved(const RobotPtr &robot, std::vector<Pose> places)
          : Robot("moved", robot->getStateSpace(), std::vector<Body>(places.size(), robot->getBodies()[0]))
          , robot_(robot)
          , places_(std::move(places))
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            robot_->computePoses(state, poses);
            const Pose frame = poses[0];
            for (std::size_t body = 0; body < places_.size(); ++body)
                poses[body] = frame * places_[body];
            if (isLoose)
                poses[places_.size() - 1].translation().x() *= 1.001;
            if (swing > 0.0)
                poses[0].translation().x() += swing * frame(0, 0);
        }

        void computeMotionBounds(const ob::State * /*from*/, const ob::State * /*to*/,
                                 MotionBound * /*bounds*/) const override
        {
        }

        bool isLoose{false};
        /** How far the first body swings as the frame turns */
        double swing{0.0};

    private:
        const RobotPtr robot_;
        const std::vector<Pose> places_;
    };

    /** Steps whose bounds are a little too small */
    class Optimist : public DynamicRobot
    {
    public:
        explicit Optimist(const std::shared_ptr<const DynamicRobot> &robot, double half = 3.0)
          : DynamicRobot(RigidRobot::inSE2("optimist", Body::box(0.5, 0.25), within({half, half})), {},
                         ob::RealVectorBounds(0), robot->getControlNames(), robot->getControlBounds())
          , robot_(robot)
        {
        }

        void propagate(const ob::State *from, const double *control, double duration, ob::State *to) const override
        {
            robot_->propagate(from, control, duration, to);
            if (forgets)
                to->as<ob::SE2StateSpace::StateType>()->setX(from->as<ob::SE2StateSpace::StateType>()->getX());
            if (fails)
                to->as<ob::SE2StateSpace::StateType>()->setX(std::nan(""));
            if (unwinds)
            {
                auto *end = to->as<ob::SE2StateSpace::StateType>();
                end->setYaw(end->getYaw() + (end->getYaw() < 0.0 ? -2.0 : 2.0) * M_PI);
            }
        }

        void computeStepBounds(const ob::State *from, const double *control, double duration,
                               MotionBound *bounds) const override
        {
            robot_->computeStepBounds(from, control, duration, bounds);
            bounds[0].linear *= share;
            if (writesMore)
                bounds[1] = bounds[0];
            if (knowsNone)
                bounds[0].angular = std::numeric_limits<double>::infinity();
        }

        double share{1.0};
        bool writesMore{false}, fails{false}, forgets{false}, knowsNone{false}, unwinds{false};

    private:
        const std::shared_ptr<const DynamicRobot> robot_;
    };

    /** Drives most of its way at the beginning of a step. Its bound holds for the step as a whole. */
    class Jumper : public DynamicRobot
    {
    public:
        Jumper()
          : DynamicRobot(RigidRobot::disc("jumper", 0.1, within({3.0, 3.0})), {}, ob::RealVectorBounds(0), {"v"},
                         within({1.0}))
        {
        }

        void propagate(const ob::State *from, const double *control, double duration, ob::State *to) const override
        {
            getStateSpace()->copyState(to, from);
            to->as<ob::RealVectorStateSpace::StateType>()->values[0] += control[0] * std::sqrt(duration);
        }

        void computeStepBounds(const ob::State * /*from*/, const double *control, double duration,
                               MotionBound *bounds) const override
        {
            bounds[0] = {std::abs(control[0]) * std::sqrt(duration), 0.0};
        }
    };
}

TEST(DynamicRobotTest, BodiesMayLieBesideTheFrame)
{
    const auto space = within({3.0, 3.0});
    const RobotPtr box = RigidRobot::inSE2("box", Body::box(0.5, 0.25), space),
                   disc = RigidRobot::disc("disc", 0.1, space);
    const std::vector<Pose> ahead{planarPose(2.0, 0.0, 0.3), planarPose(0.0, 0.0), planarPose(-0.5, 1.0, 3.0)};
    const auto turning = std::make_shared<Moved>(box, ahead), straight = std::make_shared<Moved>(disc, ahead);
    for (const std::shared_ptr<const DynamicRobot> &robot :
         {std::shared_ptr<const DynamicRobot>(Unicycle::firstOrder(turning, within({0.5, 2.0}))),
          std::shared_ptr<const DynamicRobot>(Unicycle::secondOrder(turning, within({0.5, 0.5}), within({0.25, 0.25}))),
          std::shared_ptr<const DynamicRobot>(Car::alone(turning, within({0.5, 1.0}), 0.25)),
          std::shared_ptr<const DynamicRobot>(Integrator::firstOrder(straight, within({0.5, 0.5})))})
        EXPECT_EQ(messageOf([&] { checkDynamicRobot(*robot, 0.5); }), "");

    turning->isLoose = straight->isLoose = true;
    const std::string loose = "moved: its body 2 is not fixed to the frame of its state";
    EXPECT_EQ(messageOf([&] { Unicycle::firstOrder(turning, space); }), loose);
    EXPECT_EQ(messageOf([&] { Car::alone(turning, within({0.5, 1.0}), 0.25); }), loose);
    EXPECT_EQ(messageOf([&] { Integrator::firstOrder(straight, space); }), loose);
}

TEST(DynamicRobotTest, BodiesMayLieBesideTheFrameOnAnyFloor)
{
    const auto boundsOf = [](double low, double high, double beside, double swing)
    {
        ob::RealVectorBounds floor(2);
        floor.setLow(low);
        floor.setHigh(high);
        const auto shape = std::make_shared<Moved>(RigidRobot::inSE2("disc", Body::disc(0.3), floor),
                                                   std::vector<Pose>{planarPose(0.0, beside)});
        shape->swing = swing;
        const auto robot = Unicycle::firstOrder(shape, within({1.0, 7.0}));
        ob::ScopedState<> state(robot->getStateSpace());
        state = std::vector<double>{low, high, 0.0};
        const double turn[] = {0.0, 6.0};
        MotionBound bound;
        robot->computeStepBounds(state.get(), turn, 1.0, &bound);
        return bound;
    };
    EXPECT_GE(boundsOf(-1e9, 1e9, 0.1, 0.0).linear, 0.6);
    EXPECT_GE(boundsOf(-1e7, 1e7, 1e-3, 0.0).linear, 6e-3);
    EXPECT_GE(boundsOf(1e5, 1e5 + 10.0, 1e-4, 0.0).linear, 5.999e-4);
    EXPECT_LE(boundsOf(1e5, 1e5 + 10.0, 1e-4, 0.0).linear, 6.01e-4);
    EXPECT_EQ(boundsOf(-1e9, 1e9, 0.0, 0.0).linear, 0.0);
    EXPECT_EQ(boundsOf(1e9, 2e9, 0.0, 0.0).linear, 0.0);
    EXPECT_EQ(messageOf([&] { boundsOf(-1e9, 1e9, 0.0, 1e-3); }),
              "moved: its body 0 is not fixed to the frame of its state");
}

TEST(DynamicRobotTest, TrialFindsWrongSteps)
{
    for (const auto &robot : allKinds())
        EXPECT_EQ(messageOf([&] { checkDynamicRobot(*robot, 0.5); }), "");
    const auto complaint = [](auto change)
    {
        Optimist optimist(allKinds()[2]);
        change(optimist);
        return messageOf([&] { checkDynamicRobot(optimist, 0.5); });
    };
    EXPECT_EQ(complaint([](Optimist &) {}), "");
    EXPECT_NE(complaint([](Optimist &robot) { robot.share = 0.99; }).find("of body 0 moves"), std::string::npos);
    EXPECT_EQ(complaint([](Optimist &robot) { robot.knowsNone = true; }), "");
    EXPECT_NE(complaint([](Optimist &robot) { robot.share = -1.0; }).find("must not be negative"), std::string::npos);
    EXPECT_NE(complaint([](Optimist &robot) { robot.writesMore = true; }).find("writes more"), std::string::npos);
    EXPECT_NE(complaint([](Optimist &robot) { robot.fails = true; }).find("not finite"), std::string::npos);
    EXPECT_NE(complaint([](Optimist &robot) { robot.forgets = true; }).find("if both states are one"),
              std::string::npos);
    EXPECT_NE(complaint([](Optimist &robot) { robot.unwinds = true; }).find("an angle beyond -pi to pi"),
              std::string::npos);
    Optimist wide(allKinds()[2], 1e11);
    EXPECT_EQ(messageOf([&] { checkDynamicRobot(wide, 0.5); }), "");
    wide.share = 0.0;
    EXPECT_NE(messageOf([&] { checkDynamicRobot(wide, 0.5); }).find("of body 0 moves"), std::string::npos);
    EXPECT_EQ(messageOf([] { checkDynamicRobot(*allKinds()[0], 0.0); }),
              "single: the longest step must be positive, not 0 s");
}

TEST(DynamicRobotTest, TrialFindsStepsThatAreNotDrivenEvenly)
{
    EXPECT_NE(messageOf([] { checkDynamicRobot(Jumper(), 1.0); }).find("of body 0 moves"), std::string::npos);
}

TEST(DynamicRobotTest, RefusesBadParts)
{
    const auto space = within({1.0, 1.0});
    const RobotPtr disc = RigidRobot::disc("disc", 0.1, space), box = RigidRobot::inSE2("box", Body::box(1, 1), space);
    EXPECT_EQ(messageOf([&] { Unicycle::firstOrder(disc, space); }), "disc: its shape must move in SE(2)");
    const RobotPtr car = RigidRobot::inReedsShepp("car", Body::disc(0.1), 1.0, space);
    EXPECT_EQ(messageOf([&] { Unicycle::firstOrder(car, space); }), "car: its shape must move in SE(2)");
    EXPECT_EQ(messageOf([&] { Integrator::firstOrder(box, space); }), "box: its shape must move in R^2 or R^3");
    EXPECT_EQ(messageOf([&] { Unicycle::firstOrder(box, within({1.0})); }),
              "box: the bounds of its controls must have 2 dimensions, not 1");
    EXPECT_EQ(messageOf(
                  [&] {
                      Unicycle::firstOrder(box, within({1.0, 0.0}));
                  }),
              "box: the bounds of its controls must be finite, each low below its high, not -0.000000 to 0.000000");
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(messageOf(
                  [&] {
                      Integrator::firstOrder(RigidRobot::disc("far", 0.1, within({infinite, 1.0})), space);
                  }),
              "far: the bounds of its position must be finite, each low at most its high, not -inf to inf");
    EXPECT_EQ(messageOf(
                  [&] {
                      Unicycle::firstOrder(RigidRobot::inSE2("far", Body::box(1, 1), within({1.0, infinite})), space);
                  }),
              "far: the bounds of its position must be finite, each low at most its high, not -inf to inf");
    EXPECT_EQ(messageOf([&] { Car::alone(box, space, 0.0); }), "box: its wheelbase must be positive, not 0.000000");
    EXPECT_EQ(messageOf(
                  [&] {
                      Car::alone(box, within({1.0, 1.6}), 1.0);
                  }),
              "box: its steering angle must stay below a right angle");
    EXPECT_EQ(messageOf([&] { Unicycle::firstOrder(nullptr, space); }), "A dynamic robot needs a shape");
}
