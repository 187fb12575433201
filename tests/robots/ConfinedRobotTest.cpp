#include "support/Checkers.h"
#include "support/Message.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/robots/CheckRobot.h"
#include "ompl_certificates/robots/ConfinedRobot.h"
#include "ompl_certificates/team/RobotFilter.h"
#include "support/Complaint.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    RobotPtr train(const std::string &name)
    {
        return std::make_shared<CarWithTrailer>(name, Body::box(0.4, 0.2), Body::box(0.3, 0.2), 0.6,
                                                cubeBounds(2, HALF), true);
    }

    /** A box that turns and a train, in the plane, or in space a box that turns */
    std::vector<RobotPtr> someRobots(unsigned int dimension)
    {
        if (dimension == 3)
            return {RigidRobot::inSE3("box", Body::box(0.8, 0.3, 0.2), cubeBounds(3, HALF))};
        return {RigidRobot::inSE2("box", Body::box(0.9, 0.2), cubeBounds(2, HALF)), train("train")};
    }

    /** The same, and a car that drives along curves */
    std::vector<RobotPtr> robotsWithCurves(unsigned int dimension)
    {
        std::vector<RobotPtr> robots = someRobots(dimension);
        if (dimension == 2)
            robots.push_back(RigidRobot::inReedsShepp("car", Body::box(0.9, 0.2), 0.7, cubeBounds(2, HALF)));
        return robots;
    }

    PlacedBody randomZone(Random &random, unsigned int dimension)
    {
        const auto number = [&](double most) { return random.uniform(-most, most); };
        if (dimension == 3)
        {
            Pose pose = poseAt({number(4.0), number(4.0), number(4.0)});
            pose.linear() = Eigen::AngleAxisd(number(3.0), Eigen::Vector3d::UnitX()).toRotationMatrix();
            const Body mesh = Body::mesh(boxMesh({2.0, 0.2, 1.0}, Eigen::Vector3d::Zero()));
            return {random.chance(0.3)   ? mesh
                    : random.chance(0.5) ? Body::box(3.0, 0.1, 2.0)
                                         : Body::sphere(1.0),
                    pose};
        }
        const Body mesh = Body::planarMesh(boxMesh({2.0, 0.2, 1.0}, Eigen::Vector3d::Zero()));
        return {random.chance(0.3)   ? mesh
                : random.chance(0.5) ? Body::box(3.0, 0.1)
                                     : Body::disc(1.0),
                planarPose(number(4.0), number(4.0), number(3.0))};
    }

    bool isInAZone(const Robot &robot, const ob::State *state, const std::vector<PlacedBody> &zones)
    {
        std::vector<Pose> poses(robot.getBodies().size());
        robot.placeBodies(state, poses.data());
        const FclObstacles all(zones, robot.getWorkspaceDimension());
        for (std::size_t body = 0; body < poses.size(); ++body)
            if (all.collides(robot.getBodies()[body], poses[body]))
                return true;
        return false;
    }
}

TEST(ConfinedRobot, IsARobotByTheLibrarysOwnTrial)
{
    Random random(3);
    for (const unsigned int dimension : {2U, 3U})
        for (const RobotPtr &robot : robotsWithCurves(dimension))
        {
            const ConfinedRobot confined(robot, {randomZone(random, dimension), randomZone(random, dimension)});
            EXPECT_EQ(complaintOf([&] { checkRobot(confined, scaled(300)); }), "");
            EXPECT_EQ(confined.getPlannerRange(), robot->getPlannerRange());
            EXPECT_EQ(confined.getTracedBody(), robot->getTracedBody());
        }
}

