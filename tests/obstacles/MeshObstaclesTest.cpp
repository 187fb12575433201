#include "support/MeshObstacles.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <atomic>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/util/Exception.h>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** FCL's own model of a mesh, as a user makes it */
    template <typename Box = fcl::OBBRSSd>
    std::shared_ptr<fcl::BVHModel<Box>> modelOf(const TriangleMesh &mesh)
    {
        auto model = std::make_shared<fcl::BVHModel<Box>>();
        std::vector<fcl::Triangle> triangles;
        for (std::size_t i = 0; i < mesh.getTriangles().size(); ++i)
            if (const auto &t = mesh.getTriangles()[i]; !mesh.isDegenerate(i))
                triangles.emplace_back(t[0], t[1], t[2]);
        model->beginModel();
        model->addSubModel(std::vector<fcl::Vector3d>(mesh.getVertices()), triangles);
        model->endModel();
        return model;
    }

    bool fclCollides(const fcl::BVHModel<fcl::OBBRSSd> &a, const Pose &poseA, const fcl::BVHModel<fcl::OBBRSSd> &b,
                     const Pose &poseB)
    {
        const fcl::CollisionRequestd request;
        fcl::CollisionResultd result;
        return fcl::collide(&a, fcl::Transform3d(poseA), &b, fcl::Transform3d(poseB), request, result) > 0;
    }
}

class MeshObstacles : public testing::TestWithParam<unsigned int>
{
protected:
    template <typename Test>
    void forMany(unsigned int count, double primitiveChance, const Test &test)
    {
        for (unsigned int seed = 0; seed < scaled(count); ++seed)
        {
            SCOPED_TRACE("seed " + std::to_string(seed));
            Random random(seed);
            const double unit = std::pow(10.0, random.below(8)) * 1e-3;
            const FclObstacles obstacles(randomMeshObstacles(random, GetParam(), unit, primitiveChance), GetParam());
            test(random, obstacles, unit);
            if (HasFatalFailure())
                return;
        }
    }
};

TEST_P(MeshObstacles, HaveTheVerdictOfFclsOwnModels)
{
    unsigned int colliding = 0, checks = 0;
    forMany(100, 0.0,
            [&](Random &random, const FclObstacles &obstacles, double unit)
            {
                const TriangleMeshPtr mesh = randomMesh(random, unit);
                const Body body = meshBody(GetParam(), mesh);
                const auto model = modelOf(*mesh);
                std::vector<std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>>> models;
                for (const auto &obstacle : obstacles.getBodies())
                    models.push_back(modelOf(*obstacle.body.getParts()[0].shape.getMesh()));
                for (int i = 0; i < 100; ++i)
                {
                    const Pose pose = nearPose(random, obstacles, body, unit);
                    bool expected = false;
                    for (std::size_t k = 0; k < models.size(); ++k)
                        expected = expected || fclCollides(*models[k], obstacles.getBodies()[k].pose, *model, pose);
                    ASSERT_EQ(obstacles.collides(body, pose), expected) << i;
                    colliding += expected;
                    ++checks;
                }
            });
    EXPECT_GT(colliding, checks / 10);
    EXPECT_LT(colliding, checks - checks / 10);
}

TEST_P(MeshObstacles, HaveTheClearanceOfTheirNearestTriangle)
{
    forMany(150, 0.3,
            [](Random &random, const FclObstacles &obstacles, double unit)
            {
                for (int i = 0; i < 50; ++i)
                {
                    const Eigen::Vector3d point = random.point(obstacles.getDimension(), 5.0 * unit);
                    double nearest = std::numeric_limits<double>::infinity();
                    for (const auto &[body, pose] : obstacles.getBodies())
                        nearest = std::min(nearest, body.signedDistance(pose.inverse() * point));
                    ASSERT_NEAR(obstacles.clearance(point), nearest, 1e-9 * unit);
                }
            });
}

TEST_P(MeshObstacles, MadeFromKnownOnesAreAsIfMadeAnew)
{
    forMany(200, 0.4,
            [](Random &random, const FclObstacles &some, double unit)
            {
                const ZInterval heights = random.chance(0.5) ? ZInterval() : ZInterval{-0.5 * unit, 0.5 * unit};
                const FclObstacles known(some.getBodies(), GetParam(), heights);
                std::vector<PlacedBody> bodies = known.getBodies();
                if (random.chance(0.5))
                    bodies.push_back({randomBody(random, GetParam(), unit), random.pose(GetParam(), 3.0 * unit)});
                PlacedBody &changed = bodies[random.below(bodies.size())];
                switch (random.below(4))
                {
                    case 0:
                        changed.pose = random.pose(GetParam(), 3.0 * unit);
                        break;
                    case 1:
                        std::swap(changed, bodies.front());
                        break;
                    case 2:
                        std::swap(changed, bodies.back());
                        bodies.pop_back();
                        break;
                    default:
                        break;
                }
                const FclObstacles anew(bodies, GetParam(), heights), made(bodies, known);
                ASSERT_EQ(made.getFingerprint(), anew.getFingerprint());
                const Body body = meshBody(GetParam(), randomMesh(random, unit));
                for (int i = 0; i < 20 && !bodies.empty(); ++i)
                {
                    const Pose pose = nearPose(random, anew, body, unit);
                    ASSERT_EQ(made.collides(body, pose), anew.collides(body, pose));
                    ASSERT_EQ(made.touches(body, pose), anew.touches(body, pose));
                    ASSERT_EQ(made.clearance(pose.translation()), anew.clearance(pose.translation()));
                }
            });
}

