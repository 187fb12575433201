#include "DynamicProblems.h"

#include "support/Message.h"
#include "support/Random.h"

#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>

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
                EXPECT_NEAR(std::remainder(difference, 2.0 * M_PI), 0.0, 2e-7)
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
}

TEST(DynamicRobotTest, RefusesBadParts)
{
    const auto space = within({1.0, 1.0});
    const RobotPtr disc = RigidRobot::disc("disc", 0.1, space), box = RigidRobot::inSE2("box", Body::box(1, 1), space);
    EXPECT_EQ(messageOf([&] { Unicycle::firstOrder(disc, space); }), "disc: its shape must move in SE(2)");
    EXPECT_EQ(messageOf([&] { Integrator::firstOrder(box, space); }), "box: its shape must move in R^n");
    EXPECT_EQ(messageOf([&] { Unicycle::firstOrder(box, within({1.0})); }),
              "box: the bounds of its controls must have 2 dimensions, not 1");
    EXPECT_EQ(messageOf(
                  [&] {
                      Unicycle::firstOrder(box, within({1.0, 0.0}));
                  }),
              "box: the bounds of its controls must be finite and not empty, not -0.000000 to 0.000000");
    EXPECT_EQ(messageOf([&] { Car::alone(box, space, 0.0); }), "box: its wheelbase must be positive, not 0.000000");
    EXPECT_EQ(messageOf(
                  [&] {
                      Car::alone(box, within({1.0, 1.6}), 1.0);
                  }),
              "box: its steering angle must stay below a right angle");
    EXPECT_EQ(messageOf([&] { Unicycle::firstOrder(nullptr, space); }), "A dynamic robot needs a shape");
}
