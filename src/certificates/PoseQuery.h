#ifndef OMPL_CERTIFICATES_CERTIFICATES_POSE_QUERY_
#define OMPL_CERTIFICATES_CERTIFICATES_POSE_QUERY_

#include "ompl_certificates/certificates/Certificate.h"
#include "ompl_certificates/certificates/CheckCounts.h"
#include "ompl_certificates/geometry/Body.h"
#include "ompl_certificates/geometry/MotionBound.h"

#include <limits>

namespace ompl_certificates
{
    /** \brief The question whether a body touches the obstacles */
    struct PoseQuery
    {
        /** \brief The body */
        const Body &body;

        /** \brief Where its frame is */
        const Pose &pose;

        /** \brief How fast the body moves, which determines the valid interval; null if it does not move */
        const MotionBound *motionBound{nullptr};

        /** \brief If positive, a few balls of the sphere tree must be proved free for this long, in time of the motion.
            That verdict depends only on the obstacles and the motion, not on the certificates kept. If 0, or if the
            body stands still, a pose that clearances do not settle gets the exact check. */
        double requiredInterval{0.0};

        /** \brief How many samples a proof for the whole motion would probably spare, if the pose lies between free
            ends; else 0. Such a pose is probably free, so collisions are tried last. */
        double samplesAhead{0.0};

        /** \brief The largest speed of the center of a ball of the body */
        double speedOf(const Ball &ball) const
        {
            return motionBound ? motionBound->at(ball.center.norm()) : 0.0;
        }

        /** \brief Whether the body does not move: then one pose speaks for the whole motion */
        bool standsStill() const
        {
            return !motionBound || (motionBound->linear == 0.0 && motionBound->angular == 0.0);
        }

        /** \brief Whether only a proof settles the body as free, unless it stands still */
        bool isProofOnly() const
        {
            return requiredInterval > 0.0;
        }

        /** \brief The largest distance that the center of a ball of the body moves within requiredInterval */
        double leastSlack(const Ball &ball) const
        {
            return isProofOnly() ? requiredInterval * speedOf(ball) : 0.0;
        }
    };

    /** \brief The answer to a PoseQuery */
    struct PoseVerdict
    {
        /** \brief Whether the body touches no obstacle */
        bool free{false};

        /** \brief The body is free while the motion's time differs by less than this; 0 if no clearance proves that */
        double validInterval{0.0};

        /** \brief A certificate that took part in the proof, or NO_CERTIFICATE */
        CertificateIndex reference{NO_CERTIFICATE};

        /** \brief What settled the pose */
        SettledBy by{SettledBy::CERTIFICATE};

        /** \brief The clearance at the center of the body's bounding sphere; NaN if it was not measured */
        double clearance{std::numeric_limits<double>::quiet_NaN()};
    };
}

#endif
