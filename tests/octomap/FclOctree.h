#ifndef OMPL_CERTIFICATES_TESTS_OCTOMAP_FCL_OCTREE_
#define OMPL_CERTIFICATES_TESTS_OCTOMAP_FCL_OCTREE_

#include "ompl_certificates/geometry/Body.h"

#include <fcl/geometry/octree/octree.h>
#include <fcl/narrowphase/collision.h>
#include <octomap/OcTree.h>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief FCL's verdict on bodies among the cells of an octomap */
        class FclOctree
        {
        public:
            explicit FclOctree(const octomap::OcTree &map) : map_(std::make_shared<octomap::OcTree>(map))
            {
                // As large as the shapes that FCL is given
                map_->setResolution(Shape::FCL_SCALE * map.getResolution());
                octree_ = std::make_unique<fcl::OcTreed>(map_);
                octree_->computeLocalAABB();
            }

            bool collides(const Body &body, const Pose &pose) const
            {
                for (const auto &part : body.getParts())
                {
                    Pose placed = pose * part.pose;
                    placed.translation() *= Shape::FCL_SCALE;
                    fcl::CollisionRequestd request;
                    fcl::CollisionResultd result;
                    if (fcl::collide(octree_.get(), fcl::Transform3d::Identity(),
                                     part.shape.getCollisionGeometry().get(), fcl::Transform3d(placed), request,
                                     result) > 0)
                        return true;
                }
                return false;
            }

        private:
            std::shared_ptr<octomap::OcTree> map_;
            std::unique_ptr<fcl::OcTreed> octree_;
        };
    }
}

#endif
