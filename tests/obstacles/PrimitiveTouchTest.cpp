#include "support/MeshObstacles.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    double marginOf(const FclObstacles &obstacles, const Body &body)
    {
        return obstacles.getTolerance() + exactCheckTolerance(body.getBoundingRadius());
    }

    Body randomBodyOrMesh(Random &random, unsigned int dimension, double size, bool mesh)
    {
        return mesh ? meshBody(dimension, randomMesh(random, size)) : randomBody(random, dimension, size);
    }

    /** How often the answers were NO, UNKNOWN and YES */
    struct Answers
    {
        unsigned int counts[3] = {};
        unsigned int all{0};

        unsigned int &operator[](Touching answer)
        {
            return counts[static_cast<int>(answer)];
        }

        /** Compares the contact test with the exact check at a pose */
        void add(const FclObstacles &obstacles, const Body &body, const Pose &pose)
        {
            const bool collides = obstacles.collides(body, pose);
            ObstaclePart hit = NO_PART;
            const Touching answer = obstacles.touches(body, pose, &hit);
            ASSERT_NE(answer, collides ? Touching::NO : Touching::YES) << pose.matrix();
            if (answer == Touching::YES)
            {
                ASSERT_NE(hit, NO_PART);
                ASSERT_TRUE(obstacles.certainlyHits(body, pose, hit));
            }
            for (ObstaclePart part = 0; part < 30; ++part)
                ASSERT_TRUE(collides || !obstacles.certainlyHits(body, pose, part)) << pose.matrix();
            ++(*this)[answer];
            ++all;
        }
    };

    /** Moves a body along a line to where the exact check's verdict changes, and compares the tests around it. */
    void compareAround(Random &random, const FclObstacles &obstacles, const Body &body, double unit, Answers &answers)
    {
        Pose pose = nearPose(random, obstacles, body, unit);
        const Eigen::Vector3d start = pose.translation();
        const unsigned int dimension = body.getDimension();
        const Eigen::Vector3d along = random.chance(0.5)
                                          ? Eigen::Vector3d(Eigen::Vector3d::Unit(random.below(dimension)))
                                          : random.direction(dimension);
        const auto move = [&](double t) { pose.translation() = start + t * along; };
        const auto at = [&](double t)
        {
            move(t);
            return obstacles.collides(body, pose);
        };
        double low = 0.0, high = 1e-3 * unit;
        const bool first = at(low);
        while (at(high) == first && high < 8.0 * unit)
            high *= 2.0;
        const double margin = marginOf(obstacles, body);
        while (high - low > 0.01 * margin)
        {
            const double middle = 0.5 * (low + high);
            (at(middle) == first ? low : high) = middle;
        }
        for (int i = -12; i <= 12; ++i)
        {
            move(low + 0.25 * i * margin);
            ASSERT_NO_FATAL_FAILURE(answers.add(obstacles, body, pose));
        }
    }
}

class PrimitiveTouch : public testing::TestWithParam<unsigned int>
{
};

TEST_P(PrimitiveTouch, NeverSaysWhatTheExactCheckDenies)
{
    Answers answers;
    for (unsigned int seed = 0; seed < scaled(600); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double unit = std::pow(10.0, random.below(7)) * 1e-3;
        const FclObstacles obstacles(randomMeshObstacles(random, GetParam(), unit, random.chance(0.5) ? 1.0 : 0.5),
                                     GetParam());
        const double size = unit * random.logUniform(0.01, 3.0);
        const Body body = randomBodyOrMesh(random, GetParam(), size, random.chance(0.5));
        for (int i = 0; i < 40; ++i)
            ASSERT_NO_FATAL_FAILURE(
                answers.add(obstacles, body, nearPose(random, obstacles, body, std::max(size, 0.1 * unit))));
        ASSERT_NO_FATAL_FAILURE(compareAround(random, obstacles, body, std::max(size, 0.1 * unit), answers));
    }
    EXPECT_GT(answers[Touching::YES], answers.all / 10);
    EXPECT_GT(answers[Touching::NO], answers.all / 10);
}

INSTANTIATE_TEST_SUITE_P(Dimension, PrimitiveTouch, testing::Values(2U, 3U));

