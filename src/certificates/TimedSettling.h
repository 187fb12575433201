#ifndef OMPL_CERTIFICATES_CERTIFICATES_TIMED_SETTLING_
#define OMPL_CERTIFICATES_CERTIFICATES_TIMED_SETTLING_

#include "SwitchingPolicy.h"

#include <chrono>

namespace ompl_certificates
{
    /** \brief The way a policy chooses for one pose. If the pose is timed, reports to the policy how long each step
        took. */
    class TimedSettling
    {
    public:
        explicit TimedSettling(SwitchingPolicy &policy)
          : policy_(policy), timed_(policy.isTimed()), asksClearances_(policy.asksClearances(timed_))
        {
            if (timed_)
                start_ = std::chrono::steady_clock::now();
        }

        /** \brief Whether to ask clearances first */
        bool asksClearances() const
        {
            return asksClearances_;
        }

        /** \brief Reports that clearances were asked and settled that many samples */
        void noteClearances(double samples)
        {
            if (timed_)
                policy_.noteClearances(lap(), samples);
        }

        /** \brief Reports that the exact check, or the contact test before it, settled the pose */
        void noteExact()
        {
            if (timed_)
                policy_.noteExact(asksClearances_, lap());
        }

    private:
        std::chrono::nanoseconds lap()
        {
            const auto now = std::chrono::steady_clock::now();
            const std::chrono::nanoseconds elapsed = now - start_;
            start_ = now;
            return elapsed;
        }

        SwitchingPolicy &policy_;
        const bool timed_;
        const bool asksClearances_;
        std::chrono::steady_clock::time_point start_;
    };
}

#endif
