#ifndef OMPL_CERTIFICATES_CERTIFICATES_CONTACT_THEN_FCL_
#define OMPL_CERTIFICATES_CERTIFICATES_CONTACT_THEN_FCL_

#include "ompl_certificates/certificates/CheckCounts.h"
#include "ompl_certificates/obstacles/Obstacles.h"

namespace ompl_certificates
{
    /** \brief Whether a body collides: by the contact test if \e contact, then by FCL if needed
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
