#ifndef OMPL_CERTIFICATES_OBSTACLES_OBSTACLE_CHANGE_
#define OMPL_CERTIFICATES_OBSTACLES_OBSTACLE_CHANGE_

#include "ompl_certificates/obstacles/Obstacles.h"

#include <algorithm>

namespace ompl_certificates
{
    /** \brief What has become of obstacles, with which clearances that are known can be repaired. ObstacleSet makes these;
        for obstacles of another kind make them yourself. */
    struct ObstacleChange
    {
        /** \brief All obstacles, as they are now */
        ObstaclesPtr after;

        /** \brief Those that have come; null if none has. One that has moved has gone and come. */
        ObstaclesPtr added;

        /** \brief Those that have gone; null if none has */
        ObstaclesPtr removed;

        /** \brief The clearance now of \e point, whose clearance was \e before. All obstacles are asked only where what has
            gone was nearest. */
        double clearance(const Eigen::Vector3d &point, double before) const
        {
            if (removed &&
                removed->clearance(point) <= before + std::max(removed->getTolerance(), after->getTolerance()))
                return after->clearance(point);
            return added ? std::min(before, added->clearance(point)) : before;
        }
    };
}

#endif
