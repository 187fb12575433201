#include "CertificatePolicy.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** Between two trials lies this fraction of the checks since certificates came into use, but at least and at
            most so many. More where the standard check, which is only tried, takes longer. */
        constexpr double FRACTION = 1.0 / 16.0, SHORTEST_INTERVAL = 4.0, LONGEST_INTERVAL = 128.0;

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
        nextTrial_ = checks_ + 1;
        trials_.clear();
        estimated_ = measured_ = 0.0;
    }

    void CertificatePolicy::note(std::uint64_t samples, std::chrono::nanoseconds certified,
                                 std::chrono::nanoseconds exact)
    {
        trials_.add(static_cast<double>(samples),
                    {static_cast<double>(certified.count()), static_cast<double>(exact.count())});
        // This check is not counted yet.
        const auto checksInUse = static_cast<double>(checks_ - firstCheck_ + 1);
        const auto samplesInUse = static_cast<double>(samples_ - firstSample_ + samples);
        const TrialTimes::Times mean = trials_.estimate(samplesInUse / checksInUse);
        if (trials_.count() >= ENOUGH_TRIALS && mean.exact < requiredFactor(samplesInUse) * mean.certified)
        {
            usesCertificates_ = false;
            nextUse_ = PATIENCE * samples_;
            return;
        }
        const double cost = std::max(mean.exact / std::max(mean.certified, 1.0), 1.0);
        const double interval = cost * std::clamp(FRACTION * checksInUse, SHORTEST_INTERVAL, LONGEST_INTERVAL);
        nextTrial_ = checks_ + static_cast<std::uint64_t>(interval);
    }
}
