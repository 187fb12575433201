#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_FORWARDING_OBSTACLES_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_FORWARDING_OBSTACLES_

#include "ompl_certificates/obstacles/Obstacles.h"

#include <memory>
#include <utility>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief Obstacles of a user's own that know of others what every class must know, paddings, and nothing
            more */
        class ForwardingObstacles : public Obstacles
        {
        public:
            explicit ForwardingObstacles(ObstaclesPtr obstacles) : obstacles_(std::move(obstacles))
            {
            }

            unsigned int getDimension() const override
            {
                return obstacles_->getDimension();
            }

            bool collides(const Body &body, const Pose &pose) const override
            {
                return obstacles_->collides(body, pose);
            }

            bool knowsPadding() const override
            {
                return obstacles_->knowsPadding();
            }

            double clearance(const Eigen::Vector3d &point) const override
            {
                return obstacles_->clearance(point);
            }

            double getTolerance() const override
            {
                return obstacles_->getTolerance();
            }

        protected:
            ObstaclesPtr obstacles_;
        };
    }
}

#endif