TEST(ConfinedRobot, IsFreeWhereItIsOutOfItsZonesAndTheRobotIsFree)
{
    std::size_t keptOut = 0, free = 0, motionsKeptOut = 0;
    for (unsigned int seed = 1; seed <= scaled(6); ++seed)
        for (const unsigned int dimension : {2U, 3U})
        {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", dimension " + std::to_string(dimension));
            Random random(seed);
            auto team = std::make_shared<TeamStateSpace>(), open = std::make_shared<TeamStateSpace>();
            std::vector<std::vector<PlacedBody>> zones;
            for (const RobotPtr &robot : someRobots(dimension))
            {
                zones.push_back({randomZone(random, dimension), randomZone(random, dimension)});
                team->addRobot(std::make_shared<ConfinedRobot>(robot, zones.back()));
            }
            for (const RobotPtr &robot : someRobots(dimension))
                open->addRobot(robot);
            std::vector<PlacedBody> obstacles;
            for (int i = 0; i < 10; ++i)
                obstacles.push_back({dimension == 2 ? Body::box(0.4, 0.4) : Body::box(0.4, 0.4, 0.4),
                                     randomZone(random, dimension).pose});
            const auto world = std::make_shared<FclObstacles>(obstacles, dimension);
            const Checkers checkers(team, world), openOnes(open, world);
            const auto validIn = [&](const ob::State *state)
            {
                if (!openOnes.isValid(state))
                    return false;
                for (unsigned int i = 0; i < team->getRobotCount(); ++i)
                    if (isInAZone(open->getRobot(i), Team(open).getRobotState(state, i), zones[i]))
                        return false;
                return true;
            };
            for (unsigned int i = 0; i < 150; ++i)
            {
                const auto from = randomState(random, team), to = randomState(random, team);
                const bool valid = validIn(from.get());
                free += valid ? 1 : 0;
                keptOut += !valid && openOnes.isValid(from.get()) ? 1 : 0;
                ASSERT_EQ(checkers.isValid(from.get()), valid);
                const bool motion = checkers.reference().getSpaceInformation()->checkMotion(from.get(), to.get());
                motionsKeptOut +=
                    !motion && openOnes.reference().getSpaceInformation()->checkMotion(from.get(), to.get()) ? 1 : 0;
                for (const auto &setup : checkers.compared())
                {
                    ASSERT_EQ(setup->getTeamChecker()->isValid(from.get()), valid);
                    ASSERT_EQ(setup->getSpaceInformation()->checkMotion(from.get(), to.get()), motion);
                }
            }
        }
    EXPECT_GT(keptOut, scaled(60));
    EXPECT_GT(free, scaled(60));
    EXPECT_GT(motionsKeptOut, scaled(6));
}

TEST(ConfinedRobot, PassesNoThinZoneInContinuousMode)
{
    const auto bounds = cubeBounds(2, HALF);
    const auto disc = RigidRobot::disc("disc", 0.1, bounds);
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(
        std::make_shared<ConfinedRobot>(disc, std::vector<PlacedBody>{{Body::box(0.0001, 2.0), planarPose(0.3, 0.0)}}));
    team->addRobot(RigidRobot::disc("other", 0.1, bounds));
    const TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>(), 2), Method::SHARED_PROJECTION,
                          CertificateMotionValidator::CONTINUOUS);
    setup.getSpaceInformation()->setStateValidityCheckingResolution(0.5);
    setup.getSpaceInformation()->setup();
    ob::ScopedState<> from(team), to(team);
    const auto isFree = [&](const std::vector<double> &a, const std::vector<double> &b)
    {
        from = a;
        to = b;
        return setup.getSpaceInformation()->checkMotion(from.get(), to.get());
    };
    EXPECT_FALSE(isFree({-1, 0, 0, 3}, {1, 0, 0, 3}));
    EXPECT_TRUE(isFree({-1, 2, 0, 3}, {1, 2, 0, 3}));
    EXPECT_TRUE(isFree({-1, 2, -1, 0}, {-1, 2, 1, 0})) << "the other robot may pass it";
}

