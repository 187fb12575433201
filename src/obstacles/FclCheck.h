#ifndef OMPL_CERTIFICATES_OBSTACLES_FCL_CHECK_
#define OMPL_CERTIFICATES_OBSTACLES_FCL_CHECK_

#include "ompl_certificates/geometry/Body.h"

namespace ompl_certificates
{
    /** \brief The exact check of FclObstacles: FCL's verdict on bodies among obstacles. May be called from many threads
        at once. */
    class FclCheck
    {
    public:
        virtual ~FclCheck() = default;

        /** \brief Whether \e body at \e pose touches an obstacle */
        virtual bool collides(const Body &body, const Pose &pose) const = 0;
    };
}

#endif
