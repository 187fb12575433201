#ifndef OMPL_CERTIFICATES_PYTHON_WORLD_
#define OMPL_CERTIFICATES_PYTHON_WORLD_

#include <ompl_certificates/obstacles/CellObstacles.h>
#include <ompl_certificates/obstacles/CellSet.h>
#include <ompl_certificates/obstacles/ObstacleSet.h>
#include <ompl_certificates/obstacles/PointCloudObstacles.h>
#include <ompl_certificates/obstacles/PointCloudSet.h>
#include <ompl_certificates/scene/Scene.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ompl_certificates_python
{
    /** \brief Points for a cloud */
    struct CloudPoints
    {
        std::vector<Eigen::Vector3d> points;

        /** \brief Whether their z are heights, so that in a planar scene only those count that robots reach. If not,
            they are points of the plane itself. */
        bool haveHeights{true};
    };

    /** \brief The points of a planar scene that robots at \e heights reach, with z = 0, if each has \e radius
        \throws ompl::Exception that names \e what if a coordinate is not finite */
    std::vector<Eigen::Vector3d> inPlane(CloudPoints points, double radius, const ompl_certificates::ZInterval &heights,
                                         const std::string &what);

    /** \brief What changes in a cloud, all at once */
    struct CloudChange
    {
        /** \brief Points to be added */
        CloudPoints inserted;

        /** \brief Points to be removed, by their coordinates */
        CloudPoints removed;

        /** \brief A box, all of whose points are removed before others are added; empty for none */
        Eigen::AlignedBox3d cleared;
    };

    /** \brief What changes among bodies, all at once */
    struct BodyChange
    {
        std::vector<ompl_certificates::PlacedBody> added;
        std::map<ompl_certificates::ObstacleSet::Id, ompl_certificates::Pose> moved;
        std::vector<ompl_certificates::ObstacleSet::Id> removed;
    };

    /** \brief The obstacles of a scene, which may change: bodies, clouds of points, and grids of cells. Clouds and
        grids are numbered together.

        Each change returns what a TeamValidityChecker has to be told. Not for several threads at once. */
    class World
    {
    public:
        /** \brief The obstacles of \e scene. Its bodies and clouds have the numbers of their order, from 0 on, and
            its titles. */
        explicit World(const ompl_certificates::Scene &scene);

        /** \brief All obstacles, as of Scene::makeObstacles() */
        ompl_certificates::ObstaclesPtr getObstacles() const;

        /** \brief Add all obstacles to a scene that has none. */
        void addTo(ompl_certificates::Scene &scene) const;

        /** \brief Change the bodies, and write the numbers of those that are added to \e numbers.
            \throws ompl::Exception as ObstacleSet does. Then nothing has changed. */
        ompl_certificates::ObstacleChange changeBodies(const BodyChange &change,
                                                       std::vector<ompl_certificates::ObstacleSet::Id> &numbers);

        /** \brief The number that the next cloud or grid gets */
        std::size_t getNextSensed() const
        {
            return nextSensed_;
        }

        /** \brief Add a cloud, whose points all have one \e radius. In a planar scene those count that inPlane() keeps,
            here and below.
            \throws ompl::Exception as PointCloudSet does */
        ompl_certificates::ObstacleChange addCloud(CloudPoints points, double radius);

        /** \brief Change a cloud. Cost: that of PointCloudSet for the points that come and go; the first change of a
            cloud of the scene, in proportion to all of its points.
            \throws ompl::Exception if there is none of this number, if it is a map of cells, and as PointCloudSet does.
            Then nothing has changed. */
        ompl_certificates::ObstacleChange changeCloud(std::size_t cloud, CloudChange change);

        /** \brief Remove a cloud. No other one gets its number.
            \throws ompl::Exception as changeCloud() does */
        ompl_certificates::ObstacleChange removeCloud(std::size_t cloud);

        /** \brief The points of a cloud, in no order
            \throws ompl::Exception as changeCloud() does */
        std::vector<Eigen::Vector3d> getPoints(std::size_t cloud) const;

        /** \brief Add a grid of occupied cells.
            \param origin where cell (0, 0, 0) has its lowest corner
            \throws ompl::Exception as CellSet does */
        ompl_certificates::ObstacleChange addGrid(const std::vector<ompl_certificates::CellBox> &occupied, double size,
                                                  const Eigen::Vector3d &origin);

        /** \brief Add a map of cells as it is: its first change makes a set of it. */
        ompl_certificates::ObstacleChange addMap(std::shared_ptr<const ompl_certificates::CellObstacles> map);

        /** \brief Change cells of a grid. Cost: that of CellSet; the first change of a grid of the scene, in proportion
            to all of its cells.
            \throws ompl::Exception if there is none of this number, if it is a cloud, and as CellSet does. Then
            nothing has changed. */
        ompl_certificates::ObstacleChange changeGrid(std::size_t grid,
                                                     const std::vector<ompl_certificates::CellBox> &occupied,
                                                     const std::vector<ompl_certificates::CellBox> &free);

        /** \brief Let a grid have the cells of \e map alone. What is in both stays. Cost: that of CellSet for all cells
            \throws ompl::Exception as changeGrid() does, and if \e map has another cell size or origin. Then nothing has
            changed. */
        ompl_certificates::ObstacleChange replaceGrid(std::size_t grid, const ompl_certificates::CellObstacles &map);

        /** \brief Remove a grid. No other one gets its number.
            \throws ompl::Exception as changeGrid() does */
        ompl_certificates::ObstacleChange removeGrid(std::size_t grid);

        /** \brief The occupied cells of a grid
            \throws ompl::Exception as changeGrid() does */
        const ompl_certificates::CellObstacles &getGrid(std::size_t grid) const;

    private:
        /** \brief A grid or a cloud, and the set that makes it; of the cloud its radius once it is known */
        struct Sensed
        {
            ompl_certificates::ObstaclesPtr obstacles;
            std::string title;
            std::optional<double> radius{};
            std::optional<ompl_certificates::PointCloudSet> set{};
            std::optional<ompl_certificates::CellSet> cells{};
        };

        /** \brief The obstacles that are the points of a cloud now */
        const ompl_certificates::PointCloudObstacles &getCloud(std::size_t cloud) const;

        /** \brief The set of a cloud, which is made for its first change */
        ompl_certificates::PointCloudSet &setOf(std::size_t cloud);

        /** \brief The set of a grid, which is made for its first change */
        ompl_certificates::CellSet &cellsOf(std::size_t grid);

        /** \brief Do \e edit to the set of a grid. If that throws, the next change makes a set of the cells that are
            there. */
        ompl_certificates::ObstacleChange editGrid(std::size_t grid,
                                                   const std::function<void(ompl_certificates::CellSet &)> &edit);

        /** \brief Add a cloud or a grid, whose title ends with its number. */
        void add(Sensed sensed, const std::string &title);

        /** \brief Remove a cloud or a grid that is there. */
        ompl_certificates::ObstacleChange remove(std::size_t number);

        /** \brief A set's change as one of all obstacles, which it is part of already */
        ompl_certificates::ObstacleChange ofWorld(ompl_certificates::ObstacleChange change) const;

        /** \brief The points as a cloud of this world has them */
        std::vector<Eigen::Vector3d> placed(CloudPoints points, double radius, const std::string &what) const;

        unsigned int dimension_;
        ompl_certificates::ZInterval heights_;
        ompl_certificates::ObstacleSet bodies_;
        ompl_certificates::ObstaclesPtr bodiesNow_;
        /** \brief What messages call the bodies */
        std::map<ompl_certificates::ObstacleSet::Id, std::string> titles_;
        std::map<std::size_t, Sensed> sensed_;
        std::size_t nextSensed_{0};
    };
}

#endif
