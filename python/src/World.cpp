#include "World.h"

#include <ompl_certificates/geometry/PointCloud.h>
#include <ompl_certificates/obstacles/CellObstacles.h>
#include <ompl_certificates/obstacles/MixedObstacles.h>

#include <ompl/util/Exception.h>
#include <utility>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        /** Do \e work; what it throws names \e where, too. */
        template <typename Work>
        void orFail(const std::string &where, const Work &work)
        {
            try
            {
                work();
            }
            catch (const ompl::Exception &exception)
            {
                throw ompl::Exception(where, exception.what());
            }
        }
    }

    std::vector<Eigen::Vector3d> inPlane(CloudPoints points, double radius, const ZInterval &heights,
                                         const std::string &what)
    {
        // A height that is no number would be outside all heights, and the point would vanish.
        for (const Eigen::Vector3d &point : points.points)
            if (!point.allFinite())
                throw ompl::Exception(what, "must be finite");
        if (!points.haveHeights)
            return std::move(points.points);
        return sliced({std::move(points.points), radius}, heights).points;
    }

    World::World(const Scene &scene)
      : dimension_(scene.getDimension()), heights_(scene.getZInterval()), bodies_(dimension_, heights_)
    {
        for (std::size_t i = 0; i < scene.getObstacles().size(); ++i)
            titles_[bodies_.add(scene.getObstacles()[i])] = scene.getObstacleTitles()[i];
        bodiesNow_ = bodies_.takeChange().after;
        for (std::size_t i = 0; i < scene.getSensedObstacles().size(); ++i)
            sensed_.push_back({scene.getSensedObstacles()[i], scene.getSensedTitles()[i]});
    }

    ObstaclesPtr World::getObstacles() const
    {
        // Who adds a cloud for each scan and clears the last one should not pay for all that there were.
        const auto isEmpty = [](const Sensed &sensed)
        {
            const auto *cloud = dynamic_cast<const PointCloudObstacles *>(sensed.obstacles.get());
            return cloud && cloud->size() == 0;
        };
        std::vector<ObstaclesPtr> all;
        for (const Sensed &sensed : sensed_)
            if (!isEmpty(sensed))
                all.push_back(sensed.obstacles);
        if (bodies_.size() > 0 || all.empty())
            all.insert(all.begin(), bodiesNow_);
        return all.size() == 1 ? all.front() : std::make_shared<MixedObstacles>(all);
    }

    void World::addTo(Scene &scene) const
    {
        const std::vector<PlacedBody> bodies = bodies_.getObstacles();
        auto body = bodies.begin();
        for (const auto &[number, title] : titles_)
            scene.addObstacle(*body++, title);
        for (const Sensed &sensed : sensed_)
            scene.addSensedObstacles(sensed.obstacles, sensed.title);
    }

    ObstacleChange World::ofWorld(ObstacleChange change) const
    {
        change.after = getObstacles();
        // Not those of the set alone. The checkers of this world miss no change.
        change.before = nullptr;
        return change;
    }

    ObstacleChange World::changeBodies(const BodyChange &change, std::vector<ObstacleSet::Id> &numbers)
    {
        ObstacleSet bodies = bodies_;
        for (const ObstacleSet::Id number : change.removed)
            bodies.remove(number);
        for (const auto &[number, pose] : change.moved)
            bodies.move(number, pose);
        for (const PlacedBody &body : change.added)
            numbers.push_back(bodies.add(body));
        ObstacleChange result = bodies.takeChange();
        bodies_ = std::move(bodies);
        for (const ObstacleSet::Id number : change.removed)
            titles_.erase(number);
        for (const ObstacleSet::Id number : numbers)
            titles_[number] = "added obstacle " + std::to_string(number);
        bodiesNow_ = result.after;
        return ofWorld(std::move(result));
    }

    ObstacleChange World::addCloud(CloudPoints points, double radius)
    {
        PointCloudSet set(radius, dimension_);
        set.insert(placed(std::move(points), radius, "points"));
        ObstacleChange change = set.takeChange();
        sensed_.push_back({change.after, "added cloud " + std::to_string(sensed_.size()), radius, std::move(set)});
        return ofWorld(std::move(change));
    }

    ObstacleChange World::changeCloud(std::size_t cloud, CloudChange change)
    {
        PointCloudSet set = takeSet(cloud);
        const double radius = *sensed_[cloud].radius;
        const std::vector<Eigen::Vector3d> removed = placed(std::move(change.removed), radius, "remove");
        orFail("cloud " + std::to_string(cloud) + ": remove", [&] { set.remove(removed); });
        if (!change.cleared.isEmpty())
            set.removeWithin(change.cleared);
        std::vector<Eigen::Vector3d> inserted = placed(std::move(change.inserted), radius, "insert");
        orFail("cloud " + std::to_string(cloud) + ": insert", [&] { set.insert(std::move(inserted)); });
        ObstacleChange result = set.takeChange();
        Sensed &sensed = sensed_[cloud];
        sensed.obstacles = result.after;
        sensed.set = std::move(set);
        return ofWorld(std::move(result));
    }

    ObstacleChange World::addGrid(const std::vector<CellBox> &occupied, double size, const Eigen::Vector3d &origin)
    {
        CellSet cells(size, dimension_, origin);
        orFail("occupied", [&] { cells.insert(occupied); });
        ObstacleChange change = cells.takeChange();
        sensed_.push_back({change.after, "added grid " + std::to_string(sensed_.size()), {}, {}, std::move(cells)});
        return ofWorld(std::move(change));
    }

    ObstacleChange World::changeGrid(std::size_t grid, const std::vector<CellBox> &occupied,
                                     const std::vector<CellBox> &free)
    {
        CellSet cells = takeCells(grid);
        cells.remove(free);
        orFail("grid " + std::to_string(grid) + ": occupied", [&] { cells.insert(occupied); });
        ObstacleChange result = cells.takeChange();
        Sensed &sensed = sensed_[grid];
        sensed.obstacles = result.after;
        sensed.cells = std::move(cells);
        return ofWorld(std::move(result));
    }

    std::vector<Eigen::Vector3d> World::getPoints(std::size_t cloud) const
    {
        std::vector<Eigen::Vector3d> points;
        for (const Ball &ball : getCloud(cloud).getBalls())
            points.push_back(ball.center);
        return points;
    }

    const PointCloudObstacles &World::getCloud(std::size_t cloud) const
    {
        if (cloud >= sensed_.size())
            throw ompl::Exception("cloud", "there is none of number " + std::to_string(cloud));
        const auto *points = dynamic_cast<const PointCloudObstacles *>(sensed_[cloud].obstacles.get());
        if (!points)
            throw ompl::Exception("cloud", "number " + std::to_string(cloud) + " is a map of cells, not of points");
        return *points;
    }

    CellSet World::takeCells(std::size_t grid)
    {
        if (grid >= sensed_.size())
            throw ompl::Exception("grid", "there is none of number " + std::to_string(grid));
        if (sensed_[grid].cells)
        {
            // If a change throws, no set is left, and the next change makes one of the cells that are there.
            CellSet set = std::move(*sensed_[grid].cells);
            sensed_[grid].cells.reset();
            return set;
        }
        const auto *cells = dynamic_cast<const CellObstacles *>(sensed_[grid].obstacles.get());
        if (!cells)
            throw ompl::Exception("grid", "number " + std::to_string(grid) + " is a cloud of points, not of cells");
        CellSet set(cells->getCellSize(), dimension_, cells->getOrigin());
        orFail("grid " + std::to_string(grid), [&] { set.insert(cells->getBoxes()); });
        set.takeChange();
        return set;
    }

    std::vector<Eigen::Vector3d> World::placed(CloudPoints points, double radius, const std::string &what) const
    {
        return dimension_ == 2 ? inPlane(std::move(points), radius, heights_, what) : std::move(points.points);
    }

    PointCloudSet World::takeSet(std::size_t cloud)
    {
        if (cloud < sensed_.size() && sensed_[cloud].set)
        {
            // If a change throws, no set is left, and the next change makes one of the points that are there.
            PointCloudSet set = std::move(*sensed_[cloud].set);
            sensed_[cloud].set.reset();
            return set;
        }
        const PointCloudObstacles &now = getCloud(cloud);
        std::optional<double> &radius = sensed_[cloud].radius;
        // A cloud that has seen nothing yet has a radius all the same.
        if (!radius)
            radius = now.getLargestRadius();
        std::vector<Eigen::Vector3d> points;
        for (const Ball &ball : now.getBalls())
        {
            if (ball.radius != *radius)
                throw ompl::Exception("cloud", "the points of number " + std::to_string(cloud) + " differ in radius");
            points.push_back(ball.center);
        }
        PointCloudSet set(*radius, dimension_);
        set.insert(std::move(points));
        set.takeChange();
        return set;
    }
}
