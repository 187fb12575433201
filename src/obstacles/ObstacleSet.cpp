#include "ompl_certificates/obstacles/ObstacleSet.h"

#include "ompl_certificates/obstacles/FclObstacles.h"

#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    ObstacleSet::ObstacleSet(unsigned int dimension, const ZInterval &zInterval)
      : dimension_(dimension), zInterval_(zInterval)
    {
        make({});
    }

    ObstaclesPtr ObstacleSet::make(const std::vector<PlacedBody> &obstacles) const
    {
        return std::make_shared<FclObstacles>(obstacles, dimension_, zInterval_);
    }

    std::map<ObstacleSet::Id, PlacedBody>::iterator ObstacleSet::find(Id obstacle)
    {
        const auto found = obstacles_.find(obstacle);
        if (found == obstacles_.end())
            throw ompl::Exception("There is no obstacle " + std::to_string(obstacle));
        return found;
    }

    ObstacleSet::Id ObstacleSet::add(const PlacedBody &obstacle)
    {
        // Refuse a bad obstacle here, not when the change is taken.
        make({obstacle});
        obstacles_.emplace(next_, obstacle);
        return next_++;
    }

    void ObstacleSet::move(Id obstacle, const Pose &pose)
    {
        PlacedBody &moved = find(obstacle)->second;
        make({{moved.body, pose}});
        moved.pose = pose;
    }

    void ObstacleSet::remove(Id obstacle)
    {
        obstacles_.erase(find(obstacle));
    }

    std::vector<PlacedBody> ObstacleSet::getObstacles() const
    {
        std::vector<PlacedBody> obstacles;
        for (const auto &[id, obstacle] : obstacles_)
            obstacles.push_back(obstacle);
        return obstacles;
    }

    ObstacleChange ObstacleSet::takeChange()
    {
        std::vector<PlacedBody> all, added, removed;
        const auto isIn = [](const std::map<Id, PlacedBody> &others, Id id, const Pose &pose)
        {
            const auto found = others.find(id);
            return found != others.end() && found->second.pose.matrix() == pose.matrix();
        };
        for (const auto &[id, obstacle] : obstacles_)
        {
            all.push_back(obstacle);
            if (!isIn(taken_, id, obstacle.pose))
                added.push_back(obstacle);
        }
        for (const auto &[id, obstacle] : taken_)
            if (!isIn(obstacles_, id, obstacle.pose))
                removed.push_back(obstacle);
        if (after_ && added.empty() && removed.empty())
            return {after_, nullptr, nullptr, {}, after_};
        std::map<Id, PlacedBody> taken = obstacles_;
        ObstacleChange change;
        change.after = make(all);
        if (!added.empty())
            change.added = make(added);
        if (!removed.empty())
            change.removed = make(removed);
        taken_.swap(taken);
        change.before = after_ ? after_ : make({});
        after_ = change.after;
        return change;
    }
}
