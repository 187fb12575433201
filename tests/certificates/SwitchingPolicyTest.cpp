#include "ompl_certificates/certificates/SwitchingPolicy.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;

namespace
{
    /** Settle poses whose parts take so long, as the policy says; how many of them clearances were asked for */
    unsigned int settle(SwitchingPolicy &policy, unsigned int poses, std::chrono::microseconds clearances,
                        std::chrono::microseconds exact, unsigned int settledPerThousand, double samples = 1.0)
    {
        unsigned int asked = 0, luck = 0;
        for (unsigned int i = 0; i < poses; ++i)
        {
            const bool timed = policy.isTimed();
            luck = (luck + 617) % 1000;
            if (policy.asksClearances())
            {
                ++asked;
                const bool settled = luck < settledPerThousand;
                policy.noteClearances(settled ? samples : 0.0);
                if (timed)
                    policy.noteClearanceCost(clearances);
                if (settled)
                    continue;
            }
            if (timed)
                policy.noteExactCost(exact);
        }
        return asked;
    }

    using std::chrono::microseconds;
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
    EXPECT_EQ(settle(policy, 2000, microseconds(2), microseconds(20), 500), 2000U);
}

TEST(SwitchingPolicy, StepsAsideWhereClearancesCostMoreThanTheySaveAndReturns)
{
    SwitchingPolicy policy;
    settle(policy, 1000, microseconds(10), microseconds(10), 200);
    // One pose in sixteen goes on to be tried.
    EXPECT_EQ(settle(policy, 1600, microseconds(10), microseconds(10), 200), 100U);
    settle(policy, 4000, microseconds(1), microseconds(20), 900);
    EXPECT_EQ(settle(policy, 1000, microseconds(1), microseconds(20), 900), 1000U);
}

TEST(SwitchingPolicy, KnowsThatAProofSavesTheNextSamplesToo)
{
    SwitchingPolicy alone, lasting;
    settle(alone, 1000, microseconds(10), microseconds(1), 500);
    EXPECT_LT(settle(alone, 1600, microseconds(10), microseconds(1), 500), 200U);
    settle(lasting, 1000, microseconds(10), microseconds(1), 500, 40.0);
    EXPECT_EQ(settle(lasting, 1600, microseconds(10), microseconds(1), 500, 40.0), 1600U);
}

TEST(SwitchingPolicy, NeverStepsAsideWhereNoExactCheckIsNeeded)
{
    SwitchingPolicy policy;
    EXPECT_EQ(settle(policy, 500, microseconds(10), microseconds(0), 1000), 500U);
}

TEST(SwitchingPolicy, IsNotMisledByAnotherProgramsTurn)
{
    SwitchingPolicy policy;
    settle(policy, 1000, microseconds(2), microseconds(20), 500);
    policy.noteClearanceCost(std::chrono::seconds(1));
    EXPECT_EQ(settle(policy, 100, microseconds(2), microseconds(20), 500), 100U);
}

TEST(SwitchingPolicy, JudgesAnewAfterReset)
{
    SwitchingPolicy policy;
    settle(policy, 1000, microseconds(10), microseconds(5), 100);
    for (int i = 0; i < 1000; ++i)
        policy.noteLookup(false);
    policy.reset();
    EXPECT_TRUE(policy.looksUp());
    EXPECT_TRUE(policy.asksClearances());
}
