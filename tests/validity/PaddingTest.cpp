// Bodies that keep a distance: from obstacles, from other robots and from zones, but not from their own robot.

#include "support/Checkers.h"
#include "support/ForwardingObstacles.h"
#include "support/TeamOf.h"

#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/robots/ConfinedRobot.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/util/Console.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** Whether a state of a team among obstacles is valid: one verdict of all methods */
    bool isValid(const TeamStateSpacePtr &team, const std::vector<PlacedBody> &obstacles,
                 const std::vector<double> &reals)
    {
        const Checkers checkers(team, std::make_shared<FclObstacles>(obstacles, team->getWorkspaceDimension()));
        ob::ScopedState<> state(team);
        state = reals;
        const bool valid = checkers.isValid(state.get());
        for (const auto &setup : checkers.compared())
            EXPECT_EQ(setup->getTeamChecker()->isValid(state.get()), valid)
                << nameOf(setup->getTeamChecker()->getMethod());
        return valid;
    }

    RobotPtr square(const std::string &name, double padding)
    {
        return RigidRobot::inSE2(name, Body::box(1.0, 1.0).padded(padding), cubeBounds(2, HALF));
    }

    /** Two links in a plane, the second of which can fold back onto the first, and a third one on it */
    std::shared_ptr<const Arm> foldingArm(double padding, const std::vector<std::string> &obstacles = {})
    {
        using JointType = KinematicTree::JointType;
        const auto along = [&](double length) { return Body::join({{Body::box(length, 0.1), planarPose(0.5, 0.0)}}); };
        KinematicTree tree("base", Body::join({{Body::box(0.2, 0.2), planarPose(-1.0, -1.0)}}));
        tree.addLink("base", {"one", JointType::CONTINUOUS}, "first", along(0.9).padded(padding));
        tree.addLink("first", {"two", JointType::CONTINUOUS, planarPose(1.0, 0.0)}, "second",
                     along(0.9).padded(padding));
        tree.addLink("second", {"three", JointType::CONTINUOUS, planarPose(1.0, 0.0)}, "third",
                     along(0.9).padded(padding));
        ArmOptions options;
        options.linkPairs = {{"first", "third"}};
        if (!obstacles.empty())
        {
            options.linkPairs.emplace_back("base", "third");
            options.obstacles = obstacles;
        }
        return std::make_shared<const Arm>("arm", tree, std::vector<std::string>{"one", "two", "three"}, options);
    }

    /** Obstacles of a user, written before there were paddings */
    class OldObstacles : public ForwardingObstacles
    {
    public:
        using ForwardingObstacles::ForwardingObstacles;

        bool knowsPadding() const override
        {
            return false;
        }
    };
}

class Padding : public testing::Test
{
protected:
    void SetUp() override
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    }
};

TEST_F(Padding, KeepsRobotsFromObstacles)
{
    const std::vector<PlacedBody> wall{{Body::box(1.0, 8.0)}};
    EXPECT_TRUE(isValid(teamOf({square("a", 0.25)}), wall, {1.251, 0.0, 0.0}));
    EXPECT_FALSE(isValid(teamOf({square("a", 0.25)}), wall, {1.249, 0.0, 0.0}));
    EXPECT_TRUE(isValid(teamOf({square("a", 0.0)}), wall, {1.001, 0.0, 0.0}));
}

TEST_F(Padding, OfTwoRobotsAddsUp)
{
    const auto team = teamOf({square("a", 0.25), square("b", 0.5)});
    EXPECT_TRUE(isValid(team, {}, {0.0, 0.0, 0.0, 1.751, 0.0, 0.0}));
    EXPECT_FALSE(isValid(team, {}, {0.0, 0.0, 0.0, 1.749, 0.0, 0.0}));
    // Corner to corner
    const double far = 1.0 + 0.75 / std::sqrt(2.0);
    EXPECT_TRUE(isValid(team, {}, {0.0, 0.0, 0.0, far + 0.001, far + 0.001, 0.0}));
    EXPECT_FALSE(isValid(team, {}, {0.0, 0.0, 0.0, far - 0.001, far - 0.001, 0.0}));
    const auto one = teamOf({square("a", 0.0), square("b", 0.5)});
    EXPECT_TRUE(isValid(one, {}, {0.0, 0.0, 0.0, 1.501, 0.0, 0.0}));
    EXPECT_FALSE(isValid(one, {}, {0.0, 0.0, 0.0, 1.499, 0.0, 0.0}));
    const auto discs = teamOf({RigidRobot::inR2("a", Body::disc(0.5).padded(0.25), cubeBounds(2, HALF)),
                               RigidRobot::inR2("b", Body::disc(0.5), cubeBounds(2, HALF))});
    EXPECT_TRUE(isValid(discs, {}, {0.0, 0.0, 1.251, 0.0}));
    EXPECT_FALSE(isValid(discs, {}, {0.0, 0.0, 1.249, 0.0}));
}

