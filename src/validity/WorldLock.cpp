#include "ompl_certificates/validity/WorldLock.h"

#include "ThreadNumber.h"

#include <ompl/util/Exception.h>
#include <thread>

namespace ompl_certificates
{
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

    WorldLock::Check::Check(WorldLock &lock) : lock_(lock), last_(lastOfThisThread()), outer_(last_), checks_(nullptr)
    {
        if (find(outer_, lock_) == nullptr)
        {
            // A check enters, then looks for a change. A change announces itself, then waits for checks to leave. So
            // one of them sees the other.
            checks_ = &lock_.slots_[threadNumber() % SLOTS].checks;
            for (checks_->fetch_add(1); lock_.changing_.load(); checks_->fetch_add(1))
            {
                checks_->fetch_sub(1);
                const std::lock_guard<std::mutex> wait(lock_.mutex_);
            }
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
            other->checks_ = checks_;
        else
            checks_->fetch_sub(1, std::memory_order_release);
    }

    WorldLock::Change::Change(WorldLock &lock) : lock_(lock)
    {
        if (Check::find(lastOfThisThread(), lock_) != nullptr)
            throw ompl::Exception("The obstacles cannot be changed from within a check");
        guard_ = std::unique_lock<std::mutex>(lock_.mutex_);
        lock_.changing_.store(true);
        for (const Slot &slot : lock_.slots_)
            while (slot.checks.load() != 0)
                std::this_thread::yield();
    }

    WorldLock::Change::~Change()
    {
        lock_.changing_.store(false);
    }
}
