#ifndef OMPL_CERTIFICATES_VALIDITY_STATISTICS_
#define OMPL_CERTIFICATES_VALIDITY_STATISTICS_

#include "ompl_certificates/certificates/CheckCounts.h"

#include <array>
#include <atomic>
#include <chrono>

namespace ompl_certificates
{
    /** \brief The counts and the checking time of a checker. Threads add to it without waiting for each other. */
    class Statistics
    {
    public:
        /** \brief The sum of all counts so far */
        CheckCounts getCounts() const;

        /** \brief One of the counts, such as &CheckCounts::exact. Cost: some 10 ns. */
        std::uint64_t getCount(std::uint64_t CheckCounts::*count) const;

        /** \brief The time spent in isValid() and checkMotion() so far, in seconds, summed over threads */
        double getCheckingSeconds() const;

        /** \brief Adds \e counts */
        void add(const CheckCounts &counts);

        /** \brief Sets all counts and the time to zero. Counts of checks that run meanwhile may come back. */
        void reset();

        /** \brief Adds its own lifetime to the checking time */
        class Timer
        {
        public:
            /** \brief Start the time */
            explicit Timer(Statistics &statistics);
            ~Timer();

            /** \brief When it was created */
            std::chrono::steady_clock::time_point getStart() const
            {
                return start_;
            }

            Timer(const Timer &) = delete;
            Timer &operator=(const Timer &) = delete;

        private:
            Statistics &statistics_;
            std::chrono::steady_clock::time_point start_;
        };

    private:
        static constexpr std::size_t FIELDS = sizeof(CheckCounts) / sizeof(std::uint64_t);
        /** \brief So many threads have a slot of their own; the others share as many */
        static constexpr std::size_t THREADS = 16;

        /** \brief The counts of one thread or of some. Several slots, so that threads seldom share a cache line. */
        struct alignas(64) Slot
        {
            std::array<std::atomic<std::uint64_t>, FIELDS> counts{};
            std::atomic<std::uint64_t> nanoseconds{0};
        };

        /** \brief Calls \e add(slot, increase) for this thread's slot. A slot of its own needs no atomic addition,
            which costs more than the rest. */
        template <typename Add>
        void addToSlot(const Add &add);

        std::array<Slot, 2 * THREADS> slots_;
    };
}

#endif
