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

        /** \brief How fast the body moves, to find how long its verdict lasts; null if it does not move */
        const MotionBound *travel{nullptr};

        /** \brief If positive, the body counts as free only if a few balls of its sphere tree are proved free for this long, in
            time of the motion. That verdict depends on the obstacles and the motion alone, not on what is known of them.
            If 0, a pose that clearances do not settle gets the exact check. */
        double requiredInterval{0.0};

        /** \brief How many samples a proof probably spares that lasts for all of the motion, if the pose lies between free ends;
            else 0. Such a pose is probably free, so collisions are tried last. */
        double samplesAhead{0.0};

        /** \brief How fast the center of a ball of the body moves, at most */
        double speedOf(const Ball &ball) const
        {
            return travel ? travel->at(ball.center.norm()) : 0.0;
        }

        /** \brief Whether only a proof settles the body as free */
        bool isProofOnly() const
        {
            return requiredInterval > 0.0;
        }

        /** \brief How far the center of a ball of the body moves within requiredInterval, at most */
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

        /** \brief The body is free while the motion's time differs by less than this; 0 if no clearance says so */
        double validInterval{0.0};

        /** \brief A certificate that took part in the proof, or NO_CERTIFICATE */
        CertificateIndex reference{NO_CERTIFICATE};

        /** \brief What settled the pose */
        SettledBy by{SettledBy::CERTIFICATE};

        /** \brief The clearance of the center of the body's enclosing ball; not a number if it was not measured */
        double clearance{std::numeric_limits<double>::quiet_NaN()};
    };
}

#endif
