#include "ompl_certificates/validity/WorldLock.h"

#include <atomic>
#include <chrono>
#include <future>
#include <gtest/gtest.h>
#include <memory>
#include <ompl/util/Exception.h>
#include <thread>

using namespace ompl_certificates;

namespace
{
    using Hold = std::unique_ptr<WorldLock::Check>;

    Hold hold(WorldLock &lock)
    {
        return std::make_unique<WorldLock::Check>(lock);
    }

    /** A change or a check, begun and ended in a thread of its own. A failing test may leave it waiting, so it keeps its
        lock. */
    template <typename Guard, typename... Arguments>
    std::future<void> inThread(const std::shared_ptr<WorldLock> &lock, Arguments... arguments)
    {
        std::promise<void> done;
        std::future<void> result = done.get_future();
        std::thread(
            [lock, arguments...](std::promise<void> promise)
            {
                {
                    const Guard guard(*lock, arguments...);
                }
                promise.set_value();
            },
            std::move(done))
            .detach();
        return result;
    }

    /** Alone, from its beginning to its end */
    struct WholeChange
    {
        explicit WholeChange(WorldLock &lock) : change(lock)
        {
            change.close();
        }

        WorldLock::Change change;
    };

    std::future<void> change(const std::shared_ptr<WorldLock> &lock)
    {
        return inThread<WholeChange>(lock);
    }

    bool isDone(const std::future<void> &future, std::chrono::milliseconds time)
    {
        return future.wait_for(time) == std::future_status::ready;
    }

    constexpr std::chrono::milliseconds A_MOMENT(50), VERY_LONG(20000);
}

TEST(WorldLock, IsEnteredAgainWhileAChangeWaits)
{
    const auto first = std::make_shared<WorldLock>(), second = std::make_shared<WorldLock>();
    std::promise<void> held, goOn, entered;
    std::future<void> isEntered = entered.get_future();
    std::thread(
        [&, first, second]
        {
            const Hold outer = hold(*first), other = hold(*second);
            held.set_value();
            goOn.get_future().wait();
            const Hold inner = hold(*first);
            entered.set_value();
        })
        .detach();
    held.get_future().wait();
    const auto changed = change(first);
    EXPECT_FALSE(isDone(changed, A_MOMENT));
    goOn.set_value();
    ASSERT_TRUE(isDone(isEntered, VERY_LONG)) << "the check waits for a change that waits for the check";
    EXPECT_TRUE(isDone(changed, VERY_LONG));
}

TEST(WorldLock, LetsOthersCheckForWhoHoldsItWhileAChangeWaits)
{
    const auto lock = std::make_shared<WorldLock>();
    auto held = std::make_unique<WorldLock::Check>(*lock, WorldLock::Check::HELD);
    const auto changed = change(lock);
    EXPECT_FALSE(isDone(changed, A_MOMENT));
    // A worker, whose check the holder waits for
    const auto isChecked = inThread<WorldLock::Check>(lock);
    ASSERT_TRUE(isDone(isChecked, VERY_LONG)) << "the check waits for a change that waits for who waits for the check";
    // Another hold waits for the change; otherwise holds could keep it waiting for ever.
    const auto isAlsoHeld = inThread<WorldLock::Check>(lock, WorldLock::Check::HELD);
    EXPECT_FALSE(isDone(isAlsoHeld, A_MOMENT));
    held.reset();
    EXPECT_TRUE(isDone(changed, VERY_LONG));
    EXPECT_TRUE(isDone(isAlsoHeld, VERY_LONG));
}

TEST(WorldLock, LetsChecksInBetweenTheStepsOfAChangeButNoHolds)
{
    const auto lock = std::make_shared<WorldLock>();
    auto changing = std::make_unique<WorldLock::Change>(*lock);
    const auto isHeld = inThread<WorldLock::Check>(lock, WorldLock::Check::HELD);
    EXPECT_TRUE(isDone(inThread<WorldLock::Check>(lock), VERY_LONG)) << "it begins beside the checks";
    EXPECT_FALSE(isDone(isHeld, A_MOMENT));
    for (int step = 0; step < 2; ++step)
    {
        changing->close();
        const auto isChecked = inThread<WorldLock::Check>(lock);
        EXPECT_FALSE(isDone(isChecked, A_MOMENT));
        changing->open();
        EXPECT_TRUE(isDone(isChecked, VERY_LONG));
        EXPECT_FALSE(isDone(isHeld, A_MOMENT));
    }
    changing.reset();
    EXPECT_TRUE(isDone(isHeld, VERY_LONG));
}

