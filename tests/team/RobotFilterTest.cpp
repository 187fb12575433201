#include "support/RandomClouds.h"
#include "support/RandomMeshes.h"
#include "support/RandomStates.h"
#include "support/Teams.h"

#include "ompl_certificates/obstacles/PointCloudObstacles.h"
#include "ompl_certificates/robots/ConfinedRobot.h"
#include "ompl_certificates/team/RobotFilter.h"

#include <gtest/gtest.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    double distanceTo(const Team &team, const ompl::base::State *state, const Eigen::Vector3d &point)
    {
        double least = std::numeric_limits<double>::infinity();
        for (unsigned int i = 0; i < team.getRobotCount(); ++i)
        {
            const auto &bodies = team.getRobot(i).getBodies();
            std::vector<Pose> poses(bodies.size());
            team.getRobot(i).computePoses(team.getRobotState(state, i), poses.data());
            for (std::size_t k = 0; k < bodies.size(); ++k)
                least = std::min(least, bodies[k].signedDistance(poses[k].inverse() * point));
        }
        return least;
    }
}

TEST(RobotFilter, LeavesWhatIsNoRobot)
{
    std::size_t dropped = 0, left = 0;
    for (unsigned int seed = 1; seed <= scaled(4); ++seed)
        for (unsigned int kind = 0; kind < TEAMS; ++kind)
        {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", team " + std::to_string(kind));
            Random random(seed);
            const auto space = anyTeam(kind);
            const Team team(space);
            const unsigned int dimension = team.getWorkspaceDimension();
            const auto state = randomState(random, space);
            const PointCloud cloud{randomPoints(random, dimension, 400, HALF), random.chance(0.3) ? 0.0 : 0.02};
            const double padding = random.chance(0.3) ? 0.0 : 0.1;
            const PointCloud rest = withoutRobots(cloud, team, state.get(), padding);
            EXPECT_EQ(rest.radius, cloud.radius);
            // Those that are near are gone, those that are far are there, in their order.
            std::size_t next = 0;
            for (const Eigen::Vector3d &point : cloud.points)
            {
                const double distance = distanceTo(team, state.get(), point) - cloud.radius - padding;
                const bool isLeft = next < rest.points.size() && rest.points[next] == point;
                if (distance < 0.0)
                {
                    ASSERT_FALSE(isLeft) << distance;
                }
                // Inside a closed mesh a point is far from its surface, but no obstacle.
                else if (distance > 1e-6 && kind < FIRST_OF_MESHES)
                {
                    ASSERT_TRUE(isLeft) << distance;
                }
                next += isLeft ? 1 : 0;
            }
            ASSERT_EQ(next, rest.points.size());
            left += next;
            dropped += cloud.points.size() - next;
            const PointCloudObstacles obstacles(rest, dimension);
            for (unsigned int i = 0; i < team.getRobotCount(); ++i)
            {
                const auto &bodies = team.getRobot(i).getBodies();
                std::vector<Pose> poses(bodies.size());
                team.getRobot(i).computePoses(team.getRobotState(state.get(), i), poses.data());
                for (std::size_t k = 0; k < bodies.size(); ++k)
                    ASSERT_FALSE(obstacles.collides(bodies[k], poses[k]));
            }
        }
    EXPECT_GT(dropped, 0U);
    EXPECT_GT(left, dropped);
}

