#include "ompl_certificates/validity/WorldLock.h"

#include "ThreadNumber.h"

#include <ompl/util/Exception.h>
#include <thread>

namespace ompl_certificates
{
    WorldLock::Slot &WorldLock::slotOfThisThread()
    {
        return slots_[threadNumber() % SLOTS];
    }

    WorldLock::Check *&WorldLock::innermost()
    {
        thread_local Check *check = nullptr;
        return check;
    }

    WorldLock::Check *WorldLock::find()
    {
        for (Check *check = innermost(); check != nullptr; check = check->outer_)
            if (&check->lock_ == this)
                return check;
        return nullptr;
    }

    WorldLock::Check::Check(WorldLock &lock) : lock_(lock), outer_(innermost()), counts_(lock.find() == nullptr)
    {
        if (counts_)
        {
            // First in, then a look whether a change has begun; a change first says so, then looks who is in.
            std::atomic<int> &checks = lock_.slotOfThisThread().checks;
            for (checks.fetch_add(1); lock_.changing_.load(); checks.fetch_add(1))
            {
                checks.fetch_sub(1);
                const std::lock_guard<std::mutex> wait(lock_.mutex_);
            }
        }
        innermost() = this;
    }

    WorldLock::Check::~Check()
    {
        Check **link = &innermost();
        while (*link != this)
            link = &(*link)->outer_;
        *link = outer_;
        if (!counts_)
            return;
        if (Check *const other = lock_.find())
            other->counts_ = true;
        else
            lock_.slotOfThisThread().checks.fetch_sub(1, std::memory_order_release);
    }

    WorldLock::Change::Change(WorldLock &lock) : lock_(lock)
    {
        if (lock_.find() != nullptr)
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
