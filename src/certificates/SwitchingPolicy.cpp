#include "SwitchingPolicy.h"

#include <algorithm>
#include <limits>

namespace ompl_certificates
{
    namespace
    {
        /** How many poses a way is tried with at first, and how many must be known before it is chosen. The first is
            not counted, since it also pays for what is built on first use. */
        constexpr std::uint32_t FEW_NOTES = 3, ENOUGH_NOTES = 9;

        /** How many poses a running mean remembers */
        constexpr float MEMORY = 64.0F;

        /** A time counts as at most this multiple of the known mean: more is mostly another program's time slice. Exact
            checks of a body vary more than its clearances, so for them it is a multiple of their largest mean. */
        constexpr float LARGEST_SURPRISE = 16.0F;

        /** How much cheaper another way must be to be chosen: prevents switching to and fro by chance. */
        constexpr float HYSTERESIS = 1.1F;

        /** The value of a proof to later motions, which inherit it. Poses settled without clearances count as more
            expensive by this factor. */
        constexpr float WORTH_OF_PROOFS = 1.5F;

        /** How many timed poses lie between two trials of another way that costs as much, at first and later. A more
            expensive way is tried more seldom in proportion. So trials take about a hundredth of the time. */
        constexpr float FIRST_TRIAL_INTERVAL = 8.0F, TRIAL_INTERVAL = 16.0F, LONGEST_TRIAL_INTERVAL = 4096.0F;
    }

    float SwitchingPolicy::note(Cost &cost, std::chrono::nanoseconds time, float most)
    {
        const std::uint32_t notes = cost.notes.load(std::memory_order_relaxed);
        if (notes < ENOUGH_NOTES)
            cost.notes.store(notes + 1, std::memory_order_relaxed);
        const float memory = notes < ENOUGH_NOTES ? static_cast<float>(std::max(notes, 1U)) : MEMORY;
        if (notes > 0)
            approach(cost.mean, std::min(static_cast<float>(time.count()), most), memory);
        return memory;
    }

    void SwitchingPolicy::noteClearances(std::chrono::nanoseconds time, double samples)
    {
        const float known = clearances_.mean.load(std::memory_order_relaxed);
        const float memory =
            note(clearances_, time, known == 0.0F ? std::numeric_limits<float>::max() : LARGEST_SURPRISE * known);
        approach(unsettled_, samples == 0.0 ? 1.0F : 0.0F, memory);
        approach(samples_, std::max(static_cast<float>(samples), 1.0F), memory);
        judge();
    }

    void SwitchingPolicy::noteExact(Way way, std::chrono::nanoseconds time)
    {
        float largest = 0.0F;
        for (const Cost &cost : exact_)
            largest = std::max(largest, cost.mean.load(std::memory_order_relaxed));
        note(exact_[numberOf(way)], time,
             largest == 0.0F ? std::numeric_limits<float>::max() : LARGEST_SURPRISE * largest);
        judge();
    }

    float SwitchingPolicy::costOf(std::uint32_t way) const
    {
        const float exact = exact_[way].mean.load(std::memory_order_relaxed);
        if (!wayOf(way).clearances)
            return WORTH_OF_PROOFS * exact;
        return (clearances_.mean.load(std::memory_order_relaxed) + unsettled_.load(std::memory_order_relaxed) * exact) /
               samples_.load(std::memory_order_relaxed);
    }

    void SwitchingPolicy::judge()
    {
        for (const Choice choice : {ANY, WITHOUT_CLEARANCES})
        {
            std::uint32_t best = best_[choice].load(std::memory_order_relaxed);
            float least = costOf(best) / HYSTERESIS;
            const auto [first, end] = waysOf(choice);
            for (std::uint32_t way = first; way < end; ++way)
                if (exact_[way].notes.load(std::memory_order_relaxed) == ENOUGH_NOTES && costOf(way) < least)
                {
                    best = way;
                    least = costOf(way);
                }
            best_[choice].store(best, std::memory_order_relaxed);
        }
    }

    std::uint32_t SwitchingPolicy::tryOut(Choice choice)
    {
        const auto [first, end] = waysOf(choice);
        const std::uint32_t best = best_[choice].load(std::memory_order_relaxed);
        const std::uint32_t turn = turns_.load(std::memory_order_relaxed) + 1;
        turns_.store(turn, std::memory_order_relaxed);
        const float least = std::max(costOf(best), 1.0F);
        for (std::uint32_t i = 0; i < end - first; ++i)
        {
            const std::uint32_t way = first + (turn + i) % (end - first);
            const std::uint32_t notes = exact_[way].notes.load(std::memory_order_relaxed);
            if (notes < FEW_NOTES)
                return way;
            const float ratio = std::max(costOf(way) / least, 1.0F);
            const float interval = ratio * (notes < ENOUGH_NOTES ? FIRST_TRIAL_INTERVAL : TRIAL_INTERVAL);
            if (way != best &&
                (turn + way) % static_cast<std::uint32_t>(std::min(interval, LONGEST_TRIAL_INTERVAL)) == 0)
                return way;
        }
        return best;
    }

    void SwitchingPolicy::reset()
    {
        lookupRate_.store(1.0F, std::memory_order_relaxed);
        for (auto *count : {&chances_, &poses_, &turns_})
            count->store(0, std::memory_order_relaxed);
        unsettled_.store(0.0F, std::memory_order_relaxed);
        samples_.store(1.0F, std::memory_order_relaxed);
        for (Cost *cost : {&clearances_, &exact_[0], &exact_[1], &exact_[2], &exact_[3]})
        {
            cost->mean.store(0.0F, std::memory_order_relaxed);
            cost->notes.store(0, std::memory_order_relaxed);
        }
        for (const Choice choice : {ANY, WITHOUT_CLEARANCES})
            best_[choice].store(waysOf(choice)[0], std::memory_order_relaxed);
    }
}
