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
            bool waits = false;
            for (checks_->fetch_add(1); lock_.changing_.load(); checks_->fetch_add(1))
            {
                checks_->fetch_sub(1);
                if (!waits)
                    lock_.waiting_.fetch_add(1);
                waits = true;
                const std::lock_guard<std::mutex> wait(lock_.mutex_);
            }
            if (waits)
                lock_.waiting_.fetch_sub(1);
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
        changes_ = std::unique_lock<std::mutex>(lock_.changes_);
        close();
    }

    WorldLock::Change::~Change()
    {
        lock_.changing_.store(false);
    }

    void WorldLock::Change::open()
    {
        lock_.changing_.store(false);
        checks_.unlock();
        // Otherwise those that wait would find the change going on again when they wake.
        while (lock_.waiting_.load() != 0)
            std::this_thread::yield();
    }

    void WorldLock::Change::close()
    {
        checks_ = std::unique_lock<std::mutex>(lock_.mutex_);
        lock_.changing_.store(true);
        for (const Slot &slot : lock_.slots_)
            while (slot.checks.load() != 0)
                std::this_thread::yield();
    }
}
