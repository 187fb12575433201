#include "validity/ProvenTimes.h"

#include "support/Random.h"

#include <gtest/gtest.h>
#include <vector>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

TEST(ProvenTimes, KnowWhatWasAddedForThisMotion)
{
    ProvenTimes times;
    EXPECT_FALSE(times.find(1, 0.5));
    times.add(1, {0.2, 0.4});
    ASSERT_TRUE(times.find(1, 0.3));
    EXPECT_EQ(times.find(1, 0.3)->first, 0.2);
    EXPECT_FALSE(times.find(1, 0.5));
    EXPECT_FALSE(times.find(2, 0.3)) << "that is another motion";
    times.add(2, {0.6, 0.7});
    EXPECT_FALSE(times.find(2, 0.3));
    EXPECT_FALSE(times.find(1, 0.3)) << "only one motion is remembered";
}

TEST(ProvenTimes, UniteIntervalsThatOverlap)
{
    ProvenTimes times;
    times.add(1, {0.1, 0.2});
    times.add(1, {0.3, 0.4});
    times.add(1, {0.15, 0.35});
    ASSERT_TRUE(times.find(1, 0.25));
    EXPECT_EQ(times.find(1, 0.25)->first, 0.1);
    EXPECT_EQ(times.find(1, 0.25)->last, 0.4);
}

TEST(ProvenTimes, NeverKnowMoreThanWasAddedAndForgetTheShortest)
{
    for (unsigned int seed = 0; seed < scaled(500); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        ProvenTimes times;
        std::vector<ProvenTimes::Interval> added;
        for (int i = 0; i < 20; ++i)
        {
            const double first = random.uniform(0.0, 1.0), last = first + random.logUniform(0.001, 0.2);
            added.push_back({first, last});
            times.add(7, added.back());
            for (int k = 0; k < 20; ++k)
                if (const double time = random.uniform(0.0, 1.2); times.find(7, time))
                {
                    ASSERT_TRUE(std::any_of(added.begin(), added.end(),
                                            [time](const ProvenTimes::Interval &one)
                                            { return one.first <= time && time <= one.last; }));
                }
        }
    }
    ProvenTimes times;
    times.add(1, {0.0, 0.5});
    for (int i = 0; i < 30; ++i)
        times.add(1, {1.0 + i, 1.1 + i});
    EXPECT_TRUE(times.find(1, 0.25)) << "the longest is kept";
}
