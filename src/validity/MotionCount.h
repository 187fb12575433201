#ifndef OMPL_CERTIFICATES_VALIDITY_MOTION_COUNT_
#define OMPL_CERTIFICATES_VALIDITY_MOTION_COUNT_

namespace ompl_certificates
{
    /** \brief Count a motion. OMPL counts motions in plain integers, but validators are used by many threads. */
    inline void countMotion(unsigned int &counter)
    {
        __atomic_fetch_add(&counter, 1U, __ATOMIC_RELAXED);
    }
}

#endif
