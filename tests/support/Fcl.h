#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_FCL_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_FCL_

#include "ompl_certificates/geometry/Body.h"

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief FCL's verdict on two bodies at their poses in the workspace */
        inline bool touchForFcl(const Body &a, const Pose &poseA, const Body &b, const Pose &poseB)
        {
            for (const auto &partA : a.getParts())
                for (const auto &partB : b.getParts())
                {
                    fcl::Transform3d first(poseA * partA.pose), second(poseB * partB.pose);
                    first.translation() *= Shape::FCL_SCALE;
                    second.translation() *= Shape::FCL_SCALE;
                    fcl::CollisionRequestd request;
                    fcl::CollisionResultd result;
                    if (fcl::collide(partA.shape.getCollisionGeometry().get(), first,
                                     partB.shape.getCollisionGeometry().get(), second, request, result) > 0)
                        return true;
                }
            return false;
        }
    }
}

#endif
