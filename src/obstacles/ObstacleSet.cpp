#include "ompl_certificates/obstacles/ObstacleSet.h"

#include "ompl_certificates/obstacles/FclObstacles.h"

#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    ObstacleSet::ObstacleSet(unsigned int dimension, const ZInterval &zInterval)
      : dimension_(dimension), after_(std::make_shared<FclObstacles>(std::vector<PlacedBody>(), dimension, zInterval))
    {
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
        FclObstacles::requireObstacle(obstacle, dimension_);
        obstacles_.emplace(next_, obstacle);
        return next_++;
    }

    void ObstacleSet::move(Id obstacle, const Pose &pose)
    {
        PlacedBody &moved = find(obstacle)->second;
        try
        {
            FclObstacles::requireObstacle({moved.body, pose}, dimension_);
        }
        catch (const ompl::Exception &exception)
        {
            throw ompl::Exception("obstacle " + std::to_string(obstacle), exception.what());
        }
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
        if (isTaken_ && added.empty() && removed.empty())
            return {after_, nullptr, nullptr, {}, after_};
        std::map<Id, PlacedBody> taken = obstacles_;
        const auto after = std::make_shared<FclObstacles>(all, *after_);
        ObstacleChange change;
        change.after = after;
        if (!added.empty())
            change.added = std::make_shared<FclObstacles>(added, *after);
        if (!removed.empty())
            change.removed = std::make_shared<FclObstacles>(removed, *after_);
        taken_.swap(taken);
        change.before = after_;
        after_ = after;
        isTaken_ = true;
        return change;
    }
}