// Faces upon faces, edges upon edges, and gaps of a few margins, near the origin and far away.
TEST(PrimitiveTouch, AgreesOnThingsThatAreLevel)
{
    Answers answers;
    for (unsigned int seed = 0; seed < scaled(3000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double unit = std::pow(10.0, random.below(6)) * 1e-2;
        const Eigen::Vector3d obstacleSize =
            unit * Eigen::Vector3d(extentOf(random), extentOf(random), extentOf(random));
        const Eigen::Vector3d size = unit * Eigen::Vector3d(extentOf(random), extentOf(random), extentOf(random));
        const auto make = [&](const Eigen::Vector3d &extents, unsigned int kind)
        {
            std::vector<Eigen::Vector3d> corners;
            for (unsigned int i = 0; i < 8; ++i)
                corners.emplace_back(
                    extents.cwiseProduct(Eigen::Vector3d(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5)));
            return kind == 0   ? Body::mesh(boxMesh(extents))
                   : kind == 1 ? Body::box(extents.x(), extents.y(), extents.z())
                   : kind == 2 ? Body::cylinder(0.5 * extents.x(), extents.z())
                   : kind == 3 ? Body::capsule(0.5 * extents.x(), extents.z())
                               : Body::convexPolytope(corners);
        };
        const unsigned int kind = random.below(5), obstacleKind = kind == 0 ? 1 + random.below(4) : random.below(5);
        const Eigen::Vector3d center = random.chance(0.5) ? Eigen::Vector3d::Zero().eval() : random.point(3, 1e3);
        const FclObstacles obstacles({{make(obstacleSize, obstacleKind), poseAt(center)}}, 3);
        const Body body = make(size, kind);
        for (int i = 0; i < 30; ++i)
        {
            Eigen::Vector3d apart;
            for (auto &coordinate : apart)
                coordinate = 0.5 * random.sign() * random.below(2);
            Pose pose = poseAt(center + apart.cwiseProduct(obstacleSize + random.sign() * size) +
                               marginOf(obstacles, body) * random.point(3, 3.0));
            if (random.chance(0.3))
                pose.linear() = Eigen::AngleAxisd(random.chance(0.5) ? 0.5 * M_PI : random.logUniform(1e-9, 1e-2),
                                                  Eigen::Vector3d::Unit(random.below(3)))
                                    .toRotationMatrix();
            ASSERT_NO_FATAL_FAILURE(answers.add(obstacles, body, pose)) << kind << " at " << obstacleKind;
        }
    }
    EXPECT_GT(answers[Touching::YES], answers.all / 20);
    EXPECT_GT(answers[Touching::NO], answers.all / 20);
}

TEST(PrimitiveTouch, KnowsAlmostAllRandomPoses)
{
    for (unsigned int kind = 0; kind < 5; ++kind)
    {
        SCOPED_TRACE("kind " + std::to_string(kind));
        std::vector<PlacedBody> bodies;
        Random random(kind);
        // More than a block of each kind
        for (int i = 0; i < 12; ++i)
        {
            const Body body = kind == 0   ? Body::sphere(1.0)
                              : kind == 1 ? Body::box(1.0, 2.0, 3.0)
                              : kind == 2 ? Body::capsule(0.5, 2.0)
                              : kind == 3 ? Body::cylinder(0.5, 2.0)
                                          : Body({{randomPolytope(random, 3, 3.0), Pose::Identity()}});
            bodies.push_back({body, random.pose(3, 8.0)});
        }
        const FclObstacles obstacles(bodies, 3);
        Answers answers;
        for (const Body &body : {Body::mesh(boxMesh({2, 1, 1})), Body::mesh(ballMesh(20, 1.0)),
                                 Body::box(2.0, 1.0, 1.0), Body::sphere(1.0), Body::capsule(0.3, 2.0)})
            for (int i = 0; i < 500; ++i)
                ASSERT_NO_FATAL_FAILURE(answers.add(obstacles, body, random.pose(3, 8.0)));
        EXPECT_LT(answers[Touching::UNKNOWN], 5U);
        EXPECT_GT(answers[Touching::YES], 50U);
        EXPECT_GT(answers[Touching::NO], 500U);
    }
}
