#include "ompl_certificates/certificates/SwitchingPolicy.h"

#include <algorithm>

namespace ompl_certificates
{
    namespace
    {
        /** A time counts as at most this multiple of the known mean: the rest is another program's turn. */
        constexpr float LARGEST_SURPRISE = 8.0F;

        /** Clearances are given up only where they cost that much more than they save, and taken up again where they
            cost less: not to and fro by chance. */
        constexpr float HYSTERESIS = 1.25F;
    }

    void SwitchingPolicy::noteCost(std::atomic<float> &cost, std::chrono::nanoseconds time)
    {
        const auto nanoseconds = static_cast<float>(time.count());
        const float known = cost.load(std::memory_order_relaxed);
        if (known == 0.0F)
            cost.store(nanoseconds, std::memory_order_relaxed);
        else
            approach(cost, std::min(nanoseconds, LARGEST_SURPRISE * known), COST_MEMORY);
        const float exact = exactCost_.load(std::memory_order_relaxed);
        const float asking = clearanceCost_.load(std::memory_order_relaxed);
        if (exact == 0.0F || asking == 0.0F)
            return;
        const float saved = settledSamples_.load(std::memory_order_relaxed) * exact;
        const bool pays = pays_.load(std::memory_order_relaxed);
        pays_.store(asking < (pays ? HYSTERESIS : 1.0F) * saved, std::memory_order_relaxed);
    }

    void SwitchingPolicy::reset()
    {
        lookupRate_.store(1.0F, std::memory_order_relaxed);
        settledSamples_.store(1.0F, std::memory_order_relaxed);
        clearanceCost_.store(0.0F, std::memory_order_relaxed);
        exactCost_.store(0.0F, std::memory_order_relaxed);
        pays_.store(true, std::memory_order_relaxed);
        chances_.store(0, std::memory_order_relaxed);
        poses_.store(0, std::memory_order_relaxed);
    }
}
