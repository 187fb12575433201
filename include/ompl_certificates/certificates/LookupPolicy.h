#ifndef OMPL_CERTIFICATES_CERTIFICATES_LOOKUP_POLICY_
#define OMPL_CERTIFICATES_CERTIFICATES_LOOKUP_POLICY_

#include <atomic>
#include <cstdint>

namespace ompl_certificates
{
    /** \brief Whether looking certificates up pays for one body, judged by how often lookups have found one lately.

        A lookup costs about as much as a few clearances of primitives. Where it mostly fails, as for long bodies near
        obstacles, the obstacles are asked at once; one lookup in PROBE_INTERVAL goes on, to notice when that changes. No
        verdict depends on the policy. It judges by counts, not by clocks, so a plan is checked in the same way every
        time. May be used by many threads at once, which may then lose a count. */
    class LookupPolicy
    {
    public:
        /** \brief Whether to look up now. Counts as one chance. */
        bool isWorthwhile()
        {
            return rate_.load(std::memory_order_relaxed) >= SMALLEST_RATE || isProbe();
        }

        /** \brief Whether to look up now where it is not worthwhile: one time in PROBE_INTERVAL */
        bool isProbe()
        {
            const std::uint32_t passed = passed_.load(std::memory_order_relaxed) + 1;
            passed_.store(passed, std::memory_order_relaxed);
            return passed % PROBE_INTERVAL == 0;
        }

        /** \brief Take into account whether a lookup has found a certificate */
        void note(bool found)
        {
            const float rate = rate_.load(std::memory_order_relaxed);
            rate_.store(rate + ((found ? 1.0F : 0.0F) - rate) / MEMORY, std::memory_order_relaxed);
        }

        /** \brief Judge anew, as if all lookups had succeeded */
        void reset()
        {
            rate_.store(1.0F, std::memory_order_relaxed);
            passed_.store(0, std::memory_order_relaxed);
        }

    private:
        static constexpr float SMALLEST_RATE = 0.8F;
        static constexpr float MEMORY = 128.0F;
        static constexpr std::uint32_t PROBE_INTERVAL = 16;

        /** \brief The proportion of successful lookups, older ones counting less */
        std::atomic<float> rate_{1.0F};
        std::atomic<std::uint32_t> passed_{0};
    };
}

#endif
