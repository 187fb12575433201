#ifndef OMPL_CERTIFICATES_VALIDITY_CERTIFICATE_POLICY_
#define OMPL_CERTIFICATES_VALIDITY_CERTIFICATE_POLICY_

#include "CheckTimes.h"

#include <chrono>
#include <cstdint>

namespace ompl_certificates
{
    /** \brief Decides whether checks of one kind use certificates, or the standard check alone.

        Certificates cost time first and save it later. So it begins with the standard check: short plans are not worth
        an investment. Then it uses certificates, and at some checks compares the times of both ways: of the same
        motion, so that few trials suffice. The longer they have been in use, the more they must have saved; else it
        returns to the standard check, and tries them again later. How long that is, is counted in samples, not in
        checks: certificates save most of a long motion's.

        In a trial the standard check runs with cold caches, and a cheap one takes several times as long as it would.
        So in the end cheap checks are not compared by trials. The ways take turns, for many checks in a row.

        No verdict depends on it. Each thread has its own. */
    class CertificatePolicy
    {
    public:
        /** \brief Whether to make the next check both ways, and to note() the times */
        bool isTrial() const
        {
            return usesCertificates_ && !takesTurns_ && checks_ >= nextTrial_ &&
                   (!paysClearly() || checks_ - firstCheck_ >= CHECKS_BEFORE_TRIAL);
        }

        /** \brief Whether the ways take turns, and the next check is to be timed, for noteTurn(). The first checks of a
            turn warm up the caches. */
        bool isTimed() const
        {
            return takesTurns_ && checks_ >= nextTrial_ && (checks_ - nextTrial_) % TURN >= WARM_UP;
        }

        /** \brief Counts a check and its samples */
        void count(std::uint64_t samples)
        {
            ++checks_;
            samples_ += samples;
            if (!usesCertificates_ && samples_ >= nextUse_)
                begin();
            else if (takesTurns_ && checks_ == nextTrial_ + 2 * TURN)
                judge(static_cast<double>(checks_ - firstCheck_), static_cast<double>(samples_ - firstSample_));
        }

        /** \brief Whether to use certificates for a check that is no trial */
        bool usesCertificates() const
        {
            return usesCertificates_ && !(takesTurns_ && checks_ >= nextTrial_ + TURN);
        }

        /** \brief Whether the trial begins with the standard check. In turn, since the second has the warmer cache. */
        bool beginsWithStandard() const
        {
            return standard_.count() % 2 == 1;
        }

        /** \brief Notes how long the same check of \e samples samples took in either way */
        void note(std::uint64_t samples, std::chrono::nanoseconds certified, std::chrono::nanoseconds standard);

        /** \brief Notes how long a timed check of \e samples samples took, by the way whose turn it is. Before
            count() */
        void noteTurn(std::uint64_t samples, std::chrono::nanoseconds time)
        {
            (usesCertificates() ? certified_ : standard_).add(samples, time);
        }

        /** \brief Notes how long a check with certificates took that is no trial, and how long it would have taken
            without, in nanoseconds. Such an estimate is rough, so it decides only about the beginning: in a short plan,
            a few trials cost more than all other checks. Where certificates clearly pay by it, the first trial waits.
            Where they lose, the standard check goes on for a while without one. */
        void noteEstimate(std::chrono::nanoseconds certified, double standard);

        /** \brief Whether it has counted no check yet */
        bool isNew() const
        {
            return checks_ == 0;
        }

        /** \brief Sets after how many samples certificates are first used. For a new policy. */
        void setFirstUse(std::uint64_t samples)
        {
            nextUse_ = samples;
            if (samples == 0)
                begin();
        }

    private:
        /** \brief While an estimate says that checks with certificates are so many times as fast, the first trial
            comes after so many checks. Estimates remember about so many checks. */
        static constexpr double CLEARLY = 2.0;
        static constexpr std::uint64_t CHECKS_BEFORE_TRIAL = 32;
        static constexpr double ESTIMATE_MEMORY = 8.0;

        /** \brief Whether certificates pay so clearly that a rough estimate is enough, for a while */
        bool paysClearly() const
        {
            return estimated_ > CLEARLY * measured_;
        }

        /** \brief How many checks a turn has. The first ones only warm up the caches, and what a processor learns of
            the branches. */
        static constexpr std::uint64_t TURN = 128, WARM_UP = 32;

        /** \brief How many checks the times remember, in trials and in turns */
        static constexpr double TRIAL_MEMORY = 48.0, TURN_MEMORY = 512.0;

        /** \brief Begins to use certificates. The first check is no trial: it prepares shapes and memory. */
        void begin();

        /** \brief Lets the ways take turns from the next check on */
        void beginTurns();

        /** \brief Whether certificates go on, by the times noted so far, and when they are compared next */
        void judge(double checksInUse, double samplesInUse);

        std::uint64_t checks_{0}, samples_{0};

        /** \brief The number of samples when certificates are next taken into use, and of checks when the next trial
            is, or the next turns begin */
        std::uint64_t nextUse_{0}, nextTrial_{0};

        /** \brief The numbers of samples and of checks when certificates were last taken into use */
        std::uint64_t firstSample_{0}, firstCheck_{0};

        /** \brief The times compared since then */
        CheckTimes certified_{TRIAL_MEMORY}, standard_{TRIAL_MEMORY};

        /** \brief Running means of the times of other checks since then, without certificates and with them. Both begin
            at 0, so only their ratio counts. */
        double estimated_{0.0}, measured_{0.0};

        bool usesCertificates_{false}, takesTurns_{false};
    };
}

#endif
