#include "ompl_certificates/robots/AnyOfGoals.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/robots/ZoneGoal.h"
#include "support/Message.h"
#include "support/RandomTrees.h"

#include <gtest/gtest.h>
#include <map>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** A goal that is near, but of which no state is found */
    class Nowhere : public RobotGoal
    {
    public:
        double distance(const ob::State * /*state*/) const override
        {
            return 0.25;
        }

        bool sample(ompl::RNG & /*random*/, ob::State * /*state*/) const override
        {
            return false;
        }
    };

    ob::RealVectorBounds boxOf(double low, double high)
    {
        ob::RealVectorBounds box(2);
        box.setLow(low);
        box.setHigh(high);
        return box;
    }

    const RobotPtr CART = RigidRobot::inSE2("cart", Body::box(0.5, 0.25), boxOf(0.0, 10.0));
}

TEST(AnyOfGoals, HoldsTheStatesOfAll)
{
    const AnyOfGoals goal(CART, {{1.0, 2.0, 3.0}, {4.0, 5.0, -1.0}},
                          {std::make_shared<ZoneGoal>(CART, boxOf(7.0, 8.0)), std::make_shared<Nowhere>()});
    EXPECT_EQ(goal.describe(), "any of its 4 goals");
    ompl::RNG random(1);
    ob::ScopedState<> state(CART->getStateSpace());
    std::map<double, int> times;
    for (int i = 0; i < 400; ++i)
    {
        ASSERT_TRUE(goal.sample(random, state.get()));
        EXPECT_EQ(goal.distance(state.get()), 0.0);
        const double x = state.reals()[0];
        ++times[x >= 7.0 ? 7.0 : x];
    }
    ASSERT_EQ(times.size(), 3U);
    EXPECT_GT(times[1.0], 60);
    EXPECT_GT(times[4.0], 60);
    EXPECT_GT(times[7.0], 60);
    state = std::vector<double>{1.0, 2.0625, 3.0};
    EXPECT_EQ(goal.distance(state.get()), 0.0625);
    state = std::vector<double>{7.5, 8.125, 0.0};
    EXPECT_EQ(goal.distance(state.get()), 0.125);
    state = std::vector<double>{5.0, 9.0, 0.0};
    EXPECT_EQ(goal.distance(state.get()), 0.25);
    EXPECT_FALSE(AnyOfGoals(CART, {}, {std::make_shared<Nowhere>()}).sample(random, state.get()));
}

TEST(AnyOfGoals, MayBeStatesOfAnySpace)
{
    ob::RealVectorBounds hall(3);
    hall.setLow(0.0);
    hall.setHigh(10.0);
    const RobotPtr drone = RigidRobot::inSE3("drone", Body::sphere(0.1), hall),
                   car = RigidRobot::inReedsShepp("car", Body::box(0.5, 0.25), 0.7, boxOf(0.0, 10.0));
    ompl::RNG random(1);
    for (const auto &[robot, state] : {std::pair(drone, std::vector<double>{1.0, 2.0, 3.0, 0.0, 0.6, 0.0, 0.8}),
                                       std::pair(car, std::vector<double>{3.0, 4.0, 1.0})})
    {
        const AnyOfGoals goal(robot, {state});
        ob::ScopedState<> sampled(robot->getStateSpace());
        ASSERT_TRUE(goal.sample(random, sampled.get()));
        EXPECT_EQ(sampled.reals(), state);
        EXPECT_EQ(goal.distance(sampled.get()), 0.0) << robot->getName();
    }
}

TEST(AnyOfGoals, IsForRobotsThatEachOfThemIsFor)
{
    const RobotPtr disc = RigidRobot::disc("disc", 0.1, boxOf(0.0, 10.0));
    const AnyOfGoals zones(
        CART, {},
        {std::make_shared<ZoneGoal>(CART, boxOf(1.0, 2.0)), std::make_shared<ZoneGoal>(CART, boxOf(7.0, 8.0))});
    EXPECT_TRUE(zones.isFor(*CART));
    EXPECT_FALSE(zones.isFor(*disc));
}

TEST(AnyOfGoals, RefusesWhatMakesNoSense)
{
    const std::pair<std::vector<std::vector<double>>, std::string> wrong[] = {
        {{}, "cart: goal: there must be one goal at least"},
        {{{1.0, 2.0, 0.0}, {1.0, 2.0}}, "cart: goal: state 1 must have 3 coordinates, not 2"},
        {{{1.0, NAN, 0.0}}, "cart: goal: state 0 must be finite"},
        {{{1.0, 11.0, 0.0}}, "cart: goal: state 0 is outside the bounds"}};
    for (const auto &[states, message] : wrong)
        EXPECT_EQ(messageOf([&, &given = states] { AnyOfGoals(CART, given); }), message);
    EXPECT_EQ(messageOf([] { AnyOfGoals(CART, {}, {nullptr}); }), "cart: goal: no goal may be null");
    EXPECT_EQ(messageOf([] { AnyOfGoals(nullptr, {{1.0}}); }), "AnyOfGoals: the robot must not be null");
}
