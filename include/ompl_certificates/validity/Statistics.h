#ifndef OMPL_CERTIFICATES_VALIDITY_STATISTICS_
#define OMPL_CERTIFICATES_VALIDITY_STATISTICS_

#include "ompl_certificates/certificates/CheckCounts.h"

#include <array>
#include <atomic>
#include <chrono>

namespace ompl_certificates
{
    /** \brief What a checker has done: its counts and the time that it took. Threads add to it without waiting for each
        other. */
    class Statistics
    {
    public:
        /** \brief The sum of all counts so far */
        CheckCounts getCounts() const;

        /** \brief One of the counts, such as &CheckCounts::exact; takes some 10 ns */
        std::uint64_t getCount(std::uint64_t CheckCounts::*count) const;

        /** \brief The time spent in isValid() and checkMotion() so far, in seconds, summed over threads */
        double getCheckingSeconds() const;

        /** \brief Add \e counts */
        void add(const CheckCounts &counts);

        /** \brief Set all counts and the time to zero */
        void reset();

        /** \brief Adds the time of its life to a Statistics */
        class Timer
        {
        public:
            /** \brief Start the time */
            explicit Timer(Statistics &statistics);
            ~Timer();

            Timer(const Timer &) = delete;
            Timer &operator=(const Timer &) = delete;

        private:
            Statistics &statistics_;
            std::chrono::steady_clock::time_point start_;
        };

    private:
        static constexpr std::size_t FIELDS = sizeof(CheckCounts) / sizeof(std::uint64_t);
        static constexpr std::size_t SLOTS = 16;

        /** \brief One of several places to count in, so that threads seldom share a cache line */
        struct alignas(64) Slot
        {
            std::array<std::atomic<std::uint64_t>, FIELDS> counts{};
            std::atomic<std::uint64_t> nanoseconds{0};
        };

        Slot &slotOfThisThread();

        std::array<Slot, SLOTS> slots_;
    };
}

#endif
