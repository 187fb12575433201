#ifndef OMPL_CERTIFICATES_VALIDITY_WORLD_LOCK_
#define OMPL_CERTIFICATES_VALIDITY_WORLD_LOCK_

#include <array>
#include <atomic>
#include <mutex>

namespace ompl_certificates
{
    /** \brief Lets any number of threads check at once, or one change the world.

        Checks enter and leave at places of their own, so that they do not wait for each other and seldom share a cache
        line: some 10 ns. A change waits until all that have begun are done, and those that come wait for it. */
    class WorldLock
    {
    public:
        WorldLock() = default;
        WorldLock(const WorldLock &) = delete;
        WorldLock &operator=(const WorldLock &) = delete;

        /** \brief A check, for as long as this lives: it must end in the thread in which it began. A thread may be in checks
            of several locks, several times, and leave them in any order. */
        class Check
        {
        public:
            explicit Check(WorldLock &lock);
            ~Check();

            Check(const Check &) = delete;
            Check &operator=(const Check &) = delete;

        private:
            friend class WorldLock;

            WorldLock &lock_;
            /** \brief What this thread entered before, and has not left */
            Check *outer_;
            /** \brief Whether this is the one check of its lock that stands for all of this thread */
            bool counts_;
        };

        /** \brief A change, for as long as this lives
            \throws ompl::Exception within a check of the same thread, which it would wait for in vain */
        class Change
        {
        public:
            explicit Change(WorldLock &lock);
            ~Change();

            Change(const Change &) = delete;
            Change &operator=(const Change &) = delete;

        private:
            WorldLock &lock_;
            std::unique_lock<std::mutex> guard_;
        };

    private:
        static constexpr std::size_t SLOTS = 16;

        struct alignas(64) Slot
        {
            std::atomic<int> checks{0};
        };

        Slot &slotOfThisThread();

        /** \brief The check that this thread entered last, and has not left */
        static Check *&innermost();

        /** \brief A check of this lock that this thread is in, or null */
        Check *find();

        std::array<Slot, SLOTS> slots_;
        std::atomic<bool> changing_{false};
        std::mutex mutex_;
    };
}

#endif
