#ifndef OMPL_CERTIFICATES_OBSTACLES_PLANAR_CHECK_
#define OMPL_CERTIFICATES_OBSTACLES_PLANAR_CHECK_

#include "Broadphase.h"
#include "FclCheck.h"
#include "PlacedShape.h"
#include "Prisms.h"

#include "ompl_certificates/geometry/ZInterval.h"

namespace ompl_certificates
{
    /** \brief FCL's check in the plane. Primitives are checked against primitives in the plane, meshes against meshes
        at their true z, and primitives against meshes as prisms that are high enough. */
    class PlanarCheck : public FclCheck
    {
    public:
        /** \param meshZInterval the intersection of the obstacles' meshes' z-interval with the robots' */
        PlanarCheck(const PlacedShapes &obstacles, const ZInterval &meshZInterval);

        bool collides(const Body &body, const Pose &pose) const override;

    private:
        bool meshCollides(const Shape &shape, const Pose &partPose) const;
        bool primitiveCollides(const Shape &shape, const Pose &partPose) const;

        Broadphase primitives_;
        Broadphase meshes_;
        ZInterval meshZInterval_;
        RobotPrisms robotPrisms_;
        ObstaclePrisms obstaclePrisms_;
    };
}

#endif
