#include "World.h"

#include <ompl_certificates/geometry/PointCloud.h>
#include <ompl_certificates/obstacles/MixedObstacles.h>

#include <ompl/util/Exception.h>
#include <sstream>
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

        template <typename Number>
        std::string textOf(const Number &number)
        {
            std::ostringstream text;
            text << number;
            return text.str();
        }

        void requireFinite(const std::vector<Eigen::Vector3d> &points, const std::string &what)
        {
            for (const Eigen::Vector3d &point : points)
                if (!point.allFinite())
                    throw ompl::Exception(what, "must be finite");
        }
    }

    std::vector<Eigen::Vector3d> inPlane(CloudPoints points, double radius, const ZInterval &heights,
                                         const std::string &what)
    {
        // A height that is no number would be outside all heights, and the point would vanish.
        requireFinite(points.points, what);
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
            sensed_[nextSensed_++] = {scene.getSensedObstacles()[i], scene.getSensedTitles()[i]};
    }

    ObstaclesPtr World::getObstacles() const
    {
        // Who clears a cloud or a map should not pay for it.
        const auto isEmpty = [](const Sensed &sensed)
        {
            const auto *cloud = dynamic_cast<const PointCloudObstacles *>(sensed.obstacles.get());
            const auto *grid = dynamic_cast<const CellObstacles *>(sensed.obstacles.get());
            return (cloud && cloud->size() == 0) || (grid && grid->size() == 0);
        };
        std::vector<ObstaclesPtr> all;
        for (const auto &[number, sensed] : sensed_)
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
        for (const auto &[number, sensed] : sensed_)
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
        add({change.after, "", radius, std::move(set)}, "added cloud ");
        return ofWorld(std::move(change));
    }

    ObstacleChange World::changeCloud(std::size_t cloud, CloudChange change)
    {
        PointCloudSet &set = setOf(cloud);
        Sensed &sensed = sensed_.at(cloud);
        const std::string where = "cloud " + std::to_string(cloud);
        const std::vector<Eigen::Vector3d> removed = placed(std::move(change.removed), *sensed.radius, "remove");
        std::vector<Eigen::Vector3d> inserted = placed(std::move(change.inserted), *sensed.radius, "insert");
        // What is refused up to here leaves the set as it is: to make it anew takes as long as hundreds of changes.
        orFail(where + ": remove", [&] { set.remove(removed); });
        try
        {
            if (!change.cleared.isEmpty())
                set.removeWithin(change.cleared);
            orFail(where + ": insert", [&] { set.insert(std::move(inserted)); });
        }
        catch (...)
        {
            sensed.set.reset();
            throw;
        }
        ObstacleChange result = set.takeChange();
        sensed.obstacles = result.after;
        return ofWorld(std::move(result));
    }

    ObstacleChange World::removeCloud(std::size_t cloud)
    {
        getCloud(cloud);
        return remove(cloud);
    }

    void World::add(Sensed sensed, const std::string &title)
    {
        sensed.title = title + std::to_string(nextSensed_);
        sensed_[nextSensed_++] = std::move(sensed);
    }

    ObstacleChange World::remove(std::size_t number)
    {
        ObstacleChange change;
        change.removed = sensed_.at(number).obstacles;
        sensed_.erase(number);
        return ofWorld(std::move(change));
    }

    ObstacleChange World::addGrid(const std::vector<CellBox> &occupied, double size, const Eigen::Vector3d &origin)
    {
        CellSet cells(size, dimension_, origin);
        orFail("occupied", [&] { cells.insert(occupied); });
        ObstacleChange change = cells.takeChange();
        add({change.after, "", {}, {}, std::move(cells)}, "added grid ");
        return ofWorld(std::move(change));
    }

    ObstacleChange World::addMap(std::shared_ptr<const CellObstacles> map)
    {
        ObstacleChange change;
        change.added = map;
        add({std::move(map), ""}, "added map ");
        return ofWorld(std::move(change));
    }

    ObstacleChange World::changeGrid(std::size_t grid, const std::vector<CellBox> &occupied,
                                     const std::vector<CellBox> &free)
    {
        return editGrid(grid,
                        [&](CellSet &cells)
                        {
                            cells.remove(free);
                            orFail("grid " + std::to_string(grid) + ": occupied", [&] { cells.insert(occupied); });
                        });
    }

    ObstacleChange World::replaceGrid(std::size_t grid, const CellObstacles &map)
    {
        const CellObstacles &now = getGrid(grid);
        const std::string where = "grid " + std::to_string(grid);
        if (map.getCellSize() != now.getCellSize())
            throw ompl::Exception(where, "has cells of " + textOf(now.getCellSize()) + ", not of " +
                                             textOf(map.getCellSize()));
        if (map.getOrigin() != now.getOrigin())
            throw ompl::Exception(where, "has its origin at " + textOf(now.getOrigin().transpose()) + ", not at " +
                                             textOf(map.getOrigin().transpose()));
        Sensed &sensed = sensed_.at(grid);
        if (!sensed.cells)
        {
            // The cells that go may be too many for a set.
            CellSet cells(now.getCellSize(), dimension_, now.getOrigin());
            orFail(where, [&] { cells.insert(map.getBoxes()); });
            ObstacleChange change = cells.takeChange();
            change.removed = std::exchange(sensed.obstacles, change.after);
            sensed.cells = std::move(cells);
            return ofWorld(std::move(change));
        }
        return editGrid(grid,
                        [&](CellSet &cells)
                        {
                            constexpr std::int32_t far = CellBox::FARTHEST;
                            const bool isPlanar = dimension_ == 2;
                            cells.remove({{{-far, -far, isPlanar ? 0 : -far}, {far, far, isPlanar ? 1 : far}}});
                            orFail(where, [&] { cells.insert(map.getBoxes()); });
                        });
    }

    ObstacleChange World::removeGrid(std::size_t grid)
    {
        getGrid(grid);
        return remove(grid);
    }

    ObstacleChange World::editGrid(std::size_t grid, const std::function<void(CellSet &)> &edit)
    {
        CellSet &cells = cellsOf(grid);
        Sensed &sensed = sensed_.at(grid);
        try
        {
            edit(cells);
        }
        catch (...)
        {
            sensed.cells.reset();
            throw;
        }
        ObstacleChange result = cells.takeChange();
        sensed.obstacles = result.after;
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
        if (sensed_.count(cloud) == 0)
            throw ompl::Exception("cloud", "there is none of number " + std::to_string(cloud));
        const auto *points = dynamic_cast<const PointCloudObstacles *>(sensed_.at(cloud).obstacles.get());
        if (!points)
            throw ompl::Exception("cloud", "number " + std::to_string(cloud) + " is a map of cells, not of points");
        return *points;
    }

    const CellObstacles &World::getGrid(std::size_t grid) const
    {
        if (sensed_.count(grid) == 0)
            throw ompl::Exception("grid", "there is none of number " + std::to_string(grid));
        const auto *cells = dynamic_cast<const CellObstacles *>(sensed_.at(grid).obstacles.get());
        if (!cells)
            throw ompl::Exception("grid", "number " + std::to_string(grid) + " is a cloud of points, not of cells");
        return *cells;
    }

    CellSet &World::cellsOf(std::size_t grid)
    {
        const CellObstacles &now = getGrid(grid);
        std::optional<CellSet> &cells = sensed_.at(grid).cells;
        if (!cells)
        {
            CellSet set(now.getCellSize(), dimension_, now.getOrigin());
            orFail("grid " + std::to_string(grid), [&] { set.insert(now.getBoxes()); });
            set.takeChange();
            cells = std::move(set);
        }
        return *cells;
    }

    std::vector<Eigen::Vector3d> World::placed(CloudPoints points, double radius, const std::string &what) const
    {
        if (dimension_ == 2)
            return inPlane(std::move(points), radius, heights_, what);
        requireFinite(points.points, what);
        return std::move(points.points);
    }

    PointCloudSet &World::setOf(std::size_t cloud)
    {
        const PointCloudObstacles &now = getCloud(cloud);
        Sensed &sensed = sensed_.at(cloud);
        if (sensed.set)
            return *sensed.set;
        // A cloud that has seen nothing yet has a radius all the same.
        if (!sensed.radius)
            sensed.radius = now.getLargestRadius();
        std::vector<Eigen::Vector3d> points;
        for (const Ball &ball : now.getBalls())
        {
            if (ball.radius != *sensed.radius)
                throw ompl::Exception("cloud", "the points of number " + std::to_string(cloud) + " differ in radius");
            points.push_back(ball.center);
        }
        PointCloudSet set(*sensed.radius, dimension_);
        set.insert(std::move(points));
        set.takeChange();
        sensed.set = std::move(set);
        return *sensed.set;
    }
}
