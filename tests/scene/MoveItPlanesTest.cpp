#include "support/FclVerdicts.h"
#include "support/MoveItScene.h"
#include "support/Random.h"

#include <fcl/geometry/shape/plane.h>
#include <fcl/narrowphase/collision.h>

namespace ompl_certificates
{
    namespace
    {
        using namespace test;

        /** A scene whose obstacle is a plane in an object's frame, and the same plane in the workspace */
        struct Placed
        {
            std::string scene;
            Eigen::Vector3d normal;  // of length 1
            double offset;           // of the points x with normal * x = offset
        };

        Placed randomPlane(Random &random)
        {
            const Eigen::Vector3d own = random.direction(3);
            const double distance = random.uniform(-0.4, 0.4), length = random.logUniform(0.01, 100.0);
            const Pose pose = poseAt(random.uniform(0.0, 0.3) * random.direction(3)) * Pose(random.rotation());
            const Eigen::Quaterniond turn(pose.linear());
            std::ostringstream scene;
            scene.precision(17);
            const Eigen::Vector3d coefficients = length * own;
            scene << OBJECTS << "    - {id: wall, planes: [{coef: [" << coefficients.x() << ", " << coefficients.y()
                  << ", " << coefficients.z() << ", " << -length * distance << "]}], plane_poses: [{position: ["
                  << pose.translation().x() << ", " << pose.translation().y() << ", " << pose.translation().z()
                  << "], orientation: [" << turn.x() << ", " << turn.y() << ", " << turn.z() << ", " << turn.w()
                  << "]}]}\n";
            const Eigen::Vector3d normal = pose.linear() * own;
            return {scene.str(), normal, distance + normal.dot(pose.translation())};
        }

        /** Whether a body is on both sides of the plane as FCL sees it, which is how MoveIt checks it */
        bool touchesFclsPlane(const Body &body, const Pose &pose, const Placed &plane)
        {
            fcl::CollisionObjectd wall(std::make_shared<fcl::Planed>(plane.normal, Shape::FCL_SCALE * plane.offset));
            for (const Body::Part &part : body.getParts())
            {
                Pose at = pose * part.pose;
                at.translation() *= Shape::FCL_SCALE;
                fcl::CollisionObjectd object(part.shape.getCollisionGeometry(), at);
                fcl::CollisionRequestd request;
                fcl::CollisionResultd result;
                if (fcl::collide(&object, &wall, request, result) > 0)
                    return true;
            }
            return false;
        }

        TEST_F(MoveItScene, PlanesAreFclsPlanesForTheWholeArm)
        {
            int touching = 0, apart = 0;
            for (unsigned int seed = 1; seed <= scaled(40); ++seed)
            {
                SCOPED_TRACE(seed);
                Random random(seed);
                const Placed plane = randomPlane(random);
                const SceneFile file = read(plane.scene);
                ASSERT_EQ(file.scene.getObstacles().size(), 1u);
                const auto obstacles = file.scene.makeObstacles();
                const Arm &arm = armOf(file);
                ompl::base::ScopedState<> state(arm.getStateSpace());
                std::vector<Pose> poses(arm.getBodies().size());
                for (int i = 0; i < 100; ++i)
                {
                    state = std::vector<double>{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)};
                    arm.computePoses(state.get(), poses.data());
                    for (std::size_t body = 0; body < poses.size(); ++body)
                    {
                        const bool touches = touchesFclsPlane(arm.getBodies()[body], poses[body], plane);
                        ASSERT_EQ(obstacles->collides(arm.getBodies()[body], poses[body]), touches)
                            << i << " " << arm.getLinkOfBody(body);
                        ++(touches ? touching : apart);
                    }
                }
            }
            EXPECT_GT(touching, apart / 20);
            EXPECT_GT(apart, touching / 20);
        }

        TEST_F(MoveItScene, PlanesAreAsLargeAsFollowersReach)
        {
            // At the start "slide" is at 0.1, so the feeler is 2 m beyond the tip, in the plane.
            for (const std::string mimic : {"multiplier='20'", "multiplier='-2' offset='2.2'"})
            {
                std::string urdf = TWO_LINKS_URDF;
                urdf.replace(
                    urdf.find("</robot>"), 8,
                    "<link name='feeler'><collision><geometry><sphere radius='0.03'/></geometry></collision></link>"
                    "<joint name='follow' type='prismatic'><parent link='tip'/><child link='feeler'/>"
                    "<origin xyz='0 0 0.5'/><axis xyz='1 0 0'/><limit lower='0' upper='4' effort='1' "
                    "velocity='1'/><mimic joint='slide' " +
                        mimic + "/></joint></robot>");
                robot_ = std::make_unique<const ArmFile>(folder_.write("arm.urdf", urdf), folder_.path() + "/arm.srdf");
                const SceneFile file = read(OBJECTS + "    - {id: ceiling, planes: [{coef: [0, 0, 1, -0.82]}]}\n");
                ompl::base::ScopedState<> state(armOf(file).getStateSpace());
                state = std::vector<double>{0.0, 0.0};
                const Pose feeler = armOf(file).getLinkPose(state.get(), "feeler");
                ASSERT_TRUE(feeler.translation().isApprox(Eigen::Vector3d(3.0, 0.0, 0.82))) << feeler.translation();
                EXPECT_TRUE(file.scene.makeObstacles()->collides(Body::sphere(0.03), feeler)) << mimic;
            }
        }

        TEST_F(MoveItScene, ArmsAmongPlanesAreJudgedAsFclJudgesThem)
        {
            // A floor, a wall to the side, and a plane in the frame of the root that no link can touch
            const SceneFile file = read(
                OBJECTS +
                "    - {id: floor, planes: [{coef: [0, 0, 1, 0.2]}]}\n"
                "    - {id: wall, planes: [{coef: [0, 2, 0, 1.0]}]}\n"
                "    - {id: far, header: {frame_id: base}, planes: [{coef: [1, 0, 0, 0]}], plane_poses: [{position: "
                "[20, 0, 0]}]}\n");
            ASSERT_EQ(file.scene.getObstacles().size(), 3u);
            // They are as large as they need be, and not in the way of pictures.
            EXPECT_LT(file.scene.getObstacles().front().body.getBoundingRadius(), 3.0);
            EXPECT_LT(file.scene.getBounds().high[0], 3.0);
            expectFclsVerdicts(file.scene, 2000);
        }
    }
}
