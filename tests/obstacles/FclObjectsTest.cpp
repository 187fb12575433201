#include "support/Random.h"

#include "ompl_certificates/obstacles/FclObstacles.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/plane.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/geometry/shape/triangle_p.h>
#include <gtest/gtest.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    using Objects = std::vector<std::shared_ptr<fcl::CollisionObjectd>>;

    template <typename Geometry, typename... Sizes>
    std::shared_ptr<fcl::CollisionObjectd> object(const Pose &pose, Sizes... sizes)
    {
        return std::make_shared<fcl::CollisionObjectd>(std::make_shared<Geometry>(sizes...), pose);
    }

    /** An upright pyramid */
    std::shared_ptr<fcl::CollisionObjectd> pyramid(const Pose &pose)
    {
        auto vertices = std::make_shared<std::vector<fcl::Vector3d>>(
            std::vector<fcl::Vector3d>{{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 0, 2}});
        auto faces = std::make_shared<std::vector<int>>(
            std::vector<int>{4, 3, 2, 1, 0, 3, 0, 1, 4, 3, 1, 2, 4, 3, 2, 3, 4, 3, 3, 0, 4});
        return std::make_shared<fcl::CollisionObjectd>(std::make_shared<fcl::Convexd>(vertices, 5, faces), pose);
    }

    Pose tilted(const Eigen::Vector3d &position)
    {
        Pose pose = poseAt(position);
        pose.linear() = Eigen::AngleAxisd(0.5, Eigen::Vector3d(1.0, 2.0, 0.5).normalized()).toRotationMatrix();
        return pose;
    }
}

TEST(FclObjects, BecomeTheSameBodiesAtTheSamePoses)
{
    const Pose pose = tilted({1.0, 2.0, 3.0});
    const std::vector<Body> bodies{Body::sphere(0.5), Body::box(1.0, 2.0, 3.0), Body::capsule(0.25, 1.5),
                                   Body::cylinder(0.75, 1.25),
                                   Body::convexPolytope({{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 0, 2}})};
    const Objects objects{object<fcl::Sphered>(pose, 0.5), object<fcl::Boxd>(pose, 1.0, 2.0, 3.0),
                          object<fcl::Capsuled>(pose, 0.25, 1.5), object<fcl::Cylinderd>(pose, 0.75, 1.25),
                          pyramid(pose)};
    for (std::size_t i = 0; i < objects.size(); ++i)
    {
        const FclObstacles obstacles(Objects{objects[i]});
        ASSERT_EQ(obstacles.getBodies().size(), 1U);
        EXPECT_TRUE(obstacles.getBodies()[0].body == bodies[i]) << i;
        EXPECT_TRUE(obstacles.getBodies()[0].pose.isApprox(pose)) << i;
        EXPECT_EQ(obstacles.getDimension(), 3U);
        Random random(i);
        for (int k = 0; k < 100; ++k)
        {
            const Eigen::Vector3d point = pose.translation() + random.point(3, 3.0);
            EXPECT_NEAR(obstacles.clearance(point), bodies[i].signedDistance(pose.inverse() * point), 1e-12);
        }
    }
}

TEST(FclObjects, AreSeenFromAboveInAPlanarWorkspace)
{
    Pose pose = planarPose(1.0, 2.0, 0.5);
    pose.translation().z() = 7.0;
    Pose upsideDown = pose;
    upsideDown.linear() *= Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
    const Pose flat = planarPose(1.0, 2.0, 0.5);
    const auto same = [&](const std::shared_ptr<fcl::CollisionObjectd> &given, const Body &body, const Pose &at)
    {
        const FclObstacles obstacles(Objects{given}, 2);
        for (unsigned int seed = 0; seed < 100; ++seed)
        {
            Random random(seed);
            const Eigen::Vector3d point = Eigen::Vector3d(1.0, 2.0, 0.0) + random.point(2, 3.0);
            EXPECT_NEAR(obstacles.clearance(point), body.signedDistance(at.inverse() * point), 1e-12);
        }
    };
    for (const Pose &upright : {pose, upsideDown})
    {
        same(object<fcl::Boxd>(upright, 1.0, 2.0, 3.0), Body::box(1.0, 2.0), flat);
        same(object<fcl::Capsuled>(upright, 0.25, 1.5), Body::disc(0.25), flat);
        same(object<fcl::Cylinderd>(upright, 0.75, 1.25), Body::disc(0.75), flat);
    }
    same(object<fcl::Sphered>(tilted({1.0, 2.0, 3.0}), 0.5), Body::disc(0.5), planarPose(1.0, 2.0));
    same(pyramid(pose), Body::box(2.0, 2.0), flat);
    const Pose lying = tilted({1.0, 2.0, 3.0});
    std::vector<Eigen::Vector2d> outline;
    for (const Eigen::Vector3d &corner :
         {Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(-1, 1, 0), Eigen::Vector3d(-1, -1, 0), Eigen::Vector3d(1, -1, 0),
          Eigen::Vector3d(0, 0, 2)})
        outline.push_back((lying * corner).head<2>());
    same(pyramid(lying), Body::convexHull(outline), Pose::Identity());
}

