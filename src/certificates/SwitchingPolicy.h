#ifndef OMPL_CERTIFICATES_CERTIFICATES_SWITCHING_POLICY_
#define OMPL_CERTIFICATES_CERTIFICATES_SWITCHING_POLICY_

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>

namespace ompl_certificates
{
    /** \brief Chooses how to settle the poses of one body, by what each way has cost and settled lately.

        Certificate lookups are judged by their success rate. Where they mostly fail, as for long bodies near obstacles,
        the obstacles are asked at once. How to ask is judged by the clock: with clearances before the exact check, or
        without (the paper's crossover). The policy chooses the way with the least time for each sample of a motion that
        it settles. Each way is measured with the poses it gets: what a clearance settles is mostly quick to check, too.
        The other way is still tried now and then, more seldom the more it costs.

        No verdict depends on the policy. May be used by many threads at once; a measurement may then be lost. */
    class alignas(64) SwitchingPolicy
    {
    public:
        /** \brief Whether to look certificates up for this pose. Call it once for each pose. */
        bool looksUp()
        {
            return lookupRate_.load(std::memory_order_relaxed) >= SMALLEST_LOOKUP_RATE || isProbe();
        }

        /** \brief Whether to try what has not paid lately: once in PROBE_INTERVAL calls */
        bool isProbe()
        {
            return countChance() % PROBE_INTERVAL == 0;
        }

        /** \brief Whether to try what hardly ever pays: once in RARE_PROBE_INTERVAL calls, soon for the first time */
        bool isRareProbe()
        {
            return countChance() % RARE_PROBE_INTERVAL == FIRST_RARE_PROBE;
        }

        /** \brief Notes whether a lookup found a certificate */
        void noteLookup(bool found)
        {
            approach(lookupRate_, found ? 1.0F : 0.0F, LOOKUP_MEMORY);
        }

        /** \brief Whether to time this pose. Reading the clock costs about as much as a lookup, so one pose in
            TIMING_INTERVAL is timed. */
        bool isTimed()
        {
            const std::uint32_t poses = poses_.load(std::memory_order_relaxed) + 1;
            poses_.store(poses, std::memory_order_relaxed);
            return poses % TIMING_INTERVAL == 0;
        }

        /** \brief Whether to ask clearances for a pose before the exact check
            \param timed whether the time will be noted; only then is tried what does not pay */
        bool asksClearances(bool timed)
        {
            return (timed ? tryOut() : best_.load(std::memory_order_relaxed)) == WITH_CLEARANCES;
        }

        /** \brief Notes how long asking clearances took for a pose, and how many samples it settled: 0 if not even this
            one, else 1 plus others within the valid interval */
        void noteClearances(std::chrono::nanoseconds time, double samples);

        /** \brief Notes how long the exact check of a pose took, and the contact test before it
            \param afterClearances whether clearances were asked before, and did not settle the pose */
        void noteExact(bool afterClearances, std::chrono::nanoseconds time);

        /** \brief Forgets all measurements */
        void reset();

    private:
        static constexpr float SMALLEST_LOOKUP_RATE = 0.8F;
        static constexpr float LOOKUP_MEMORY = 128.0F;
        static constexpr std::uint32_t PROBE_INTERVAL = 16, RARE_PROBE_INTERVAL = 256, FIRST_RARE_PROBE = 4;
        static constexpr std::uint32_t TIMING_INTERVAL = 8;

        std::uint32_t countChance()
        {
            const std::uint32_t chances = chances_.load(std::memory_order_relaxed) + 1;
            chances_.store(chances, std::memory_order_relaxed);
            return chances;
        }

        /** \brief The ways to settle a pose */
        enum Way : std::uint32_t
        {
            WITH_CLEARANCES,
            WITHOUT_CLEARANCES
        };

        static constexpr std::uint32_t WAYS = 2;

        /** \brief A running mean of times */
        struct Cost
        {
            /** \brief The mean of the times in nanoseconds */
            std::atomic<float> mean{0.0F};

            /** \brief How many times were noted, up to enough to judge by */
            std::atomic<std::uint32_t> notes{0};
        };

        static void approach(std::atomic<float> &mean, float value, float memory)
        {
            const float known = mean.load(std::memory_order_relaxed);
            // Unchanged values are not written: that would invalidate the cache lines of other threads.
            if (const float next = known + (value - known) / memory; next != known)
                mean.store(next, std::memory_order_relaxed);
        }

        /** \brief Notes a time, clipped to \e most
            \return how many poses the mean now remembers */
        static float note(Cost &cost, std::chrono::nanoseconds time, float most);

        /** \brief The way for a timed pose: mostly the best one */
        std::uint32_t tryOut();

        /** \brief The cost of a way for each sample of a motion that it settles (nanoseconds) */
        float costOf(std::uint32_t way) const;

        /** \brief Determines the best way */
        void judge();

        std::atomic<float> lookupRate_{1.0F};
        std::atomic<std::uint32_t> chances_{0}, poses_{0}, turns_{0};

        /** \brief The cost of asking clearances; the fraction of poses they leave unsettled; and how many samples are
            settled by them or by the exact check that follows */
        Cost clearances_;
        std::atomic<float> unsettled_{0.0F}, samples_{1.0F};

        /** \brief The cost of the exact check at the end of each way */
        std::array<Cost, WAYS> exact_;

        /** \brief The best way */
        std::atomic<std::uint32_t> best_{WITH_CLEARANCES};
    };

    /** \brief The policies of one body: what pays for poses alone does not tell what pays in motions, where a proof
        settles many samples. */
    class SwitchingPolicies
    {
    public:
        /** \brief The policy for a pose after which \e samplesAhead samples of its motion are open */
        SwitchingPolicy &of(double samplesAhead)
        {
            return samplesAhead > 0.0 ? ofMotions_ : ofPoses_;
        }

        /** \brief Forgets all measurements */
        void reset()
        {
            ofPoses_.reset();
            ofMotions_.reset();
        }

    private:
        SwitchingPolicy ofPoses_, ofMotions_;
    };
}

#endif
