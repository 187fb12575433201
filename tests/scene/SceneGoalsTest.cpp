#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/robots/ZoneGoal.h"
#include "ompl_certificates/scene/Scene.h"
#include "support/Message.h"
#include "support/Quiet.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    ob::RealVectorBounds boxOf(const std::vector<double> &low, const std::vector<double> &high)
    {
        ob::RealVectorBounds box(2);
        box.low = low;
        box.high = high;
        return box;
    }

    const ob::RealVectorBounds FLOOR = boxOf({0.0, 0.0}, {20.0, 20.0});

    /** A disc that goes to [7, 9] x [7, 9] */
    Scene::Member discTo(const std::string &name, const std::vector<double> &start)
    {
        Scene::Member disc{RigidRobot::inR2(name, Body::disc(0.5), FLOOR), start, {}};
        disc.region = std::make_shared<ZoneGoal>(disc.robot, boxOf({7.0, 7.0}, {9.0, 9.0}));
        return disc;
    }

    Scene threeDiscs(const std::vector<double> &thirdStart)
    {
        Scene scene("discs", "discs", FLOOR);
        scene.addMember(discTo("first", {1.0, 1.0}));
        scene.addMember(discTo("second", {3.0, 1.0}));
        scene.addMember(discTo("third", thirdStart));
        return scene;
    }
}

TEST(SceneGoals, WhoIsInItsZoneStays)
{
    const Quiet quiet;
    Scene scene = threeDiscs({8.0, 8.0});
    scene.chooseGoals();
    EXPECT_EQ(scene.getMembers()[2].goal, (std::vector<double>{8.0, 8.0}));
    EXPECT_NO_THROW(scene.validate());
}

TEST(SceneGoals, RobotsOfOneZoneStartFromDifferentStates)
{
    const Scene scene = threeDiscs({5.0, 1.0});
    EXPECT_NE(scene.getMembers()[0].goal, scene.getMembers()[1].goal);
    // Two robots of one name find the same.
    EXPECT_EQ(scene.getMembers()[0].goal, threeDiscs({5.0, 1.0}).getMembers()[0].goal);
}

TEST(SceneGoals, AreChosenBeforeTheyAreChecked)
{
    const Quiet quiet;
    Scene scene("discs", "discs", FLOOR);
    for (const char *name : {"first", "second"})
    {
        Scene::Member disc = discTo(name, {scene.getMembers().empty() ? 1.0 : 3.0, 1.0});
        disc.goal = {8.0, 8.0};
        scene.addMember(disc);
    }
    EXPECT_NO_THROW(scene.validate());
    // A wall that leaves no place in the zone
    scene.addObstacle({Body::box(3.0, 3.0), planarPose(8.0, 8.0)});
    EXPECT_NE(messageOf([&] { scene.validate(); }).find("robots[0].goal, where no free state was found"),
              std::string::npos);
}

/** The second disc comes later, with the goal that was chosen for the first. */
TEST(SceneGoals, AreChosenAgainForOneMoreRobot)
{
    const Quiet quiet;
    Scene scene("discs", "discs", FLOOR);
    scene.addMember(discTo("first", {1.0, 1.0}));
    scene.chooseGoals();
    Scene::Member second = discTo("second", {3.0, 1.0});
    second.goal = scene.getMembers().front().goal;
    scene.addMember(second);
    EXPECT_EQ(messageOf([&] { scene.validate(); }), "");
}

TEST(SceneGoals, AreOneStateAtTheEndOfAPath)
{
    const Scene scene = threeDiscs({5.0, 1.0});
    ob::ScopedState<> end(scene.makeTeam());
    end = std::vector<double>{7.1, 7.1, 8.9, 7.1, 7.1, 8.9};
    const Scene ending = scene.endingAt(end.get());
    EXPECT_TRUE(scene.hasRegions());
    EXPECT_FALSE(ending.hasRegions());
    EXPECT_EQ(ending.makeGoal(ending.makeTeam()).reals(), end.reals());
}

TEST(SceneGoals, MustBeInTheirRegion)
{
    Scene scene("discs", "discs", FLOOR);
    Scene::Member disc = discTo("disc", {1.0, 1.0});
    disc.goal = {2.0, 2.0};
    EXPECT_EQ(messageOf([&] { scene.addMember(disc); }),
              "discs: robots[0].goal: [2, 2] of 'disc' is not in its zone from [7, 7] to [9, 9]");
}

TEST(SceneGoals, ControlsGoToOneStateAlone)
{
    const Scene scene = threeDiscs({5.0, 1.0});
    EXPECT_NE(messageOf([&] { scene.makeControlSetup(0.5); }).find("one state for each robot"), std::string::npos);
}
