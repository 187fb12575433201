#ifndef OMPL_CERTIFICATES_CERTIFICATES_EXACT_CHECK_
#define OMPL_CERTIFICATES_CERTIFICATES_EXACT_CHECK_

#include "SwitchingPolicy.h"

#include "ompl_certificates/certificates/CheckCounts.h"
#include "ompl_certificates/obstacles/Obstacles.h"

#include <chrono>

namespace ompl_certificates
{
    /** \brief Settles a pose in the way that a policy chooses, and tells it how long that took if it is the pose's turn */
    class TimedSettling
    {
    public:
        TimedSettling(SwitchingPolicy &policy, SwitchingPolicy::Choice choice)
          : policy_(policy), timed_(policy.isTimed()), way_(policy.choose(choice, timed_))
        {
            if (timed_)
                start_ = std::chrono::steady_clock::now();
        }

        SwitchingPolicy::Way getWay() const
        {
            return way_;
        }

        /** \brief Clearances were asked, and have settled that many samples */
        void noteClearances(double samples)
        {
            if (timed_)
                policy_.noteClearances(lap(), samples);
        }

        /** \brief The exact check was made, or the contact test was enough */
        void noteExact()
        {
            if (timed_)
                policy_.noteExact(way_, lap());
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
        const SwitchingPolicy::Way way_;
        std::chrono::steady_clock::time_point start_;
    };

    /** \brief Whether a body collides, by the contact test if \e contact, and by the exact check if that does not tell
        \param by set to which of them has settled it
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

    /** \brief Whether a body collides, by a check that remembers nothing: the contact test where it pays, then the exact
        check. A pose that is not finite collides.
        \param policy whether the contact test pays; the exact check alone if null
        \param by set to what has settled it; as it was if the pose is not finite */
    inline bool collidesWithoutMemory(const Obstacles &obstacles, const Body &body, const Pose &pose,
                                      SwitchingPolicy *policy, SettledBy &by, CheckCounts &counts)
    {
        if (!isFinite(pose))
            return true;
        ObstaclePart hit;
        if (!policy)
            return collides(obstacles, body, pose, false, by, hit, counts);
        TimedSettling settling(*policy, SwitchingPolicy::WITHOUT_CLEARANCES);
        const bool collide = collides(obstacles, body, pose, settling.getWay().contact, by, hit, counts);
        settling.noteExact();
        return collide;
    }
}

#endif
