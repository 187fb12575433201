#include "CertificatePolicy.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** Between two trials lies this fraction of the checks since certificates came into use, but at least and at most
            so many. More where the standard check, which is only tried, takes longer. */
        constexpr double FRACTION = 1.0 / 16.0, SHORTEST_INTERVAL = 4.0, LONGEST_INTERVAL = 128.0;

        /** How many trials the mean times remember */
        constexpr double MEMORY = 48.0;

        /** A time counts as at most this multiple of the mean: more is mostly another program's time slice. */
        constexpr double LARGEST_SURPRISE = 16.0;

        /** When certificates have been in use for so many samples and trials, they are judged for the first time; after
            so many, they are mature. */
        constexpr double FIRST_JUDGED = 512.0, MATURE = 8192.0;
        constexpr std::uint32_t ENOUGH_TRIALS = 16;

        /** How much faster they must make a check by then. Below 1, since later checks profit from those made now. */
        constexpr double FIRST_FACTOR = 0.5, MATURE_FACTOR = 0.95;

        /** After how many times as many samples they are tried again */
        constexpr std::uint64_t PATIENCE = 2;

        double requiredFactor(double samples)
        {
            if (samples < FIRST_JUDGED)
                return 0.0;
            const double maturity = std::min(std::log(samples / FIRST_JUDGED) / std::log(MATURE / FIRST_JUDGED), 1.0);
            return FIRST_FACTOR + maturity * (MATURE_FACTOR - FIRST_FACTOR);
        }
    }

    void CertificatePolicy::begin()
    {
        usesCertificates_ = true;
        firstSample_ = samples_;
        firstCheck_ = checks_;
        trials_ = 0;
    }

    void CertificatePolicy::remember(double &mean, std::chrono::nanoseconds time) const
    {
        const auto nanoseconds = static_cast<double>(time.count());
        if (trials_ == 1)
            mean = nanoseconds;
        else
            mean += (std::min(nanoseconds, LARGEST_SURPRISE * mean) - mean) /
                    std::min(static_cast<double>(trials_), MEMORY);
    }

    void CertificatePolicy::note(std::chrono::nanoseconds certified, std::chrono::nanoseconds exact)
    {
        if (!usesCertificates_)
            begin();
        ++trials_;
        remember(certified_, certified);
        remember(exact_, exact);
        if (trials_ >= ENOUGH_TRIALS &&
            exact_ < requiredFactor(static_cast<double>(samples_ - firstSample_)) * certified_)
        {
            usesCertificates_ = false;
            nextUse_ = PATIENCE * samples_;
            return;
        }
        const double cost = std::max(exact_ / std::max(certified_, 1.0), 1.0);
        const auto inUse = static_cast<double>(checks_ - firstCheck_);
        const double interval = cost * std::clamp(FRACTION * inUse, SHORTEST_INTERVAL, LONGEST_INTERVAL);
        nextTrial_ = checks_ + static_cast<std::uint64_t>(interval);
    }
}