/** The first and the third link lie beside each other, 0.9 apart. */
TEST_F(Padding, IsNotKeptWithinARobot)
{
    const double turn = std::acos(0.0);
    for (const double padding : {0.0, 0.5})
    {
        const auto team = teamOf({foldingArm(padding)});
        EXPECT_TRUE(isValid(team, {}, {0.0, turn, turn})) << padding;
        EXPECT_FALSE(isValid(team, {}, {0.0, 0.99 * 2.0 * turn, 0.99 * 2.0 * turn})) << padding;
    }
    // From obstacles all links keep it.
    const std::vector<PlacedBody> post{{Body::disc(0.1), planarPose(0.5, -0.4)}};
    EXPECT_TRUE(isValid(teamOf({foldingArm(0.2)}), post, {0.0, turn, turn}));
    EXPECT_FALSE(isValid(teamOf({foldingArm(0.3)}), post, {0.0, turn, turn}));
}

/** A part for each of two arms on one base, their links 0.2 apart */
TEST_F(Padding, IsNotKeptBetweenPartsOfAMechanism)
{
    KinematicTree tree("base");
    const Body link = Body::box(0.8, 0.1).padded(0.15);
    for (const auto &[side, y] : {std::pair("left", 0.15), std::pair("right", -0.15)})
        tree.addLink("base", {side, KinematicTree::JointType::CONTINUOUS, planarPose(0.0, y)},
                     std::string(side) + " link", link);
    const auto part = [&](const std::string &side)
    {
        ArmOptions options;
        options.linkPairs = {{"left link", "right link"}};
        options.links = std::vector<std::string>{side + " link"};
        return std::make_shared<const Arm>(side, tree, std::vector<std::string>{side}, options);
    };
    EXPECT_TRUE(isValid(teamOf({part("left"), part("right")}), {}, {0.0, 0.0}));
    EXPECT_FALSE(isValid(teamOf({part("left"), part("right")}), {}, {1.5, 1.5}));
}

/** The base is an obstacle of the arm's own. */
TEST_F(Padding, IsKeptFromObstaclesOfAnArmItself)
{
    const std::vector<double> near{-2.2, 1.2, 0.5};
    std::vector<Pose> poses(4);
    const auto arm = foldingArm(0.0, {"base"});
    ob::ScopedState<> state(arm->getStateSpace());
    state = near;
    arm->computePoses(state.get(), poses.data());
    const Body third = arm->getBodies()[3], base = arm->getBodies()[0];
    double distance = 0.0;
    while (!FclObstacles({{base, poses[0]}}, 2).collides(third.padded(distance + 0.01), poses[3]))
        distance += 0.01;
    ASSERT_GT(distance, 0.1);
    EXPECT_TRUE(isValid(teamOf({foldingArm(distance - 0.02, {"base"})}), {}, near));
    EXPECT_FALSE(isValid(teamOf({foldingArm(distance + 0.02, {"base"})}), {}, near));
}

TEST_F(Padding, IsKeptFromZones)
{
    const std::vector<PlacedBody> zone{{Body::box(1.0, 1.0)}};
    const auto team = teamOf({std::make_shared<ConfinedRobot>(square("a", 0.25), zone)});
    EXPECT_TRUE(isValid(team, {}, {1.251, 0.0, 0.0}));
    EXPECT_FALSE(isValid(team, {}, {1.249, 0.0, 0.0}));
}

TEST_F(Padding, MakesRobotsUnlike)
{
    EXPECT_TRUE(square("a", 0.1)->isLike(*square("b", 0.1)));
    EXPECT_FALSE(square("a", 0.1)->isLike(*square("b", 0.2)));
    EXPECT_TRUE(foldingArm(0.1)->isLike(*foldingArm(0.1)));
    EXPECT_FALSE(foldingArm(0.1)->isLike(*foldingArm(0.0)));
}

TEST_F(Padding, NeedsObstaclesThatKnowOfIt)
{
    const auto told = std::make_shared<OldObstacles>(std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2));
    EXPECT_NO_THROW(TeamSetup(teamOf({square("a", 0.0)}), told));
    EXPECT_THROW(TeamSetup(teamOf({square("a", 0.0), square("b", 0.1)}), told), ompl::Exception);
    // The arm's first body has none.
    EXPECT_NO_THROW(TeamSetup(teamOf({foldingArm(0.0)}), told));
    EXPECT_THROW(TeamSetup(teamOf({foldingArm(0.1)}), told), ompl::Exception);
}

TEST_F(Padding, IsCheckedWhenGiven)
{
    for (const double padding : {-0.1, std::numeric_limits<double>::infinity(), std::nan("")})
        EXPECT_THROW(Body::disc(1.0).padded(padding), ompl::Exception);
    const Body body = Body::box(1.0, 2.0).padded(0.5);
    EXPECT_EQ(body.getPadding(), 0.5);
    EXPECT_EQ(body.padded(0.25).getPadding(), 0.25);
    EXPECT_TRUE(body.padded(0.0) == Body::box(1.0, 2.0));
    EXPECT_FALSE(body == Body::box(1.0, 2.0));
    EXPECT_EQ(body.signedDistance({2.0, 0.0, 0.0}), 1.0);
    EXPECT_EQ(Body::join({{body}, {body, planarPose(1.0, 0.0)}}).getPadding(), 0.5);
    EXPECT_THROW(Body::join({{body}, {Body::disc(1.0)}}), ompl::Exception);
}
