#include "ompl_certificates/validity/WorldLock.h"

#include "ThreadNumber.h"

#include <chrono>
#include <ompl/util/Exception.h>
#include <thread>

namespace ompl_certificates
{
    namespace
    {
        void waitForEndOf(const std::atomic<int> &checks)
        {
            // A check takes microseconds, but who holds the world may do so for seconds.
            constexpr int shortWait = 1000;
            for (int i = 0; checks.load() != 0; ++i)
                if (i < shortWait)
                    std::this_thread::yield();
                else
                    std::this_thread::sleep_for(std::chrono::microseconds(50));
        }

        /** Those who wait have to be woken, and where all cores are busy, a thread that only yields gets its own back
            after a whole time slice. One that has slept is preferred. */
        void waitForBeginningOf(const std::atomic<int> &waiting)
        {
            while (waiting.load() != 0)
                std::this_thread::sleep_for(std::chrono::microseconds(20));
        }
    }

    WorldLock::Check *&WorldLock::lastOfThisThread()
    {
        thread_local Check *last = nullptr;
        return last;
    }

    WorldLock::Check *WorldLock::Check::find(Check *last, const WorldLock &lock)
    {
        while (last != nullptr && &last->lock_ != &lock)
            last = last->outer_;
        return last;
    }

    void WorldLock::Check::enterHold()
    {
        // A check enters, then looks for a change. A change announces itself, then waits for checks to leave. So one of
        // them sees the other.
        for (lock_.holds_.fetch_add(1); lock_.barsHolds_.load(); lock_.holds_.fetch_add(1))
        {
            lock_.holds_.fetch_sub(1);
            const std::lock_guard<std::mutex> untilAllSteps(lock_.changes_);
        }
        holds_ = &lock_.holds_;
    }

    void WorldLock::Check::enter(std::atomic<int> &count)
    {
        bool waits = false;
        for (count.fetch_add(1); lock_.barsChecks_.load(); count.fetch_add(1))
        {
            count.fetch_sub(1);
            if (!waits)
                lock_.waiting_.fetch_add(1);
            waits = true;
            // The change that was seen may have ended without waiting for this check. The next one may wait for a hold,
            // which may wait for this check: it must not sleep then.
            if (!lock_.barsChecks_.load())
                continue;
            const std::lock_guard<std::mutex> untilThisStep(lock_.mutex_);
        }
        if (waits)
            lock_.waiting_.fetch_sub(1);
    }

    WorldLock::Check::Check(WorldLock &lock, Kind kind) : lock_(lock), last_(lastOfThisThread()), outer_(last_)
    {
        if (find(outer_, lock_) == nullptr)
        {
            if (kind == HELD)
                enterHold();
            checks_ = &lock_.slots_[threadNumber() % SLOTS].checks;
            enter(*checks_);
        }
        last_ = this;
    }

    WorldLock::Check::~Check()
    {
        Check **link = &last_;
        while (*link != this)
            link = &(*link)->outer_;
        *link = outer_;
        if (checks_ == nullptr)
            return;
        if (Check *const other = find(last_, lock_))
        {
            other->checks_ = checks_;
            other->holds_ = holds_;
            return;
        }
        checks_->fetch_sub(1, std::memory_order_release);
        if (holds_ != nullptr)
            holds_->fetch_sub(1, std::memory_order_release);
    }

    WorldLock::Change::Change(WorldLock &lock) : lock_(lock)
    {
        if (Check::find(lastOfThisThread(), lock_) != nullptr)
            throw ompl::Exception("Within a check neither obstacles nor certificates can be changed");
        changes_ = std::unique_lock<std::mutex>(lock_.changes_);
        lock_.barsHolds_.store(true);
        waitForEndOf(lock_.holds_);
    }

    WorldLock::Change::~Change()
    {
        if (checks_.owns_lock())
            open();
        lock_.barsHolds_.store(false);
    }

    void WorldLock::Change::open()
    {
        // Holds stay out: the change would wait for each of them.
        lock_.barsChecks_.store(false);
        checks_.unlock();
        // Otherwise those that wait would find the change going on again when they wake.
        waitForBeginningOf(lock_.waiting_);
    }

    void WorldLock::Change::close()
    {
        checks_ = std::unique_lock<std::mutex>(lock_.mutex_);
        lock_.barsChecks_.store(true);
        for (const Slot &slot : lock_.slots_)
            waitForEndOf(slot.checks);
    }
}
