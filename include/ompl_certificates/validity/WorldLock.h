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
            /** \brief Begin a check */
            explicit Check(WorldLock &lock);
            ~Check();

            Check(const Check &) = delete;
            Check &operator=(const Check &) = delete;

        private:
            /** \brief The one of \e lock among \e last and what was entered before it, or null */
            static Check *find(Check *last, const WorldLock &lock);

            friend class WorldLock;

            WorldLock &lock_;
            /** \brief Where this thread keeps what it entered last */
            Check *&last_;
            /** \brief What this thread entered before, and has not left */
            Check *outer_;
            /** \brief Where this counts for all checks of this thread and lock, if it is the one that does */
            std::atomic<int> *checks_;
        };

        /** \brief A change, for as long as this lives
            \throws ompl::Exception within a check of the same thread, which it would wait for in vain */
        class Change
        {
        public:
            /** \brief Begin a change, once all checks have ended */
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

        /** \brief The check that this thread entered last, and has not left */
        static Check *&lastOfThisThread();

        std::array<Slot, SLOTS> slots_;
        std::atomic<bool> changing_{false};
        std::mutex mutex_;
    };
}

#endif
