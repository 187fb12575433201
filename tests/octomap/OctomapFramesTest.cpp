// After each of many frames, however the map is edited, the set's obstacles are those of the map made anew.

#include "OctomapSetCase.h"
#include "RandomMaps.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    constexpr double FRAMES_CELL_SIZE = 0.25;

    class OctomapFrames : public OctomapSetTest
    {
    protected:
        void expectEquality(Random &random, const Obstacles &changed, const Obstacles &fresh) const
        {
            const bool isFlat = GetParam().slice.has_value();
            const Body body = isFlat ? Body::box(0.5, 0.25) : Body::box(0.5, 0.25, 0.75);
            for (int i = 0; i < 20; ++i)
            {
                const Eigen::Vector3d point = random.point(isFlat ? 2 : 3, 5.0);
                ASSERT_EQ(std::max(0.0, changed.clearance(point)), std::max(0.0, fresh.clearance(point)));
                Pose pose = Pose::Identity();
                pose.translation() = point;
                pose.rotate(Eigen::AngleAxisd(random.uniform(-3.0, 3.0), Eigen::Vector3d::UnitZ()));
                ASSERT_EQ(changed.collides(body, pose), fresh.collides(body, pose));
            }
        }
    };

    octomap::OcTreeKey randomKey(Random &random)
    {
        const auto part = [&random] { return static_cast<octomap::key_type>(32768 - 16 + random.below(32)); };
        return {part(), part(), part()};
    }

    /** Single cells, seen and set, at once or lazily; a cell may come and go within a frame */
    void updateCells(Random &random, octomap::OcTree &map)
    {
        const bool isLazy = random.chance(0.5);
        for (unsigned int i = random.below(60); i > 0; --i)
        {
            const octomap::OcTreeKey key = randomKey(random);
            if (random.chance(0.2))
                map.setNodeValue(key, random.chance(0.5) ? 2.0F : -1.0F, isLazy);
            else
                for (unsigned int times = 1 + random.below(3); times > 0; --times)
                    map.updateNode(key, random.chance(0.5), isLazy);
        }
        if (isLazy && random.chance(0.5))
            map.updateInnerOccupancy();
    }

    void nextFrame(Random &random, octomap::OcTree &map, OctomapSet &set)
    {
        if (random.chance(0.5))
            scan(random, map);
        if (random.chance(0.5))
            updateCells(random, map);
        if (random.chance(0.1))
            set.reread();
        if (random.chance(0.1))
            map.toMaxLikelihood();
        if (random.chance(0.1))
            map.expand();
        if (random.chance(0.3))
            map.prune();
    }
}

TEST_P(OctomapFrames, AreThoseOfTheMapMadeAnew)
{
    for (unsigned int seed = 1; seed <= scaled(10); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto map = randomMap(random, FRAMES_CELL_SIZE);
        OctomapSet set(*map, options());
        for (int frame = 0; frame < 30; ++frame)
        {
            SCOPED_TRACE("frame " + std::to_string(frame));
            const ObstacleChange change = set.takeChange();
            expectEquality(random, *change.after, OctomapObstacles(*map, options()));
            if (HasFatalFailure())
                return;
            nextFrame(random, *map, set);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Options, OctomapFrames,
                         testing::Values(OctomapSetCase{"whole", 16, {}}, OctomapSetCase{"coarse", 14, {}},
                                         OctomapSetCase{"slice", 16, ZInterval{-0.6, 0.9}},
                                         OctomapSetCase{"coarseSlice", 15, ZInterval{0.0, 0.5}},
                                         OctomapSetCase{"veryCoarseSlice", 13, ZInterval{-0.3, 0.1}}),
                         [](const auto &instance) { return std::string(instance.param.name); });
