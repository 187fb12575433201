#ifndef OMPL_CERTIFICATES_CERTIFICATES_EXACT_CHECK_
#define OMPL_CERTIFICATES_CERTIFICATES_EXACT_CHECK_

#include "SwitchingPolicy.h"

#include "ompl_certificates/certificates/CheckCounts.h"
#include "ompl_certificates/obstacles/Obstacles.h"

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

    /** \brief Whether a body collides: by the contact test if \e contact, then by the exact check if needed
        \param by set to the test that settled it
        \param hit set to a part that the body touches, or to NO_PART */
    inline bool collides(const Obstacles &obstacles, const Body &body, const Pose &pose, bool contact, SettledBy &by,
                         ObstaclePart &hit, CheckCounts &counts)
    {
        hit = NO_PART;
        if (contact)
        {
            by = SettledBy::CONTACT;
            ++counts.contactTests;
            const Touching touching = obstacles.touches(body, pose, &hit);
            if (touching != Touching::UNKNOWN)
                return touching == Touching::YES;
        }
        by = SettledBy::EXACT_CHECK;
        ++counts.exactCalls;
        return obstacles.collides(body, pose);
    }
}

#endif
