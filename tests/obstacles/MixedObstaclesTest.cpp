#include "support/MeshObstacles.h"
#include "support/RandomStates.h"

#include "ompl_certificates/obstacles/CellObstacles.h"
#include "ompl_certificates/obstacles/CheckObstacles.h"
#include "ompl_certificates/obstacles/MixedObstacles.h"
#include "ompl_certificates/obstacles/PointCloudSet.h"
#include "ompl_certificates/obstacles/ObstacleSet.h"

#include <gtest/gtest.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** FCL's obstacles with answers of one's own */
    class Odd : public FclObstacles
    {
    public:
        Odd() : FclObstacles({{Body::sphere(1.0)}}, 3)
        {
        }

        bool knowsPadding() const override
        {
            return false;
        }

        bool provesCollisions() const override
        {
            return false;
        }

        double getTolerance() const override
        {
            return 0.5;
        }

        std::uint64_t getFingerprint() const override
        {
            return 0;
        }
    };

    std::vector<ObstaclesPtr> inParts(const std::vector<PlacedBody> &bodies, unsigned int dimension, std::size_t count)
    {
        std::vector<ObstaclesPtr> members;
        for (std::size_t i = 0; i < count; ++i)
        {
            std::vector<PlacedBody> some;
            for (std::size_t k = i; k < bodies.size(); k += count)
                some.push_back(bodies[k]);
            members.push_back(std::make_shared<FclObstacles>(some, dimension));
        }
        return members;
    }
}

TEST(MixedObstacles, AnswerLikeAllOfThemInOne)
{
    unsigned int hits = 0, touching = 0;
    for (unsigned int seed = 1; seed <= scaled(24); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        const auto bodies = randomMeshObstacles(random, dimension, 1.0, 0.7);
        const FclObstacles all(bodies, dimension);
        const MixedObstacles mixed(inParts(bodies, dimension, 1 + seed % 3));
        for (int i = 0; i < 50; ++i)
        {
            const Eigen::Vector3d point = random.point(dimension, 4.0);
            ASSERT_NEAR(mixed.clearance(point), all.clearance(point), 1e-12);
            ObstaclePart nearest;
            ASSERT_EQ(mixed.findNearest(point, nearest), mixed.clearance(point));

            const Body body = randomBody(random, dimension, 1.0);
            const Pose pose = nearPose(random, all, body, 1.0);
            const bool collides = mixed.collides(body, pose);
            // Where they just touch, FCL's tolerance depends on what else there is.
            const Touching expected = all.touches(body, pose);
            if (expected != Touching::UNKNOWN)
            {
                ASSERT_EQ(collides, expected == Touching::YES);
            }
            ObstaclePart hit = NO_PART;
            const Touching answer = mixed.touches(body, pose, &hit);
            ASSERT_NE(answer, collides ? Touching::NO : Touching::YES);
            ASSERT_FALSE(mixed.certainlyHits(body, pose, NO_PART));
            for (const ObstaclePart part : {hit, nearest})
                ASSERT_TRUE(collides || !mixed.certainlyHits(body, pose, part));
            touching += answer == Touching::YES;
            hits += answer == Touching::YES && mixed.certainlyHits(body, pose, hit);
        }
    }
    EXPECT_GT(touching, 0U);
    EXPECT_EQ(hits, touching);
}

TEST(MixedObstacles, KeepTheContract)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(3);
    for (unsigned int seed = 1; seed <= scaled(6); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        std::vector<PlacedBody> bodies;
        for (int i = 0; i < 12; ++i)
            bodies.push_back({randomBody(random, dimension, 1.0), random.pose(dimension, 4.0)});
        const MixedObstacles mixed(inParts(bodies, dimension, 3));
        EXPECT_TRUE(mixed.hasGap());
        checkObstacles(mixed, {randomBody(random, dimension, 1.0), randomMeshBody(random, dimension, 1.0)},
                       cubeBounds(dimension, 5.0), 300);
    }
}

