#ifndef OMPL_CERTIFICATES_TEAM_ROBOT_FILTER_
#define OMPL_CERTIFICATES_TEAM_ROBOT_FILTER_

#include "ompl_certificates/geometry/PointCloud.h"
#include "ompl_certificates/team/Team.h"

#include <vector>

namespace ompl_certificates
{
    /** \brief The cloud without the team that was seen with it. Drops points that are nearer to a body than \e padding
        and the cloud's radius, or inside it, so that the state collides with no point. A mesh has an inside where
        pieces of it are closed, whichever way their triangles are wound; loose triangles beside them do no harm. Of
        other pieces only points near their triangles are dropped. Points that are not finite stay.
        \param team the robots
        \param state where they were, in the team's space
        \param padding the error of the sensor and of the state, in the scene's length unit. The paddings of the bodies
        are added, see Body::padded().
        \throws ompl::Exception if padding or radius is negative or not finite, or the state is not finite
        Cost: some nanoseconds per point and body; logarithmic in the triangles of a mesh. */
    PointCloud withoutRobots(PointCloud cloud, const Team &team, const ompl::base::State *state, double padding);

    /** \brief Which points withoutRobots() drops, in their order: for those whose points have colors or intensities
        \throws ompl::Exception as withoutRobots() */
    std::vector<bool> findRobots(const PointCloud &cloud, const Team &team, const ompl::base::State *state,
                                 double padding);
}

#endif