TEST(WorldLock, HoldsEndInAnyOrder)
{
    const auto lock = std::make_shared<WorldLock>();
    auto outer = std::make_unique<WorldLock::Check>(*lock, WorldLock::Check::HELD);
    auto inner = std::make_unique<WorldLock::Check>(*lock, WorldLock::Check::HELD);
    outer.reset();
    const auto changed = change(lock);
    EXPECT_FALSE(isDone(changed, A_MOMENT));
    // The change waits for the hold, not for the check within it, so it lets others check.
    ASSERT_TRUE(isDone(inThread<WorldLock::Check>(lock), VERY_LONG)) << "the hold ended with the outer check";
    inner.reset();
    EXPECT_TRUE(isDone(changed, VERY_LONG));
    EXPECT_NO_THROW(WholeChange{*lock});
}

TEST(WorldLock, RefusesChangesWithinAnyCheckOfTheThread)
{
    WorldLock first, second;
    Hold outer = hold(first), other = hold(second);
    EXPECT_THROW(WorldLock::Change{first}, ompl::Exception);
    EXPECT_THROW(WorldLock::Change{second}, ompl::Exception);
    outer.reset();
    EXPECT_NO_THROW(WholeChange{first});
    EXPECT_THROW(WorldLock::Change{second}, ompl::Exception);
}

TEST(WorldLock, IsLeftInAnyOrder)
{
    const auto first = std::make_shared<WorldLock>(), second = std::make_shared<WorldLock>();
    Hold outer = hold(*first), other = hold(*second), inner = hold(*first);
    outer.reset();
    const auto changed = change(first);
    EXPECT_FALSE(isDone(changed, A_MOMENT)) << "the inner check still goes on";
    inner.reset();
    ASSERT_TRUE(isDone(changed, VERY_LONG));
    EXPECT_FALSE(isDone(change(second), A_MOMENT));
    other.reset();

    // A finished check leaves nothing behind: the next one holds the lock again.
    const Hold again = hold(*first);
    EXPECT_FALSE(isDone(change(first), A_MOMENT));
}

/** A change may be followed by the next one at once, and that wait for a hold which waits for a check. */
TEST(WorldLock, LetsChecksInBetweenChangesForWhoHoldsIt)
{
    struct Shared
    {
        WorldLock lock;
        std::atomic<unsigned int> checks{0};
        std::atomic<unsigned int> holds{0};
        std::atomic<bool> end{false};
    };
    const auto shared = std::make_shared<Shared>();
    const auto repeat = [shared](const auto &work)
    {
        std::thread(
            [shared, work]
            {
                while (!shared->end)
                    work();
            })
            .detach();
    };
    for (int thread = 0; thread < 2; ++thread)
        repeat(
            [shared]
            {
                const WorldLock::Check check(shared->lock);
                ++shared->checks;
            });
    repeat([shared] { const WholeChange change(shared->lock); });
    repeat(
        [shared]
        {
            const WorldLock::Check check(shared->lock, WorldLock::Check::HELD);
            for (const unsigned int enough = shared->checks + 3; shared->checks < enough && !shared->end;)
                std::this_thread::yield();
            ++shared->holds;
        });
    // Changes that follow each other leave few gaps for holds, so their number depends on the machine.
    const auto begin = std::chrono::steady_clock::now();
    auto last = begin;
    for (unsigned int seen = 0; seen < 200 && last - begin < std::chrono::seconds(5);
         std::this_thread::sleep_for(A_MOMENT))
        if (const unsigned int holds = shared->holds; holds > seen)
        {
            seen = holds;
            last = std::chrono::steady_clock::now();
        }
        else
            ASSERT_LT(std::chrono::steady_clock::now() - last, VERY_LONG)
                << "a check waits for a change that waits for who waits for the check";
    shared->end = true;
}
