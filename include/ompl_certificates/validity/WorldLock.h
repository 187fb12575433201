#ifndef OMPL_CERTIFICATES_VALIDITY_WORLD_LOCK_
#define OMPL_CERTIFICATES_VALIDITY_WORLD_LOCK_

#include <array>
#include <atomic>
#include <mutex>

namespace ompl_certificates
{
    /** \brief Lets any number of threads check at once, or one thread change the world.

        Threads enter checks at slots of their own, so they do not wait for each other and seldom share a cache line.
        Cost: some 10 ns. A change waits until all running checks are done; later checks wait for the change. A long
        change may let them in between its steps.

        A thread may also hold the world for several checks. While it does, checks of all threads may begin: they may be
        what the holder waits for, as a planner with threads of its own. Other holds wait for the change, from when it
        waits for the first until all its steps are done: what holds the world may do so for seconds. Changes one right
        after the other leave few gaps for holds. */
    class WorldLock
    {
    public:
        WorldLock() = default;
        WorldLock(const WorldLock &) = delete;
        WorldLock &operator=(const WorldLock &) = delete;

        /** \brief A check for the lifetime of this object. It must end in the thread in which it began. A thread may
            hold checks of several locks, several of each, and end them in any order. */
        class Check
        {
        public:
            /** \brief Why a check lasts. The first check of a thread and lock decides: a HELD one within a SINGLE one
                is as that, and may not wait for others. */
            enum Kind
            {
                /// It waits for no other check.
                SINGLE,
                /// It may wait for checks of other threads, which begin later.
                HELD
            };

            /** \brief Begin a check */
            explicit Check(WorldLock &lock, Kind kind = SINGLE);
            ~Check();

            Check(const Check &) = delete;
            Check &operator=(const Check &) = delete;

        private:
            /** \brief The check of \e lock among \e last and those entered before it, or null */
            static Check *find(Check *last, const WorldLock &lock);

            /** \brief Counts this hold once there is no change */
            void enterHold();

            /** \brief Adds one to \e count once no change bars checks */
            void enter(std::atomic<int> &count);

            friend class WorldLock;

            WorldLock &lock_;
            /** \brief The variable in which this thread keeps its last check */
            Check *&last_;
            /** \brief The check that this thread entered before and still holds */
            Check *outer_;
            /** \brief The counter for all checks of this thread and lock; null if another check counts for them */
            std::atomic<int> *checks_{nullptr};
            /** \brief The counter of holds, if this one counts there */
            std::atomic<int> *holds_{nullptr};
        };

        /** \brief A change for the lifetime of this object
            \throws ompl::Exception within a check of the same thread, for which it would wait forever */
        class Change
        {
        public:
            /** \brief Begin a change, once all holds have ended. Later holds and other changes wait until this one ends.
                Checks go on until close(). */
            explicit Change(WorldLock &lock);
            ~Change();

            Change(const Change &) = delete;
            Change &operator=(const Change &) = delete;

            /** \brief Lets checks begin, and waits until those that wait have begun. Holds and other changes still
                wait. */
            void open();

            /** \brief Goes on with the change alone, once all checks have ended */
            void close();

        private:
            WorldLock &lock_;
            /** \brief Keeps out other changes, and checks */
            std::unique_lock<std::mutex> changes_, checks_;
        };

    private:
        static constexpr std::size_t SLOTS = 16;

        struct alignas(64) Slot
        {
            std::atomic<int> checks{0};
        };

        /** \brief The check that this thread entered last and still holds */
        static Check *&lastOfThisThread();

        std::array<Slot, SLOTS> slots_;
        std::atomic<int> holds_{0};
        /** \brief Whether holds, and whether checks, wait for a change */
        std::atomic<bool> barsHolds_{false}, barsChecks_{false};
        /** \brief How many checks wait for a change */
        std::atomic<int> waiting_{0};
        /** \brief Held by a change, and while no checks may begin. Holds wait for the first, other checks for the
            second. */
        std::mutex changes_, mutex_;
    };
}

#endif
