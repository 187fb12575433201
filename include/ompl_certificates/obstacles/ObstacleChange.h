#ifndef OMPL_CERTIFICATES_OBSTACLES_OBSTACLE_CHANGE_
#define OMPL_CERTIFICATES_OBSTACLES_OBSTACLE_CHANGE_

#include "ompl_certificates/obstacles/Obstacles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ompl_certificates
{
    /** \brief What has changed among obstacles, for the repair of known clearances. Sets make these, such as ObstacleSet;
        see replacing() for obstacles that are new altogether. */
    struct ObstacleChange
    {
        /** \brief The change from all obstacles \e before to others: all that is known of them is given up. Both may be
            the same object, if what it stands for has changed while nobody checked. */
        static ObstacleChange replacing(const ObstaclesPtr &before, const ObstaclesPtr &after)
        {
            return {after, after, before, {}, before};
        }

        /** \brief All obstacles, as they are now */
        ObstaclesPtr after;

        /** \brief The obstacles that were added; null if none. One that has moved was removed and added. */
        ObstaclesPtr added;

        /** \brief The obstacles that were removed; null if none */
        ObstaclesPtr removed;

        /** \brief The changes of the members of \e after, if mixedChange() made this; else none */
        std::vector<ObstacleChange> members{};

        /** \brief All obstacles, as they were before; null if that is not known. A checker among others has missed a
            change, and gives up all that it knows of them. */
        ObstaclesPtr before{};

        /** \brief The new clearance of \e point, whose clearance was \e known. Asks all obstacles only where a removed
            one was nearest. */
        double clearance(const Eigen::Vector3d &point, double known) const
        {
            if (removed && isWithin(*removed, point, known + std::max(removed->getTolerance(), after->getTolerance())))
                return after->clearance(point);
            return added ? std::min(known, added->clearanceUpTo(point, known)) : known;
        }

        /** \brief Whether something was added or removed within \e radius of \e center, or almost. If not, a
            certificate keeps its clearance if its ball is within that distance. */
        bool concerns(const Eigen::Vector3d &center, double radius) const
        {
            const double most = radius + 2.0 * after->getTolerance();
            return (added && isWithin(*added, center, most)) ||
                   (removed && isWithin(*removed, center, most + removed->getTolerance()));
        }

    private:
        static bool isWithin(const Obstacles &obstacles, const Eigen::Vector3d &point, double distance)
        {
            const double beyond = std::nextafter(distance, std::numeric_limits<double>::infinity());
            return obstacles.clearanceUpTo(point, beyond) <= distance;
        }
    };
}

#endif
