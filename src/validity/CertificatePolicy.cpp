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

        /** Fewer checks may lie between trials if they have so many samples: those of long motions. */
        constexpr double SHORTEST_SAMPLES = 64.0;

        /** Where the standard check takes less in a trial, in nanoseconds, the ways take turns once certificates are
            mature. Between two turns of the standard check lie so many times as many checks. */
        constexpr double CHEAP = 10000.0, TURNS_APART = 32.0;

        /** When certificates have been in use for so many samples and trials, they are judged for the first time; after
            so many, they are mature. */
        constexpr double FIRST_JUDGED = 512.0, MATURE = 8192.0;
        constexpr std::uint32_t ENOUGH_TRIALS = 16;

        /** How much faster they must make a check by then. Below 1, since later checks profit from those made now. */
        constexpr double FIRST_FACTOR = 0.5, MATURE_FACTOR = 0.95;

        /** They are tried again when so many times as many samples have passed, and so many times the time that they
            lost. Then tries cost some 3 % where certificates never pay. */
        constexpr std::uint64_t PATIENCE = 2;
        constexpr double TRIES_APART = 32.0;

        /** Where certificates lose by the first estimate, the standard check goes on up to so many samples. */
        constexpr std::uint64_t FIRST_STANDARD = 2048;

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
        takesTurns_ = false;
        firstSample_ = samples_;
        firstCheck_ = checks_;
        nextTrial_ = checks_ + 1;
        certified_ = standard_ = CheckTimes(TRIAL_MEMORY);
        estimated_ = measured_ = 0.0;
    }

    void CertificatePolicy::beginTurns()
    {
        takesTurns_ = true;
        nextTrial_ = checks_ + 1;
        certified_ = standard_ = CheckTimes(TURN_MEMORY);
    }

    void CertificatePolicy::note(std::uint64_t samples, std::chrono::nanoseconds certified,
                                 std::chrono::nanoseconds standard)
    {
        certified_.add(samples, certified);
        standard_.add(samples, standard);
        // This check is not counted yet.
        const auto checksInUse = static_cast<double>(checks_ - firstCheck_ + 1);
        const auto samplesInUse = static_cast<double>(samples_ - firstSample_ + samples);
        if (samplesInUse >= MATURE && standard_.mean() < CHEAP)
            beginTurns();
        else
            judge(checksInUse, samplesInUse);
    }

    void CertificatePolicy::noteEstimate(std::chrono::nanoseconds certified, double standard)
    {
        estimated_ += (standard - estimated_) / ESTIMATE_MEMORY;
        measured_ += (static_cast<double>(certified.count()) - measured_) / ESTIMATE_MEMORY;
        if (standard_.count() == 0 && samples_ < FIRST_STANDARD && estimated_ < measured_)
        {
            usesCertificates_ = false;
            nextUse_ = FIRST_STANDARD;
        }
    }

    void CertificatePolicy::judge(double checksInUse, double samplesInUse)
    {
        // In turns, either way checks other motions, but so many that their means can be compared.
        const auto timeOf = [&](const CheckTimes &times)
        { return takesTurns_ ? times.mean() : times.estimate(samplesInUse / checksInUse); };
        const double certified = timeOf(certified_), standard = timeOf(standard_);
        if (standard_.count() >= ENOUGH_TRIALS && standard < requiredFactor(samplesInUse) * certified)
        {
            usesCertificates_ = false;
            // The time lost, as the number of samples that the standard check makes in it. It is not known when mature
            // certificates began to lose. So at most MATURE samples count as lost.
            const double trials = takesTurns_ ? 0.0 : static_cast<double>(standard_.count());
            const double lost = std::min(samplesInUse, MATURE) * (certified / std::max(standard, 1.0) - 1.0) +
                                trials * samplesInUse / checksInUse;
            nextUse_ = std::max(PATIENCE * samples_, samples_ + static_cast<std::uint64_t>(TRIES_APART * lost));
            takesTurns_ = false;
            return;
        }
        const double cost = std::max(standard / std::max(certified, 1.0), 1.0);
        const double shortest = std::clamp(SHORTEST_SAMPLES * checksInUse / samplesInUse, 1.0, SHORTEST_INTERVAL);
        const double interval = takesTurns_ ? TURNS_APART * static_cast<double>(TURN)
                                            : std::clamp(FRACTION * checksInUse, shortest, LONGEST_INTERVAL);
        nextTrial_ = checks_ + static_cast<std::uint64_t>(cost * interval);
    }
}
