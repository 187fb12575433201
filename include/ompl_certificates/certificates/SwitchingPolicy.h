#ifndef OMPL_CERTIFICATES_CERTIFICATES_SWITCHING_POLICY_
#define OMPL_CERTIFICATES_CERTIFICATES_SWITCHING_POLICY_

#include <atomic>
#include <chrono>
#include <cstdint>

namespace ompl_certificates
{
    /** \brief Which of the ways to settle a pose without the exact check pay for one body, judged by what they have cost
        and settled lately.

        Looking certificates up is judged by how often it finds one: where it mostly fails, as for long bodies near
        obstacles, the obstacles are asked at once. Asking clearances is judged by the clock: it is given up where it
        costs more than the exact checks that it saves (the paper's crossover). What does not pay is still tried one time
        in PROBE_INTERVAL, to notice when that changes. No verdict depends on the policy. May be used by many threads at
        once, which may then lose a note. */
    class alignas(64) SwitchingPolicy
    {
    public:
        /** \brief Whether to look certificates up now. Counts as one chance. */
        bool looksUp()
        {
            return lookupRate_.load(std::memory_order_relaxed) >= SMALLEST_LOOKUP_RATE || isProbe();
        }

        /** \brief Whether to try what does not pay: one time in PROBE_INTERVAL */
        bool isProbe()
        {
            const std::uint32_t chances = chances_.load(std::memory_order_relaxed) + 1;
            chances_.store(chances, std::memory_order_relaxed);
            return chances % PROBE_INTERVAL == 0;
        }

        /** \brief Take into account whether a lookup has found a certificate */
        void noteLookup(bool found)
        {
            approach(lookupRate_, found ? 1.0F : 0.0F, LOOKUP_MEMORY);
        }

        /** \brief Whether to ask clearances before the exact check. Counts as one chance. */
        bool asksClearances()
        {
            return pays_.load(std::memory_order_relaxed) || isProbe();
        }

        /** \brief Take into account how many samples of a motion clearances have settled: none, that of the pose, or others
            that their proof reaches as well */
        void noteClearances(double samples)
        {
            approach(settledSamples_, static_cast<float>(samples), COST_MEMORY);
        }

        /** \brief Whether to time how long this pose takes to settle. Reading the clock costs about as much as a lookup, so
            one pose in TIMING_INTERVAL is timed. */
        bool isTimed()
        {
            const std::uint32_t poses = poses_.load(std::memory_order_relaxed) + 1;
            poses_.store(poses, std::memory_order_relaxed);
            return poses % TIMING_INTERVAL == 0;
        }

        /** \brief Take into account how long clearances were asked for a pose */
        void noteClearanceCost(std::chrono::nanoseconds time)
        {
            noteCost(clearanceCost_, time);
        }

        /** \brief Take into account how long an exact check took */
        void noteExactCost(std::chrono::nanoseconds time)
        {
            noteCost(exactCost_, time);
        }

        /** \brief Judge anew, as if all had paid so far */
        void reset();

    private:
        static constexpr float SMALLEST_LOOKUP_RATE = 0.8F;
        static constexpr float LOOKUP_MEMORY = 128.0F, COST_MEMORY = 64.0F;
        static constexpr std::uint32_t PROBE_INTERVAL = 16;

        static constexpr std::uint32_t TIMING_INTERVAL = 8;

        static void approach(std::atomic<float> &mean, float value, float memory)
        {
            const float known = mean.load(std::memory_order_relaxed);
            // What does not change is not written: threads would wait for each other's cache lines.
            if (const float next = known + (value - known) / memory; next != known)
                mean.store(next, std::memory_order_relaxed);
        }

        /** \brief Take a new time into account, and judge */
        void noteCost(std::atomic<float> &cost, std::chrono::nanoseconds time);

        std::atomic<float> lookupRate_{1.0F};
        std::atomic<std::uint32_t> chances_{0}, poses_{0};

        /** \brief How many samples clearances settle; what asking them costs, and the exact check (nanoseconds; 0: not known
            yet) */
        std::atomic<float> settledSamples_{1.0F}, clearanceCost_{0.0F}, exactCost_{0.0F};
        std::atomic<bool> pays_{true};
    };
}

#endif