TEST(RobotFilter, KnowsTheInsideOfClosedMeshes)
{
    const auto space = std::make_shared<TeamStateSpace>();
    space->addRobot(RigidRobot::inSE3("box", Body::mesh(boxMesh({2.0, 2.0, 2.0})), cubeBounds(3, 9.0)));
    const Team team(space);
    ompl::base::ScopedState<> state(space);
    state = std::vector<double>{1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
    const PointCloud cloud{{{1.0, 0.0, 0.0}, {1.5, 0.5, -0.5}, {2.05, 0.0, 0.0}, {2.2, 0.0, 0.0}, {1.0, 1.0, 3.0}},
                           0.0};
    const PointCloud rest = withoutRobots(cloud, team, state.get(), 0.1);
    ASSERT_EQ(rest.points.size(), 2U);
    EXPECT_EQ(rest.points[0], cloud.points[3]);
    EXPECT_THROW(withoutRobots(cloud, team, state.get(), -0.1), ompl::Exception);
    EXPECT_THROW(withoutRobots(cloud, team, state.get(), NAN), ompl::Exception);
}

/** Meshes of real robots are so. */
TEST(RobotFilter, KnowsTheInsideOfMeshesThatAreWoundAnyhowAndHaveLooseTriangles)
{
    const TriangleMeshPtr box = boxMesh({2.0, 2.0, 2.0});
    std::vector<Eigen::Vector3d> vertices = box->getVertices();
    std::vector<TriangleMesh::Triangle> triangles = box->getTriangles();
    for (std::size_t i = 0; i < 6; ++i)
        std::swap(triangles[i][0], triangles[i][1]);
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const double x : {1.1, 1.2, 1.3})
        vertices.emplace_back(x, x * x, 0.0);
    triangles.push_back({first, first + 1, first + 2});
    const auto space = std::make_shared<TeamStateSpace>();
    space->addRobot(
        RigidRobot::inSE3("box", Body::mesh(std::make_shared<TriangleMesh>(vertices, triangles)), cubeBounds(3, 9.0)));
    ompl::base::ScopedState<> state(space);
    state = std::vector<double>{1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
    const PointCloud cloud{{{1.0, 0.0, 0.0}, {1.5, 0.5, -0.5}, {3.2, 0.0, 0.0}}, 0.0};
    EXPECT_EQ(findRobots(cloud, Team(space), state.get(), 0.1), (std::vector<bool>{true, true, false}));
}

/** Bodies of one robot may have paddings of their own, and zones are not there to be seen. */
TEST(RobotFilter, AddsThePaddingOfEachBodyButNotOfZones)
{
    const auto space = std::make_shared<TeamStateSpace>();
    const auto car = std::make_shared<CarWithTrailer>("car", Body::box(1.0, 1.0), Body::box(1.0, 1.0).padded(0.3), 2.0,
                                                      cubeBounds(2, 9.0));
    space->addRobot(
        std::make_shared<ConfinedRobot>(car, std::vector<PlacedBody>{{Body::disc(1.0), planarPose(5.0, 5.0)}}));
    ompl::base::ScopedState<> state(space);
    state = std::vector<double>{0.0, 0.0, 0.0, 0.0};
    const PointCloud cloud{{{0.0, 0.55, 0.0}, {0.0, 0.65, 0.0}, {-2.0, 0.85, 0.0}, {-2.0, 0.95, 0.0}, {5.0, 5.0, 0.0}},
                           0.0};
    EXPECT_EQ(findRobots(cloud, Team(space), state.get(), 0.1), (std::vector<bool>{true, false, true, false, false}));
}

/** In the plane points have no height, and meshes may be far above or below them. */
TEST(RobotFilter, SeesPlanarMeshesFromAbove)
{
    const auto space = std::make_shared<TeamStateSpace>();
    space->addRobot(RigidRobot::inSE2("box", Body::planarMesh(boxMesh({2.0, 2.0, 2.0}, {0.0, 0.0, 5.0})).padded(0.2),
                                      cubeBounds(2, 9.0)));
    ompl::base::ScopedState<> state(space);
    state = std::vector<double>{1.0, 0.0, 0.0};
    const PointCloud cloud{{{2.25, 0.0, 0.0}, {2.35, 0.0, 0.0}}, 0.0};
    EXPECT_EQ(findRobots(cloud, Team(space), state.get(), 0.1), (std::vector<bool>{true, false}));
}

/** Robots that are nowhere would filter nothing, and then collide with themselves. */
TEST(RobotFilter, RefusesStatesThatAreNotFinite)
{
    const auto space = anyTeam(0);
    ompl::base::ScopedState<> state(space);
    std::vector<double> reals(state.reals().size(), NAN);
    state = reals;
    EXPECT_THROW(withoutRobots({{Eigen::Vector3d::Zero()}, 0.1}, Team(space), state.get(), 0.1), ompl::Exception);
}
