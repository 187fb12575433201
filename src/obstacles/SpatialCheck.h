#ifndef OMPL_CERTIFICATES_OBSTACLES_SPATIAL_CHECK_
#define OMPL_CERTIFICATES_OBSTACLES_SPATIAL_CHECK_

#include "Broadphase.h"
#include "FclCheck.h"
#include "PlacedShape.h"

namespace ompl_certificates
{
    /** \brief FCL's check in space: every shape against every other */
    class SpatialCheck : public FclCheck
    {
    public:
        explicit SpatialCheck(const PlacedShapes &obstacles);

        bool collides(const Body &body, const Pose &pose) const override;

    private:
        Broadphase shapes_;
    };
}

#endif
