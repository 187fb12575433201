#include "ompl_certificates/validity/Statistics.h"

#include "ThreadNumber.h"

#include <cstring>

namespace ompl_certificates
{
    Statistics::Slot &Statistics::slotOfThisThread()
    {
        return slots_[threadNumber() % SLOTS];
    }

    CheckCounts Statistics::getCounts() const
    {
        static_assert(sizeof(CheckCounts) == FIELDS * sizeof(std::uint64_t), "CheckCounts holds counters only");
        std::array<std::uint64_t, FIELDS> sums{};
        for (const Slot &slot : slots_)
            for (std::size_t i = 0; i < FIELDS; ++i)
                sums[i] += slot.counts[i].load(std::memory_order_relaxed);
        CheckCounts counts;
        std::memcpy(static_cast<void *>(&counts), sums.data(), sizeof(counts));
        return counts;
    }

    std::uint64_t Statistics::getCount(std::uint64_t CheckCounts::*count) const
    {
        const CheckCounts layout;
        const auto field = static_cast<std::size_t>(&(layout.*count) - &layout.robotPoses);
        std::uint64_t sum = 0;
        for (const Slot &slot : slots_)
            sum += slot.counts[field].load(std::memory_order_relaxed);
        return sum;
    }

    double Statistics::getCheckingSeconds() const
    {
        std::uint64_t nanoseconds = 0;
        for (const Slot &slot : slots_)
            nanoseconds += slot.nanoseconds.load(std::memory_order_relaxed);
        return 1e-9 * static_cast<double>(nanoseconds);
    }

    void Statistics::add(const CheckCounts &counts)
    {
        std::array<std::uint64_t, FIELDS> values;
        std::memcpy(values.data(), &counts, sizeof(counts));
        Slot &slot = slotOfThisThread();
        for (std::size_t i = 0; i < FIELDS; ++i)
            if (values[i] != 0)
                slot.counts[i].fetch_add(values[i], std::memory_order_relaxed);
    }

    void Statistics::reset()
    {
        for (Slot &slot : slots_)
        {
            for (auto &count : slot.counts)
                count.store(0, std::memory_order_relaxed);
            slot.nanoseconds.store(0, std::memory_order_relaxed);
        }
    }

    Statistics::Timer::Timer(Statistics &statistics) : statistics_(statistics), start_(std::chrono::steady_clock::now())
    {
    }

    Statistics::Timer::~Timer()
    {
        const auto elapsed = std::chrono::steady_clock::now() - start_;
        statistics_.slotOfThisThread().nanoseconds.fetch_add(
            static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(elapsed).count()),
            std::memory_order_relaxed);
    }
}
