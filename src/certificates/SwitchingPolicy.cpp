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

    void SwitchingPolicy::noteExact(bool afterClearances, std::chrono::nanoseconds time)
    {
        float largest = 0.0F;
        for (const Cost &cost : exact_)
            largest = std::max(largest, cost.mean.load(std::memory_order_relaxed));
        note(exact_[afterClearances ? WITH_CLEARANCES : WITHOUT_CLEARANCES], time,
             largest == 0.0F ? std::numeric_limits<float>::max() : LARGEST_SURPRISE * largest);
        judge();
    }

    float SwitchingPolicy::costOf(std::uint32_t way) const
    {
        const float exact = exact_[way].mean.load(std::memory_order_relaxed);
        if (way == WITHOUT_CLEARANCES)
            return WORTH_OF_PROOFS * exact;
        return (clearances_.mean.load(std::memory_order_relaxed) + unsettled_.load(std::memory_order_relaxed) * exact) /
               samples_.load(std::memory_order_relaxed);
    }

    void SwitchingPolicy::judge()
    {
        const std::uint32_t best = best_.load(std::memory_order_relaxed), other = WAYS - 1 - best;
        if (exact_[other].notes.load(std::memory_order_relaxed) == ENOUGH_NOTES &&
            HYSTERESIS * costOf(other) < costOf(best))
            best_.store(other, std::memory_order_relaxed);
    }

    std::uint32_t SwitchingPolicy::tryOut()
    {
        const std::uint32_t best = best_.load(std::memory_order_relaxed), other = WAYS - 1 - best;
        const std::uint32_t turn = turns_.load(std::memory_order_relaxed) + 1;
        turns_.store(turn, std::memory_order_relaxed);
        const std::uint32_t notes = exact_[other].notes.load(std::memory_order_relaxed);
        if (notes < FEW_NOTES)
            return other;
        const float ratio = std::max(costOf(other) / std::max(costOf(best), 1.0F), 1.0F);
        const float interval = ratio * (notes < ENOUGH_NOTES ? FIRST_TRIAL_INTERVAL : TRIAL_INTERVAL);
        return turn % static_cast<std::uint32_t>(std::min(interval, LONGEST_TRIAL_INTERVAL)) == 0 ? other : best;
    }

    void SwitchingPolicy::reset()
    {
        lookupRate_.store(1.0F, std::memory_order_relaxed);
        for (auto *count : {&chances_, &poses_, &turns_})
            count->store(0, std::memory_order_relaxed);
        unsettled_.store(0.0F, std::memory_order_relaxed);
        samples_.store(1.0F, std::memory_order_relaxed);
        for (Cost *cost : {&clearances_, &exact_[WITH_CLEARANCES], &exact_[WITHOUT_CLEARANCES]})
        {
            cost->mean.store(0.0F, std::memory_order_relaxed);
            cost->notes.store(0, std::memory_order_relaxed);
        }
        best_.store(WITH_CLEARANCES, std::memory_order_relaxed);
    }
}