TEST(MixedObstacles, PromiseNoMoreThanEachOfThem)
{
    const auto box = std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(1.0, 1.0, 1.0)}}, 3);
    const auto odd = std::make_shared<Odd>();
    const MixedObstacles boxes({box, box}), both({box, odd}), reversed({odd, box});
    EXPECT_TRUE(boxes.provesCollisions());
    EXPECT_TRUE(boxes.knowsPadding());
    EXPECT_EQ(boxes.getTolerance(), box->getTolerance());
    for (const MixedObstacles &mixed : {both, reversed})
    {
        EXPECT_FALSE(mixed.provesCollisions());
        EXPECT_FALSE(mixed.knowsPadding());
        EXPECT_EQ(mixed.getTolerance(), 0.5);
    }
    EXPECT_TRUE(boxes.isClearanceCheap());
    EXPECT_NE(boxes.getFingerprint(), 0U);
    EXPECT_NE(boxes.getFingerprint(), MixedObstacles({box}).getFingerprint());
    EXPECT_EQ(both.getFingerprint(), 0U);
    // Cells of one grid are not those of another.
    const std::vector<CellBox> some{{{3, 4, 5}, {4, 5, 6}}}, others{{{7, 8, 9}, {9, 9, 10}}};
    const auto grid = [](const std::vector<CellBox> &cells, double origin)
    { return std::make_shared<CellObstacles>(0.5, cells, 3, Eigen::Vector3d(origin, 0.0, 0.0)); };
    EXPECT_NE(MixedObstacles({grid(some, 0.0), grid(others, 10.0)}).getFingerprint(),
              MixedObstacles({grid(others, 0.0), grid(some, 10.0)}).getFingerprint());

    const std::vector<PlacedBody> none;
    const auto low = std::make_shared<FclObstacles>(none, 2, ZInterval{0.0, 2.0});
    const auto high = std::make_shared<FclObstacles>(none, 2, ZInterval{1.0, 3.0});
    const ZInterval common = MixedObstacles({low, high}).getZInterval();
    EXPECT_EQ(common.low, 1.0);
    EXPECT_EQ(common.high, 2.0);
}

TEST(MixedObstacles, ChangeAsTheirMembersDo)
{
    ObstacleSet shapes(3);
    PointCloudSet points(0.1);
    const ObstacleSet::Id box = shapes.add({Body::box(1.0, 1.0, 1.0)});
    points.insert({Eigen::Vector3d(5.0, 0.0, 0.0)});
    const ObstacleChange first = mixedChange({shapes.takeChange(), points.takeChange()});
    EXPECT_NEAR(first.after->clearance({3.0, 0.0, 0.0}), 1.9, 1e-12);
    EXPECT_NEAR(first.added->clearance({2.0, 0.0, 0.0}), 1.5, 1e-12);
    EXPECT_FALSE(first.removed);
    // What a revalidation looks at, of each member
    EXPECT_NEAR(addedBy(first)->clearance({2.0, 0.0, 0.0}), 1.5, 1e-12);
    EXPECT_NEAR(addedBy(first)->clearance({4.0, 0.0, 0.0}), 0.9, 1e-12);

    shapes.remove(box);
    const ObstacleChange second = mixedChange({shapes.takeChange(), points.takeChange()});
    EXPECT_NEAR(second.after->clearance({2.0, 0.0, 0.0}), 2.9, 1e-12);
    EXPECT_FALSE(second.added);
    EXPECT_FALSE(addedBy(second));
    EXPECT_NEAR(second.removed->clearance({2.0, 0.0, 0.0}), 1.5, 1e-12);

    const ObstacleChange none = mixedChange({shapes.takeChange(), points.takeChange()});
    EXPECT_FALSE(none.added || none.removed);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(none.members[i].after, second.members[i].after);
    EXPECT_THROW(mixedChange({}), ompl::Exception);
    EXPECT_THROW(mixedChange({none, ObstacleChange()}), ompl::Exception);
}

TEST(MixedObstacles, RefuseWhatDoesNotFit)
{
    const std::vector<PlacedBody> none;
    const auto planar = std::make_shared<FclObstacles>(none, 2), spatial = std::make_shared<FclObstacles>(none, 3);
    EXPECT_THROW(MixedObstacles({}), ompl::Exception);
    EXPECT_THROW(MixedObstacles({planar, nullptr}), ompl::Exception);
    EXPECT_THROW(MixedObstacles({planar, spatial}), ompl::Exception);
}