TEST_P(MeshObstacles, CollideWithABodyOnlyIfOneOfItsFinestBallsDoes)
{
    unsigned int free = 0;
    forMany(300, 0.3,
            [&](Random &random, const FclObstacles &obstacles, double unit)
            {
                const bool primitive = random.chance(0.3);
                const Body body =
                    primitive ? randomBody(random, GetParam(), unit) : meshBody(GetParam(), randomMesh(random, unit));
                for (int i = 0; i < 30; ++i)
                {
                    const Pose pose = nearPose(random, obstacles, body, unit);
                    if (isCertifiedFree(obstacles, body, pose))
                    {
                        ASSERT_FALSE(obstacles.collides(body, pose)) << pose.matrix();
                        ++free;
                    }
                }
            });
    EXPECT_GT(free, scaled(300));
}

TEST_P(MeshObstacles, CollideWithABodyIfAnInnerSphereOrItsSurfaceIsInside)
{
    unsigned int byInnerSpheres = 0, bySurface = 0;
    forMany(300, 0.3,
            [&](Random &random, const FclObstacles &obstacles, double unit)
            {
                const Body body = random.chance(0.5) ? randomBody(random, GetParam(), unit)
                                                     : meshBody(GetParam(), randomMesh(random, unit));
                const double margin = obstacles.getTolerance() + exactCheckTolerance(body.getBoundingRadius());
                for (int i = 0; i < 30; ++i)
                {
                    const Pose pose = nearPose(random, obstacles, body, unit);
                    if (obstacles.collides(body, pose))
                    {
                        ++bySurface;
                        continue;
                    }
                    for (const Ball &ball : body.getInnerSpheres())
                        ASSERT_GE(obstacles.clearance(pose * ball.center), ball.radius - margin) << pose.matrix();
                    for (int k = 0; k < 20; ++k)
                    {
                        Eigen::Vector3d point = pose * surfacePointOf(random, body);
                        if (GetParam() == 2)
                            point.z() = 0.0;
                        ASSERT_GE(obstacles.clearance(point), -margin) << pose.matrix();
                    }
                    ++byInnerSpheres;
                }
            });
    EXPECT_GT(byInnerSpheres, scaled(300));
    EXPECT_GT(bySurface, scaled(300));
}

