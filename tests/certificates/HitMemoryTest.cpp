#include "support/Random.h"

#include "certificates/HitMemory.h"

#include <gtest/gtest.h>
#include <memory>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

TEST(HitMemory, KnowsNothingAtFirstAndAfterClear)
{
    const auto memory = std::make_unique<HitMemory>();
    const Ball ball{{1.0, 2.0, 3.0}, 0.5};
    EXPECT_EQ(memory->find(ball), NO_PART);
    memory->note(ball, 7);
    EXPECT_EQ(memory->find(ball), 7U);
    memory->clear();
    EXPECT_EQ(memory->find(ball), NO_PART);
}

TEST(HitMemory, FindsThePartThatWasHitNearby)
{
    for (unsigned int seed = 0; seed < scaled(1000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto memory = std::make_unique<HitMemory>();
        const double radius = random.logUniform(1e-6, 1e6);
        const Ball ball{random.point(3, 1000.0 * radius), radius};
        memory->note(ball, 7);
        // Not all of them are in the same cell, but the next ones are nearby.
        unsigned int found = 0;
        for (int i = 0; i < 200; ++i)
            found += memory->find({ball.center + random.point(3, 0.5 * radius), radius}) == 7U ? 1 : 0;
        EXPECT_GT(found, 10U);
        EXPECT_EQ(memory->find({ball.center + Eigen::Vector3d::Constant(100.0 * radius), radius}), NO_PART);
    }
}

TEST(HitMemory, PrefersTheLatestAndTheNearest)
{
    const auto memory = std::make_unique<HitMemory>();
    // Both in one coarse cell, in different fine ones
    const Ball first{{0.1, 0.1, 0.1}, 1.0}, second{{1.6, 1.6, 1.6}, 1.0}, third{{0.1, 1.6, 0.1}, 1.0};
    memory->note(first, 1);
    memory->note(second, 2);
    EXPECT_EQ(memory->find(first), 1U);
    EXPECT_EQ(memory->find(second), 2U);
    EXPECT_EQ(memory->find(third), 2U);
    memory->note(first, 3);
    EXPECT_EQ(memory->find(first), 3U);
}
