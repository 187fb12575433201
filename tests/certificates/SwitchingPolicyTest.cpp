#include "certificates/SwitchingPolicy.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;

namespace
{
    using std::chrono::microseconds;

    /** The costs of the steps that settle a pose, and how many of a thousand poses clearances settle */
    struct Costs
    {
        microseconds clearances{0};
        unsigned int settledByClearances{0};
        microseconds exact{0};

        /** The cost of the exact check of those poses that clearances settle */
        microseconds exactWhereClear{exact};

        /** The number of samples that a proof settles */
        double samples{1.0};
    };

    /** The number of poses for which clearances are asked */
    unsigned int settle(SwitchingPolicy &policy, unsigned int poses, const Costs &costs)
    {
        unsigned int tried = 0, luck = 0;
        for (unsigned int i = 0; i < poses; ++i)
        {
            luck = (luck + 617) % 1000;
            const bool timed = policy.isTimed();
            const bool asks = policy.asksClearances(timed);
            tried += asks ? 1 : 0;
            const bool clear = luck < costs.settledByClearances;
            if (asks && timed)
                policy.noteClearances(costs.clearances, clear ? costs.samples : 0.0);
            if (timed && !(asks && clear))
                policy.noteExact(asks, clear ? costs.exactWhereClear : costs.exact);
        }
        return tried;
    }

    Costs clearancesOf(unsigned int cost, unsigned int settledPerThousand, unsigned int exact)
    {
        Costs costs;
        costs.clearances = microseconds(cost);
        costs.settledByClearances = settledPerThousand;
        costs.exact = costs.exactWhereClear = microseconds(exact);
        return costs;
    }
}

TEST(SwitchingPolicy, LooksUpAtFirst)
{
    SwitchingPolicy policy;
    for (int i = 0; i < 100; ++i)
        EXPECT_TRUE(policy.looksUp());
}

TEST(SwitchingPolicy, LooksUpNowAndThenWhereThatFailsAndAlwaysWhenItSucceedsAgain)
{
    SwitchingPolicy policy;
    for (int i = 0; i < 1000; ++i)
        policy.noteLookup(false);
    unsigned int lookups = 0;
    for (int i = 0; i < 1600; ++i)
        lookups += policy.looksUp() ? 1 : 0;
    EXPECT_EQ(lookups, 100U);
    for (int i = 0; i < 1000; ++i)
        policy.noteLookup(true);
    for (int i = 0; i < 100; ++i)
        EXPECT_TRUE(policy.looksUp());
}

TEST(SwitchingPolicy, AsksClearancesWhereTheySaveMoreThanTheyCost)
{
    SwitchingPolicy policy;
    settle(policy, 1000, clearancesOf(2, 500, 20));
    EXPECT_GT(settle(policy, 10000, clearancesOf(2, 500, 20)), 9800U);
}

TEST(SwitchingPolicy, StepsAsideWhereClearancesCostMoreThanTheySaveAndReturns)
{
    SwitchingPolicy policy;
    settle(policy, 1000, clearancesOf(10, 200, 10));
    const unsigned int tried = settle(policy, 10000, clearancesOf(10, 200, 10));
    EXPECT_LT(tried, 200U);
    EXPECT_GT(tried, 20U) << "it would not notice that they pay again";
    settle(policy, 40000, clearancesOf(1, 900, 20));
    EXPECT_GT(settle(policy, 10000, clearancesOf(1, 900, 20)), 9800U);
}

TEST(SwitchingPolicy, KnowsThatAProofSavesTheNextSamplesToo)
{
    SwitchingPolicy alone, lasting;
    Costs costs = clearancesOf(10, 500, 1);
    settle(alone, 1000, costs);
    EXPECT_LT(settle(alone, 10000, costs), 200U);
    costs.samples = 40.0;
    settle(lasting, 1000, costs);
    EXPECT_GT(settle(lasting, 10000, costs), 9800U);
}

TEST(SwitchingPolicy, KnowsThatClearancesSettleWhatIsQuicklyCheckedToo)
{
    SwitchingPolicy policy;
    Costs costs = clearancesOf(30, 500, 40);
    costs.exactWhereClear = microseconds(2);
    settle(policy, 1000, costs);
    EXPECT_LT(settle(policy, 10000, costs), 200U);
}

TEST(SwitchingPolicy, TriesWhatCostsMuchMoreSeldom)
{
    SwitchingPolicy policy;
    settle(policy, 1000, clearancesOf(1, 1000, 1000));
    // The way without clearances is a thousand times as expensive.
    EXPECT_GE(settle(policy, 100000, clearancesOf(1, 1000, 1000)), 99990U);
}

TEST(SwitchingPolicy, DoesNotCountWhatTheFirstPosePaysForAll)
{
    SwitchingPolicy policy;
    EXPECT_TRUE(policy.asksClearances(false));
    policy.noteClearances(std::chrono::seconds(1), 0.0);
    policy.noteExact(true, std::chrono::seconds(1));
    settle(policy, 1000, clearancesOf(2, 500, 20));
    EXPECT_GT(settle(policy, 1000, clearancesOf(2, 500, 20)), 950U);
}

TEST(SwitchingPolicy, IsNotMisledForLongByAnotherProgramsTurn)
{
    SwitchingPolicy policy;
    settle(policy, 1000, clearancesOf(2, 500, 20));
    policy.noteClearances(std::chrono::seconds(1), 1.0);
    policy.noteExact(policy.asksClearances(false), std::chrono::seconds(1));
    EXPECT_GT(settle(policy, 10000, clearancesOf(2, 500, 20)), 9000U);
}

TEST(SwitchingPolicies, LearnOfMotionsNothingFromPosesAlone)
{
    SwitchingPolicies policies;
    settle(policies.of(0.0), 1000, clearancesOf(10, 100, 5));
    EXPECT_FALSE(policies.of(0.0).asksClearances(false));
    EXPECT_TRUE(policies.of(12.0).asksClearances(false));
    settle(policies.of(0.5), 1000, clearancesOf(10, 100, 5));
    EXPECT_FALSE(policies.of(12.0).asksClearances(false));
    policies.reset();
    EXPECT_TRUE(policies.of(0.0).asksClearances(false));
    EXPECT_TRUE(policies.of(12.0).asksClearances(false));
}

TEST(SwitchingPolicy, JudgesAnewAfterReset)
{
    SwitchingPolicy policy;
    settle(policy, 1000, clearancesOf(10, 100, 5));
    for (int i = 0; i < 1000; ++i)
        policy.noteLookup(false);
    EXPECT_FALSE(policy.asksClearances(false));
    policy.reset();
    EXPECT_TRUE(policy.looksUp());
    EXPECT_TRUE(policy.asksClearances(false));
}
