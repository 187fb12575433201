#ifndef OMPL_CERTIFICATES_VALIDITY_BODY_FRAME_
#define OMPL_CERTIFICATES_VALIDITY_BODY_FRAME_

#include "certificates/CertifiedEnvironment.h"
#include "geometry/BodyContact.h"
#include "geometry/WithinDistance.h"
#include "obstacles/FclTolerance.h"
#include "obstacles/SpatialCheck.h"

#include "ompl_certificates/obstacles/FclObstacles.h"

#include <memory>
#include <mutex>

namespace ompl_certificates
{
    /** \brief A body as the environment of others, seen from its own frame.

        Most pairs never need it as obstacles, and to make these may take milliseconds for meshes. So they are made when
        first asked for. */
    class BodyFrame
    {
    public:
        /** \brief The frame of \e body, which has no padding; \e limit is that of its certificates */
        BodyFrame(const Body &body, const ZInterval &zInterval, std::shared_ptr<CertificateLimit> limit)
          : body_(body), zInterval_(zInterval), limit_(std::move(limit)), tolerance_(fclTolerance(shapesOf(body), 0.0))
        {
        }

        /** \brief The body */
        const Body &getBody() const
        {
            return body_;
        }

        /** \brief Whether another body touches this one, without FCL */
        Touching touches(const Body &other, const Pose &pose) const
        {
            if (body_.getDimension() == 2)
                return getObstacles().touches(other, pose, nullptr);
            if (other.getPadding() > 0.0)
                return collides(other, pose) ? Touching::YES : Touching::NO;
            return touching(body_, other, pose, getContactMargin(other));
        }

        /** \brief Whether another body touches this one, by FCL, or by areWithin() if it is padded */
        bool collides(const Body &other, const Pose &pose) const
        {
            if (body_.getDimension() == 2)
                return getObstacles().collides(other, pose);
            if (other.getPadding() > 0.0)
                return areWithin(body_, other, pose, other.getPadding());
            // FCL alone needs nothing else, and as obstacles the body may have a tree to be made.
            std::call_once(fclMade_, [this] { fcl_ = std::make_unique<SpatialCheck>(shapesOf(body_)); });
            return fcl_->collides(other, pose);
        }

        /** \brief How much a gap to this body must exceed zero for FCL to see it; see Obstacles::getTolerance() */
        double getTolerance() const
        {
            return tolerance_;
        }

        /** \brief The margin of the contact test of bodies of space */
        double getContactMargin(const Body &other) const
        {
            return tolerance_ + exactCheckTolerance(other.getBoundingRadius());
        }

        /** \brief The body as obstacles */
        const FclObstacles &getObstacles() const
        {
            makeObstacles();
            return *obstacles_;
        }

        /** \brief The certificates about it */
        CertifiedEnvironment &getCertified() const
        {
            makeObstacles();
            return *certified_;
        }

        /** \brief Removes the certificates. Not while others use them. */
        void clear()
        {
            if (certified_)
                certified_->clear();
        }

    private:
        void makeObstacles() const
        {
            std::call_once(made_,
                           [this]
                           {
                               obstacles_ = std::make_shared<FclObstacles>(std::vector<PlacedBody>{{body_}},
                                                                           body_.getDimension(), zInterval_);
                               certified_ = std::make_unique<CertifiedEnvironment>(obstacles_, limit_);
                           });
        }

        const Body body_;
        const ZInterval zInterval_;
        const std::shared_ptr<CertificateLimit> limit_;
        const double tolerance_;
        mutable std::once_flag fclMade_;
        mutable std::unique_ptr<SpatialCheck> fcl_;
        mutable std::once_flag made_;
        mutable std::shared_ptr<FclObstacles> obstacles_;
        mutable std::unique_ptr<CertifiedEnvironment> certified_;
    };
}

#endif
