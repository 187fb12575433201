#include "support/ForwardingObstacles.h"
#include "support/MeshObstacles.h"
#include "support/RandomCells.h"
#include "support/RandomClouds.h"

#include "ompl_certificates/obstacles/CellObstacles.h"
#include "ompl_certificates/obstacles/MixedObstacles.h"
#include "ompl_certificates/obstacles/PointCloudObstacles.h"

#include <gtest/gtest.h>
#include <limits>
#include <string>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    enum Kind
    {
        PRIMITIVES,
        MESHES,
        CELLS,
        CLOUD,
        MIXED,
        KINDS
    };

    ObstaclesPtr obstaclesOfKind(Random &random, unsigned int kind, unsigned int dimension)
    {
        switch (kind)
        {
            case PRIMITIVES:
                return std::make_shared<FclObstacles>(randomMeshObstacles(random, dimension, 1.0, 1.0), dimension);
            case MESHES:
                return std::make_shared<FclObstacles>(randomMeshObstacles(random, dimension, 1.0, 0.0), dimension);
            case CELLS:
                return std::make_shared<CellObstacles>(0.5, randomCells(random, dimension, 6), dimension);
            case CLOUD:
                return std::make_shared<PointCloudObstacles>(randomPoints(random, dimension, 100, 3.0),
                                                             randomRadii(random, 100, 0.2), dimension);
            default:
                return std::make_shared<MixedObstacles>(
                    std::vector<ObstaclesPtr>{obstaclesOfKind(random, PRIMITIVES, dimension),
                                              obstaclesOfKind(random, CELLS + random.below(2), dimension)});
        }
    }

    /** A pose at which no point of a body is farther than \e distance from where it is at \e pose; mostly one is that
        far */
    Pose moved(Random &random, const Body &body, const Pose &pose, double distance)
    {
        const unsigned int dimension = body.getDimension();
        const double turn = random.chance(0.5) ? random.uniform(0.0, 1.0) : 0.0,
                     radius = std::max(body.getBoundingRadius(), 0.5 * distance);
        const double angle = 2.0 * std::asin(std::min(1.0, 0.5 * turn * distance / radius));
        const Eigen::Vector3d axis = dimension == 2 ? Eigen::Vector3d::UnitZ() : random.direction(3);
        Pose other = pose;
        other.linear() = Eigen::AngleAxisd(random.sign() * angle, axis).toRotationMatrix() * pose.linear();
        other.translation() += 0.999999 * (1.0 - turn) * distance * random.direction(dimension);
        return other;
    }
}

TEST(StaysFree, IsTrueOfNoBodyThatCanCollide)
{
    for (unsigned int kind = 0; kind < KINDS; ++kind)
    {
        unsigned int poses = 0, free = 0, movesThatCollide = 0;
        for (unsigned int seed = 1; seed <= scaled(40); ++seed)
        {
            SCOPED_TRACE("kind " + std::to_string(kind) + ", seed " + std::to_string(seed));
            Random random(seed);
            const unsigned int dimension = 2 + seed % 2;
            const ObstaclesPtr obstacles = obstaclesOfKind(random, kind, dimension);
            for (unsigned int i = 0; i < 40; ++i)
            {
                const Body body = bodyAmongCells(random, dimension, 0.4);
                const Pose pose = random.pose(dimension, 3.5);
                const double distance = random.logUniform(1e-4, 1.0);
                const bool stays = obstacles->staysFree(body, pose, distance);
                poses += obstacles->collides(body, pose) ? 0 : 1;
                free += stays ? 1 : 0;
                for (unsigned int k = 0; k < 20; ++k)
                {
                    const Pose other = moved(random, body, pose, distance);
                    const bool collides = obstacles->collides(body, other);
                    movesThatCollide += collides ? 1 : 0;
                    ASSERT_FALSE(stays && collides) << "body " << i << " moves by " << distance;
                }
            }
        }
        // In the plane, meshes near primitives are left out.
        EXPECT_GT(free, poses / 2) << "kind " << kind;
        EXPECT_GT(movesThatCollide, 0U) << "kind " << kind;
    }
}

TEST(StaysFree, SeesTheGapBelowAFlatBody)
{
    const FclObstacles floor({{Body::box(6.0, 6.0, 0.1), poseAt({0.0, 0.0, -0.05})}}, 3);
    for (const Body &plate :
         {Body::box(1.0, 1.0, 0.05), Body::cylinder(0.5, 0.05), meshBody(3, boxMesh({1.0, 1.0, 0.05}))})
    {
        EXPECT_TRUE(floor.staysFree(plate, poseAt({0.0, 0.0, 0.0255}), 1e-4));
        EXPECT_TRUE(floor.staysFree(plate, poseAt({0.0, 0.0, 0.035}), 5e-3));
        EXPECT_FALSE(floor.staysFree(plate, poseAt({0.0, 0.0, 0.035}), 1.1e-2));
    }
}

TEST(StaysFree, IsFalseOfWhatIsNoNumber)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Body body = Body::sphere(0.2);
    const Pose pose = poseAt({0.0, 0.0, 50.0});
    for (unsigned int kind = 0; kind < KINDS; ++kind)
    {
        SCOPED_TRACE("kind " + std::to_string(kind));
        Random random(1);
        const ObstaclesPtr obstacles = obstaclesOfKind(random, kind, 3);
        EXPECT_TRUE(obstacles->staysFree(body, pose, 1.0));
        EXPECT_FALSE(obstacles->staysFree(body, pose, nan));
        EXPECT_FALSE(obstacles->staysFree(body, poseAt({0.0, nan, 0.0}), 1.0));
    }
}

namespace
{
    /** Obstacles of a user's own that know gaps, and nothing of staysFree() */
    class WithGap : public ForwardingObstacles
    {
    public:
        using ForwardingObstacles::ForwardingObstacles;

        double gap(const Body &body, const Pose &pose, double needed, double wanted) const override
        {
            return obstacles_->gap(body, pose, needed, wanted);
        }
    };
}

TEST(StaysFree, IsToldByTheGapUnlessObstaclesKnowMore)
{
    const Body bar = Body::box(2.0, 0.1, 0.1);
    const ObstaclesPtr floors[] = {
        std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(10.0, 10.0, 0.1), poseAt({0.0, 0.0, -0.05})}},
                                       3),
        std::make_shared<CellObstacles>(0.1, std::vector<CellBox>{{{-50, -50, -1}, {50, 50, 0}}}, 3)};
    for (const ObstaclesPtr &floor : floors)
    {
        const WithGap obstacles(floor);
        EXPECT_TRUE(obstacles.staysFree(bar, poseAt({0.0, 0.0, 0.55}), 0.1));
        EXPECT_TRUE(obstacles.staysFree(bar, poseAt({0.0, 0.0, 0.08}), 0.02));
        EXPECT_FALSE(obstacles.staysFree(bar, poseAt({0.0, 0.0, 0.08}), 0.04));
    }
}