TEST(ConfinedRobot, HasZonesThatAreNothingToOthers)
{
    const auto bounds = cubeBounds(2, HALF);
    const PlacedBody zone{Body::disc(1.0), planarPose(2.0, 0.0)};
    const auto mesh =
        RigidRobot::inR2("mesh", Body::planarMesh(boxMesh({0.2, 0.2, 0.2}, Eigen::Vector3d::Zero())), bounds);
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(std::make_shared<ConfinedRobot>(mesh, std::vector<PlacedBody>{zone}));
    team->addRobot(std::make_shared<ConfinedRobot>(train("train"), std::vector<PlacedBody>{zone}));
    const ZInterval zInterval = zIntervalOf({std::make_shared<ConfinedRobot>(mesh, std::vector<PlacedBody>{zone})});
    EXPECT_EQ(zInterval.low, mesh->getBodies().front().getZInterval().low);
    EXPECT_EQ(zInterval.high, mesh->getBodies().front().getZInterval().high);
    // An obstacle and the other's zone are in each zone.
    const TeamSetup setup(team,
                          std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::disc(0.1), zone.pose}}, 2));
    setup.getSpaceInformation()->setup();
    ob::ScopedState<> state(team);
    state = std::vector<double>{-2, 0, -2, 2, 0, 0};
    EXPECT_EQ(setup.getTeamChecker()->describeCollision(state.get()), "");
    state[2] = 1.6;
    state[3] = 0.0;
    EXPECT_EQ(setup.getTeamChecker()->describeCollision(state.get()), "robot 'train' touches keep_out[0] with body 0");
    state[2] = -2.0;
    // What a sensor sees in a zone is no robot.
    EXPECT_EQ(findRobots({{{2.0, 0.5, 0.0}, {-2.0, 0.0, 0.0}}, 0.0}, Team(team), state.get(), 0.0),
              (std::vector<bool>{false, true}));
}

TEST(ConfinedRobot, IsLikeOneWithEqualZones)
{
    const auto bounds = cubeBounds(2, HALF);
    const auto disc = [&](const std::string &name) { return RigidRobot::disc(name, 0.3, bounds); };
    const auto confined = [&](const RobotPtr &robot, double x, double size = 1.0) {
        return std::make_shared<ConfinedRobot>(robot,
                                               std::vector<PlacedBody>{{Body::box(size, 1.0), planarPose(x, 0.0)}});
    };
    EXPECT_TRUE(confined(disc("a"), 1.0)->isLike(*confined(disc("b"), 1.0)));
    EXPECT_FALSE(confined(disc("a"), 1.0)->isLike(*confined(disc("b"), 1.5)));
    EXPECT_FALSE(confined(disc("a"), 1.0)->isLike(*confined(disc("b"), 1.0, 0.5)));
    EXPECT_FALSE(confined(disc("a"), 1.0)->isLike(*disc("b")));
    EXPECT_FALSE(disc("a")->isLike(*confined(disc("b"), 1.0)));
    EXPECT_FALSE(confined(disc("a"), 1.0)->isLike(*confined(train("b"), 1.0)));
}

TEST(ConfinedRobot, RefusesWhatIsNoZone)
{
    const auto disc = RigidRobot::disc("disc", 0.3, cubeBounds(2, HALF));
    const auto message = [](const RobotPtr &robot, const std::vector<PlacedBody> &zones)
    { return messageOf([&] { const ConfinedRobot confined(robot, zones); }); };
    EXPECT_EQ(message(nullptr, {{Body::disc(1.0)}}), "ConfinedRobot: the robot must not be null");
    EXPECT_EQ(message(disc, {}), "disc: there is no zone to keep it out of");
    EXPECT_EQ(message(disc, {{Body::sphere(1.0)}}),
              "disc: a zone of 3 dimensions cannot keep out a robot that moves in 2");
    EXPECT_EQ(message(disc, {{Body::disc(1.0).padded(0.1)}}), "disc: a zone has a padding, which the robot is to have");
    Pose tilted = planarPose(1.0, 0.0), mirrored = tilted;
    tilted.linear() = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()).toRotationMatrix();
    mirrored.linear()(0, 0) = -1.0;
    EXPECT_EQ(message(disc, {{Body::box(1.0, 1.0), tilted}}), "disc: a zone in the plane must stand upright, at z = 0");
    EXPECT_EQ(message(disc, {{Body::disc(1.0), poseAt({0.0, 0.0, 0.1})}}),
              "disc: a zone in the plane must stand upright, at z = 0");
    EXPECT_NE(message(disc, {{Body::disc(1.0), mirrored}}).find("a zone of 'disc'"), std::string::npos);
    const auto confined = std::make_shared<ConfinedRobot>(disc, std::vector<PlacedBody>{{Body::disc(1.0)}});
    EXPECT_EQ(message(confined, {{Body::disc(1.0)}}), "disc: has zones already; name all of them together");
    EXPECT_NE(message(disc, {{Body::disc(1.0), planarPose(std::nan(""), 0.0)}}).find("a zone of 'disc'"),
              std::string::npos);
}