TEST_P(MeshObstacles, HoldForBodiesFarSmallerThanTheirTriangles)
{
    for (unsigned int seed = 0; seed < scaled(300); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double unit = std::pow(10.0, random.below(8)) * 1e-3;
        const FclObstacles obstacles(
            {{meshBody(GetParam(), randomMesh(random, 1000.0 * unit)), random.pose(GetParam(), 300.0 * unit)}},
            GetParam());
        const Body body =
            random.chance(0.7) ? randomBody(random, GetParam(), unit) : meshBody(GetParam(), randomMesh(random, unit));
        const double margin = obstacles.getTolerance() + exactCheckTolerance(body.getBoundingRadius());
        for (int i = 0; i < 50; ++i)
        {
            const Pose pose = nearPose(random, obstacles, body, unit);
            const bool collides = obstacles.collides(body, pose);
            if (isCertifiedFree(obstacles, body, pose))
            {
                ASSERT_FALSE(collides) << pose.matrix();
            }
            for (const Ball &ball : body.getInnerSpheres())
                if (obstacles.clearance(pose * ball.center) < ball.radius - margin)
                {
                    ASSERT_TRUE(collides) << pose.matrix();
                }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Dimension, MeshObstacles, testing::Values(2U, 3U));

TEST(MeshObstacles, DoNotTouchWhatIsWhollyInside)
{
    const FclObstacles hollow({{Body::mesh(boxMesh({10, 10, 10}))}}, 3);
    EXPECT_FALSE(hollow.collides(Body::mesh(boxMesh({1, 1, 1})), Pose::Identity()));
    EXPECT_FALSE(hollow.collides(Body::sphere(1.0), Pose::Identity()));
    EXPECT_FALSE(hollow.collides(Body::box(1.0, 2.0, 3.0), Pose::Identity()));
    EXPECT_TRUE(hollow.collides(Body::sphere(1.0), poseAt({5, 0, 0})));
    EXPECT_DOUBLE_EQ(hollow.clearance({0, 0, 1}), 4.0);
    const FclObstacles solid({{Body::box(1.0, 1.0, 1.0)}}, 3);
    EXPECT_FALSE(solid.collides(Body::mesh(boxMesh({10, 10, 10})), Pose::Identity()));
    EXPECT_TRUE(solid.collides(Body::mesh(boxMesh({0.1, 0.1, 0.1})), Pose::Identity()));
    EXPECT_TRUE(FclObstacles({{Body::mesh(boxMesh({1, 1, 1}))}}, 3).collides(Body::sphere(5.0), Pose::Identity()));
}

TEST(MeshObstacles, AreMadeOfFclsModels)
{
    Pose pose = planarPose(1.0, 2.0, 0.5);
    pose.translation().z() = 3.0;
    const auto mesh = boxMesh({1, 2, 3});
    using Meshes = std::vector<std::shared_ptr<fcl::CollisionObjectd>>;
    const Meshes objects{std::make_shared<fcl::CollisionObjectd>(modelOf(*mesh), pose),
                         std::make_shared<fcl::CollisionObjectd>(modelOf<fcl::OBBd>(*mesh), pose)};
    for (const unsigned int dimension : {2U, 3U})
        for (const auto &object : objects)
        {
            const FclObstacles obstacles(Meshes{object}, dimension);
            ASSERT_EQ(obstacles.getBodies().size(), 1U);
            EXPECT_TRUE(obstacles.getBodies()[0].body == meshBody(dimension, mesh));
            EXPECT_TRUE(obstacles.getBodies()[0].pose.isApprox(pose));
        }
    Pose lying = pose;
    lying.linear() = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()).toRotationMatrix();
    objects[0]->setTransform(lying);
    EXPECT_NO_THROW(FclObstacles{objects});
    EXPECT_THROW(FclObstacles(objects, 2), ompl::Exception);
    const auto boxes = std::make_shared<fcl::CollisionObjectd>(modelOf<fcl::AABBd>(*mesh), pose);
    EXPECT_THROW(FclObstacles(Meshes{boxes}), ompl::Exception);
}

TEST(MeshObstacles, ChecksLeaveTheGeometriesAlone)
{
    const Body mesh = Body::mesh(boxMesh({2, 2, 10})), plane = Body::planarMesh(boxMesh({2, 2, 10}));
    for (const Body &body : {mesh, plane})
    {
        const FclObstacles obstacles({{body}}, body.getDimension());
        // Something larger, which is still right but not what FCL would compute
        double &radius = body.getParts().front().shape.getCollisionGeometry()->aabb_radius;
        radius *= 1.5;
        const double before = radius;
        EXPECT_TRUE(obstacles.collides(body, planarPose(1.0, 0.0)));
        EXPECT_FALSE(obstacles.collides(body, planarPose(5.0, 0.0, 0.3)));
        const FclObstacles again({{body}}, body.getDimension());
        EXPECT_EQ(radius, before);
    }
}

/** What FCL needs is made when it is first asked for, here by all threads at once. */
TEST(MeshObstaclesThreads, AskFclForTheFirstTime)
{
    for (unsigned int seed = 1; seed <= scaled(30); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        const FclObstacles obstacles({{meshBody(dimension, boxMesh({2, 2, 10}))}}, dimension);
        const Body body = meshBody(dimension, boxMesh({1, 1, 1}));
        const double x = random.uniform(1.0, 2.0);
        std::atomic<unsigned int> wrong{0};
        std::vector<std::thread> threads;
        for (int i = 0; i < 4; ++i)
            threads.emplace_back([&] { wrong += obstacles.collides(body, planarPose(x, 0.0)) != (x < 1.5) ? 1 : 0; });
        for (auto &thread : threads)
            thread.join();
        EXPECT_EQ(wrong, 0U);
    }
}

/** The squares of such distances are infinite in single precision. */
TEST(MeshObstacles, AreNoFartherThanTheyAre)
{
    std::vector<PlacedBody> bodies;
    for (const double x : {-1e20, 1e20})
        for (int i = 0; i < 20; ++i)
            bodies.push_back({Body::mesh(boxMesh({1.0, 1.0, 1.0})), poseAt({x, 10.0 * i, 0.0})});
    const FclObstacles obstacles(bodies, 3);
    EXPECT_NEAR(obstacles.clearance(Eigen::Vector3d::Zero()), 1e20, 1e14);
}
