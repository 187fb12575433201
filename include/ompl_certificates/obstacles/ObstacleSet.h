#ifndef OMPL_CERTIFICATES_OBSTACLES_OBSTACLE_SET_
#define OMPL_CERTIFICATES_OBSTACLES_OBSTACLE_SET_

#include "ompl_certificates/geometry/ZInterval.h"
#include "ompl_certificates/obstacles/ObstacleChange.h"

#include <map>
#include <memory>

namespace ompl_certificates
{
    class FclObstacles;

    /** \brief Obstacles that come, go and move.

        The obstacles that a checker uses never change themselves: each change makes new ones, which it is then given.
        @code
        ObstacleSet set(2);
        const ObstacleSet::Id crate = set.add({Body::box(1.0, 1.0), here});
        TeamSetup setup(team, set.takeChange().after);
        ...
        set.move(crate, there);
        setup.getTeamChecker()->changeObstacles(set.takeChange());
        @endcode
        Not for several threads at once. */
    class ObstacleSet
    {
    public:
        /** \brief Identifies an obstacle; never used again after its removal */
        using Id = std::uint64_t;

        /** \brief An empty set, in a workspace of \e dimension 2 or 3
            \param zInterval see FclObstacles::FclObstacles()
            \throws ompl::Exception for another dimension */
        explicit ObstacleSet(unsigned int dimension, const ZInterval &zInterval = {});

        /** \brief Add an obstacle
            \throws ompl::Exception if FclObstacles refuses it */
        Id add(const PlacedBody &obstacle);

        /** \brief Move an obstacle to \e pose
            \throws ompl::Exception if there is none with this id, or if FclObstacles refuses it there */
        void move(Id obstacle, const Pose &pose);

        /** \brief Remove an obstacle
            \throws ompl::Exception if there is none with this id */
        void remove(Id obstacle);

        /** \brief The number of obstacles */
        std::size_t size() const
        {
            return obstacles_.size();
        }

        /** \brief The obstacles now, in the order of their numbers. Cost: a copy of each. */
        std::vector<PlacedBody> getObstacles() const;

        /** \brief The obstacles now, and what was added and removed since the last call; if nothing was, the same
            obstacles again. Cost: that of making FclObstacles of all of them; of meshes, some µs for each triangle, but
            nothing if no mesh came, went or moved. */
        ObstacleChange takeChange();

    private:
        std::map<Id, PlacedBody>::iterator find(Id obstacle);

        unsigned int dimension_;
        Id next_{0};

        /** \brief The obstacles now, and at the last takeChange() */
        std::map<Id, PlacedBody> obstacles_, taken_;
        /** \brief What the last takeChange() made; before the first, no obstacles */
        std::shared_ptr<const FclObstacles> after_;
        bool isTaken_{false};
    };
}

#endif
