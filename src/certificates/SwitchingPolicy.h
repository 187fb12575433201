#ifndef OMPL_CERTIFICATES_CERTIFICATES_SWITCHING_POLICY_
#define OMPL_CERTIFICATES_CERTIFICATES_SWITCHING_POLICY_

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>

namespace ompl_certificates
{
    /** \brief Which of the ways to settle a pose pay for one body, judged by what they have cost and settled lately.

        Looking certificates up is judged by how often it finds one: where it mostly fails, as for long bodies near
        obstacles, the obstacles are asked at once. How they are asked is judged by the clock: with or without clearances
        first (the paper's crossover), with or without the quick contact test before the exact check. Of these four ways
        the one is taken that takes the least time for every sample of a motion that it settles; each way is measured
        with the poses that it gets, since what a clearance settles is mostly what is quickly checked too. The others are
        still tried now and then, to notice when that changes, the more seldom the more they cost. No verdict depends on
        the policy. May be used by many threads at once, which may then lose a note. */
    class alignas(64) SwitchingPolicy
    {
    public:
        /** \brief What comes before the exact check of a pose */
        struct Way
        {
            /** \brief Whether clearances are asked */
            bool clearances;

            /** \brief Whether the quick contact test is tried, Obstacles::touches() */
            bool contact;
        };

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

        /** \brief Whether to time how long this pose takes to settle. Reading the clock costs about as much as a lookup, so
            one pose in TIMING_INTERVAL is timed. */
        bool isTimed()
        {
            const std::uint32_t poses = poses_.load(std::memory_order_relaxed) + 1;
            poses_.store(poses, std::memory_order_relaxed);
            return poses % TIMING_INTERVAL == 0;
        }

        /** \brief Which ways there are to choose from */
        enum Choice
        {
            /// All four.
            ANY,
            /// Those without clearances, where nothing is to be remembered.
            WITHOUT_CLEARANCES
        };

        /** \brief How to settle a pose
            \param timed whether the policy will be told how long it took: only then is tried what does not pay */
        Way choose(Choice choice, bool timed)
        {
            return wayOf(timed ? tryOut(choice) : best_[choice].load(std::memory_order_relaxed));
        }

        /** \brief Take into account how long clearances were asked for a pose, and how many samples of its motion they have
            settled: none, its own, and others that the proof reaches as well */
        void noteClearances(std::chrono::nanoseconds time, double samples);

        /** \brief Take into account how long the exact check of a pose took, with the contact test if \e way has it; if it
            has clearances, they have not settled the pose */
        void noteExact(Way way, std::chrono::nanoseconds time);

        /** \brief Judge anew, as if all had paid so far */
        void reset();

    private:
        static constexpr float SMALLEST_LOOKUP_RATE = 0.8F;
        static constexpr float LOOKUP_MEMORY = 128.0F;
        static constexpr std::uint32_t PROBE_INTERVAL = 16;
        static constexpr std::uint32_t TIMING_INTERVAL = 8;

        /** \brief Ways have numbers: one bit for each of the two that is left out */
        static constexpr std::uint32_t WAYS = 4, FIRST_WITHOUT_CLEARANCES = 2;

        static Way wayOf(std::uint32_t number)
        {
            return {number < FIRST_WITHOUT_CLEARANCES, number % 2 == 0};
        }

        static std::uint32_t numberOf(Way way)
        {
            return (way.clearances ? 0 : FIRST_WITHOUT_CLEARANCES) + (way.contact ? 0 : 1);
        }

        /** \brief The numbers of the ways of a choice: from the first to before the second */
        static std::array<std::uint32_t, 2> waysOf(Choice choice)
        {
            return {choice == WITHOUT_CLEARANCES ? FIRST_WITHOUT_CLEARANCES : 0, WAYS};
        }

        /** \brief What something has cost lately */
        struct Cost
        {
            /** \brief The mean of the times in nanoseconds */
            std::atomic<float> mean{0.0F};

            /** \brief How many times are known, up to enough to judge by */
            std::atomic<std::uint32_t> notes{0};
        };

        static void approach(std::atomic<float> &mean, float value, float memory)
        {
            const float known = mean.load(std::memory_order_relaxed);
            // What does not change is not written: threads would wait for each other's cache lines.
            if (const float next = known + (value - known) / memory; next != known)
                mean.store(next, std::memory_order_relaxed);
        }

        /** \brief Take a time into account, but no more than \e most of it
            \return how many poses its mean now remembers */
        static float note(Cost &cost, std::chrono::nanoseconds time, float most);

        /** \brief The number of the way for a timed pose: mostly the best one */
        std::uint32_t tryOut(Choice choice);

        /** \brief What a way costs for each sample of a motion that it settles (nanoseconds) */
        float costOf(std::uint32_t way) const;

        /** \brief Find out which ways are the best */
        void judge();

        std::atomic<float> lookupRate_{1.0F};
        std::atomic<std::uint32_t> chances_{0}, poses_{0}, turns_{0};

        /** \brief What asking clearances costs; the share of poses that it leaves unsettled, and how many samples are
            settled by it or by the exact check that follows */
        Cost clearances_;
        std::atomic<float> unsettled_{0.0F}, samples_{1.0F};

        /** \brief What the exact check costs at the end of each way */
        std::array<Cost, WAYS> exact_;

        /** \brief The number of the best way of each choice */
        std::array<std::atomic<std::uint32_t>, 2> best_{0, FIRST_WITHOUT_CLEARANCES};
    };
}

#endif
