#ifndef OMPL_CERTIFICATES_GEOMETRY_BATCH_OVERLAP_
#define OMPL_CERTIFICATES_GEOMETRY_BATCH_OVERLAP_

#include "ompl_certificates/geometry/Pose.h"
#include "ompl_certificates/geometry/PoseBatch.h"

namespace ompl_certificates
{
    // In which states of a batch bounding volumes may touch. A state that is left out is certain: there they are apart.
    // A state is never left out whose numbers are not numbers (NaN). Those with infinite ones may be: see notFinite().

    /** \brief Where a point is in each state of a batch */
    struct PointBatch
    {
        alignas(32) float at[3][PoseBatch::SIZE];
    };

    /** \brief Write where the point \e local of a body is
        \return how far rounding may have moved it, at most, in any of the states; without the error of the poses */
    double placePoint(const PoseBatch &poses, const Eigen::Vector3d &local, PointBatch &point);

    /** \brief The states in which a point has numbers that are not finite */
    BatchMask notFinite(const PointBatch &point);

    /** \brief The states in which two points may be within \e distance of each other */
    BatchMask arePointsNear(const PointBatch &a, const PointBatch &b, double distance);

    /** \brief A box in a body's frame, and where the body is */
    struct BoxBatch
    {
        const Eigen::AlignedBox3d &box;
        const PoseBatch &poses;
        PoseError error;
    };

    /** \brief The states in which two boxes may be within \e margin of each other: no face of either separates them */
    BatchMask mayOverlap(const BoxBatch &a, const BoxBatch &b, double margin);

    /** \brief The same for a box that stands still
        \param toStanding from the workspace to the frame of \e standing */
    BatchMask mayOverlap(const Eigen::AlignedBox3d &standing, const Pose &toStanding, const BoxBatch &moving,
                         double margin);
}

#endif
