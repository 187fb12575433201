#include "ompl_certificates/validity/Statistics.h"

#include "ThreadNumber.h"

#include <cstring>

namespace ompl_certificates
{
    template <typename Add>
    void Statistics::addToSlot(const Add &add)
    {
        using Counter = std::atomic<std::uint64_t>;
        const std::size_t thread = threadNumber();
        if (thread < THREADS)
            add(slots_[thread], [](Counter &counter, std::uint64_t value)
                { counter.store(counter.load(std::memory_order_relaxed) + value, std::memory_order_relaxed); });
        else
            add(slots_[THREADS + thread % THREADS],
                [](Counter &counter, std::uint64_t value) { counter.fetch_add(value, std::memory_order_relaxed); });
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
        addToSlot(
            [&values](Slot &slot, const auto &increase)
            {
                for (std::size_t i = 0; i < FIELDS; ++i)
                    if (values[i] != 0)
                        increase(slot.counts[i], values[i]);
            });
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
        const auto nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(elapsed).count();
        statistics_.addToSlot([nanoseconds](Slot &slot, const auto &increase)
                              { increase(slot.nanoseconds, static_cast<std::uint64_t>(nanoseconds)); });
    }
}