TEST(FclObjects, AreRefusedIfNullOfAnotherKindOrNotUpright)
{
    EXPECT_THROW(FclObstacles(Objects{nullptr}), ompl::Exception);
    EXPECT_THROW(FclObstacles(Objects{nullptr}, 2), ompl::Exception);
    const auto ellipsoid = object<fcl::Ellipsoidd>(Pose::Identity(), 1.0, 2.0, 3.0);
    EXPECT_THROW(FclObstacles(Objects{ellipsoid}), ompl::Exception);
    EXPECT_THROW(FclObstacles(Objects{ellipsoid}, 2), ompl::Exception);
    const Pose pose = tilted({0.0, 0.0, 0.0});
    EXPECT_THROW(FclObstacles(Objects{object<fcl::Boxd>(pose, 1.0, 2.0, 3.0)}, 2), ompl::Exception);
    EXPECT_THROW(FclObstacles(Objects{object<fcl::Capsuled>(pose, 1.0, 2.0)}, 2), ompl::Exception);
    EXPECT_THROW(FclObstacles(Objects{object<fcl::Cylinderd>(pose, 1.0, 2.0)}, 2), ompl::Exception);
    const auto leaning = [](double angle)
    {
        Pose turned = Pose::Identity();
        turned.linear() = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()).toRotationMatrix();
        return Objects{object<fcl::Boxd>(turned, 1.0, 2.0, 3.0)};
    };
    EXPECT_THROW(FclObstacles(leaning(1e-5), 2), ompl::Exception);
    EXPECT_NO_THROW(FclObstacles(leaning(1e-6), 2));
    EXPECT_THROW(FclObstacles(Objects{}, 5), ompl::Exception);
    EXPECT_NO_THROW(FclObstacles(Objects{}, 3));
}

TEST(FclObjects, OfOtherKindsAreNamedAsFclNamesThem)
{
    const Pose pose = Pose::Identity();
    const fcl::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const std::vector<std::pair<std::shared_ptr<fcl::CollisionObjectd>, std::string>> others{
        {object<fcl::Ellipsoidd>(pose, 1.0, 2.0, 3.0), "fcl::Ellipsoid"},
        {object<fcl::Coned>(pose, 1.0, 2.0), "fcl::Cone"},
        {object<fcl::Planed>(pose, z, 0.0), "fcl::Plane"},
        {object<fcl::Halfspaced>(pose, z, 0.0), "fcl::Halfspace"},
        {object<fcl::TrianglePd>(pose, x, y, z), "fcl::TriangleP"},
        {object<fcl::BVHModel<fcl::AABBd>>(pose), "fcl::BVHModel<fcl::AABB>"},
        {object<fcl::BVHModel<fcl::RSSd>>(pose), "fcl::BVHModel<fcl::RSS>"},
        {object<fcl::BVHModel<fcl::kIOSd>>(pose), "fcl::BVHModel<fcl::kIOS>"},
        {object<fcl::BVHModel<fcl::KDOPd<16>>>(pose), "fcl::BVHModel<fcl::KDOP<16>>"},
        {object<fcl::BVHModel<fcl::KDOPd<18>>>(pose), "fcl::BVHModel<fcl::KDOP<18>>"},
        {object<fcl::BVHModel<fcl::KDOPd<24>>>(pose), "fcl::BVHModel<fcl::KDOP<24>>"}};
    for (const auto &[given, name] : others)
        for (const unsigned int dimension : {2U, 3U})
            try
            {
                FclObstacles(Objects{given}, dimension);
                ADD_FAILURE() << name << " was taken";
            }
            catch (const ompl::Exception &exception)
            {
                const std::string message = exception.what(), end = ", not " + name;
                EXPECT_EQ(message.substr(message.size() - std::min(end.size(), message.size())), end) << message;
            }
}
