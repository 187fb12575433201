#include "Changes.h"

#include "Gil.h"
#include "Mappings.h"
#include "Numbers.h"
#include "Octomaps.h"

#include <ompl_certificates/team/RobotFilter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ompl/util/Exception.h>
#include <optional>
#include <pybind11/stl.h>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        /** The lower and the upper corner */
        using Box = std::pair<std::vector<double>, std::vector<double>>;

        /** Points for a cloud of a checker */
        CloudPoints pointsOf(const Checker &checker, const py::object &object, const char *what)
        {
            const Doubles points = toDoubles(object, what);
            return {toPoints3(points, what, checker.getDimension() == 2), haveHeights(points)};
        }

        Eigen::AlignedBox3d boxOf(const Checker &checker, const Box &box)
        {
            constexpr double infinity = std::numeric_limits<double>::infinity();
            const auto &[low, high] = box;
            Eigen::AlignedBox3d result(Eigen::Vector3d::Constant(-infinity), Eigen::Vector3d::Constant(infinity));
            const std::size_t dimension = checker.getDimension();
            if (low.size() != dimension || high.size() != dimension)
                throw ompl::Exception("clear", "must be two corners of " + std::to_string(dimension) + " numbers each");
            for (std::size_t axis = 0; axis < dimension; ++axis)
            {
                if (!(low[axis] <= high[axis]))
                    throw ompl::Exception("clear", "the first corner must be below the second: " +
                                                       std::to_string(low[axis]) + ", " + std::to_string(high[axis]));
                result.min()[static_cast<Eigen::Index>(axis)] = low[axis];
                result.max()[static_cast<Eigen::Index>(axis)] = high[axis];
            }
            return result;
        }

        std::size_t addCloud(Checker &checker, const py::object &array, double radius)
        {
            auto points = pointsOf(checker, array, "points");
            const GilRelease release;
            return checker.addCloud(std::move(points), radius);
        }

        void changeCloud(Checker &checker, Number cloud, const py::object &inserted, const py::object &removed,
                         const std::optional<Box> &cleared)
        {
            const auto points = [&checker](const py::object &object, const char *what)
            { return object.is_none() ? CloudPoints() : pointsOf(checker, object, what); };
            CloudChange change{points(inserted, "insert"), points(removed, "remove"),
                               cleared ? boxOf(checker, *cleared) : Eigen::AlignedBox3d()};
            const GilRelease release;
            checker.changeCloud(cloud, std::move(change));
        }

        Doubles cloudPoints(const Checker &checker, Number cloud)
        {
            const auto points = [&]
            {
                const GilRelease release;
                return checker.getCloudPoints(cloud);
            }();
            return fromPoints(points, checker.getDimension());
        }

        /** What a sensor saw: in the plane points with heights are taken as seen from above. */
        struct SeenPoints
        {
            PointCloud cloud;
            Doubles array;
        };

        /** Which points are part of the team; those that are not finite are not */
        std::vector<bool> findRobotsOf(const Checker &checker, const PointCloud &cloud, const py::object &values,
                                       double padding)
        {
            const auto state = checker.toState(toDoubles(values, "state"), "state");
            const GilRelease release;
            return findRobots(cloud, Team(checker.getSetup().getStateSpace()), state.get(), padding);
        }

        SeenPoints seenPoints(const Checker &checker, const py::object &object)
        {
            SeenPoints seen{{}, toDoubles(object, "points")};
            const bool isPlanar = checker.getDimension() == 2;
            const bool isEmptyList = seen.array.ndim() == 1 && seen.array.size() == 0;
            if (isEmptyList)
                return seen;
            if (seen.array.ndim() != 2 || (seen.array.shape(1) != 3 && !(isPlanar && seen.array.shape(1) == 2)))
                throw ompl::Exception("points", std::string("must have the shape ") + (isPlanar ? "(n, 2) or " : "") +
                                                    "(n, 3), not " + shapeOf(seen.array));
            seen.cloud.points = toPoints3(seen.array, "points", isPlanar);
            if (isPlanar)
                for (Eigen::Vector3d &point : seen.cloud.points)
                    point.z() = std::isfinite(point.z()) ? 0.0 : point.z();
            return seen;
        }

        Doubles pointsWithoutRobots(const Checker &checker, const py::object &array, const py::object &values,
                                    double padding)
        {
            const SeenPoints seen = seenPoints(checker, array);
            const std::vector<bool> are = findRobotsOf(checker, seen.cloud, values, padding);
            const py::ssize_t columns = seen.array.ndim() == 2 ? seen.array.shape(1) : checker.getDimension();
            std::vector<double> kept;
            for (std::size_t i = 0; i < are.size(); ++i)
                if (const double *row = seen.array.data() + static_cast<py::ssize_t>(i) * columns;
                    !are[i] && std::all_of(row, row + columns, [](double number) { return std::isfinite(number); }))
                    kept.insert(kept.end(), row, row + columns);
            Doubles result({static_cast<py::ssize_t>(kept.size()) / columns, columns});
            std::copy(kept.begin(), kept.end(), result.mutable_data());
            return result;
        }

        py::array_t<bool> robotMask(const Checker &checker, const py::object &array, const py::object &values,
                                    double padding)
        {
            const std::vector<bool> are = findRobotsOf(checker, seenPoints(checker, array).cloud, values, padding);
            py::array_t<bool> mask(static_cast<py::ssize_t>(are.size()));
            std::copy(are.begin(), are.end(), mask.mutable_data());
            return mask;
        }

        void bindClouds(py::class_<Checker, std::shared_ptr<Checker>> &checker)
        {
            checker
                .def("add_cloud", &addCloud, py::arg("points"), py::arg("radius"),
                     "Add obstacles that are points, of shape (n, 3) or in the plane (n, 2), and return the number of "
                     "the cloud. All within radius of a point is occupied. In a planar scene the same points count as "
                     "of Scene.add_cloud, for the checker's robots.")
                .def("change_cloud", &changeCloud, py::arg("cloud"), py::kw_only(), py::arg("insert") = py::none(),
                     py::arg("remove") = py::none(), py::arg("clear") = py::none(),
                     "Change a cloud, all at once: remove points of exactly these coordinates and all within the box "
                     "clear = (low, high), which may be infinite; then insert others. The scene's own clouds have the "
                     "numbers that Scene.add_cloud returned. Time goes with the points that come and go. Where it "
                     "raises an Error, nothing has changed. Points have the cloud's radius, and the shapes of "
                     "add_cloud: in a planar scene those of shape (n, 3) that no robot reaches do not count, in insert "
                     "and in remove.")
                .def(
                    "remove_cloud",
                    [](Checker &self, Number cloud)
                    {
                        const GilRelease release;
                        self.removeCloud(cloud);
                    },
                    py::arg("cloud"), "Remove a cloud. No other one gets its number.")
                .def("cloud_points", &cloudPoints, py::arg("cloud"),
                     "The points of a cloud now, of shape (n, dimension), in no order")
                .def(
                    "without_robots", &pointsWithoutRobots, py::arg("points"), py::arg("state"), py::kw_only(),
                    py::arg("padding") = 0.0,
                    "Those of the points, of the shapes of add_cloud, that are no part of the team where it was when a "
                    "sensor saw them. In a planar scene points are looked at as seen from above. Leaves out points inside a robot's body or nearer to it than padding: the "
                    "radius of the cloud, and the errors of the sensor and of the state. What the body itself keeps as "
                    "its padding is added: an obstacle within it is left out, too. Also rows that are not "
                    "finite, where a sensor saw nothing.")
                .def("find_robots", &robotMask, py::arg("points"), py::arg("state"), py::kw_only(),
                     py::arg("padding") = 0.0,
                     "Which of the points are part of the team, as without_robots tells: bools of shape (n,), a mask "
                     "for colors and intensities. Rows that are not finite are none.");
        }

        /** Refuse numbers of which one is there twice. */
        void requireOnce(std::vector<Number> numbers)
        {
            std::sort(numbers.begin(), numbers.end());
            const auto twice = std::adjacent_find(numbers.begin(), numbers.end());
            if (twice != numbers.end())
                throw ompl::Exception("remove", "obstacle " + std::to_string(twice->value) + " is there twice");
        }

        std::vector<ObstacleSet::Id> changeObstacles(Checker &checker, const std::vector<Placed> &added,
                                                     const Mapping<Number, py::object> &moved,
                                                     const std::vector<Number> &removed)
        {
            requireOnce(removed);
            BodyChange change;
            change.added = toPlacedBodies(added, checker.getDimension());
            for (const auto &[number, pose] : moved)
                change.moved.emplace(number, toPose(pose, checker.getDimension()));
            change.removed.assign(removed.begin(), removed.end());
            for (const Number number : removed)
                if (moved.count(number) > 0)
                    throw ompl::Exception("remove",
                                          "obstacle " + std::to_string(number.value) + " is to be moved as well");
            const GilRelease release;
            return checker.changeObstacles(change);
        }

        void bindObstacles(py::class_<Checker, std::shared_ptr<Checker>> &checker)
        {
            checker
                .def(
                    "add_obstacle",
                    [](Checker &self, const Body &body, const py::object &pose) {
                        return changeObstacles(self, {{body, pose}}, {}, {}).front();
                    },
                    py::arg("body"), py::arg("pose") = py::none(), "Add an obstacle and return its number.")
                .def(
                    "move_obstacle",
                    [](Checker &self, Number obstacle, const py::object &pose) {
                        changeObstacles(self, {}, {{obstacle, pose}}, {});
                    },
                    py::arg("obstacle"), py::arg("pose"),
                    "Move an obstacle. The scene's own have the numbers that Scene.add_obstacle returned.")
                .def(
                    "remove_obstacle",
                    [](Checker &self, Number obstacle) { changeObstacles(self, {}, {}, {obstacle}); },
                    py::arg("obstacle"), "Remove an obstacle.")
                .def("change_obstacles", &changeObstacles, py::kw_only(), py::arg("add") = std::vector<Placed>(),
                     py::arg("move") = Mapping<Number, py::object>(), py::arg("remove") = std::vector<Number>(),
                     "Change many obstacles, all at once: remove those of some numbers, move others to the poses of a "
                     "dict from numbers to poses, and add pairs of a body and its pose. Returns the numbers of those "
                     "that are added. Each change takes time in proportion to all obstacles, so one is faster than "
                     "many. Where it raises an Error, nothing has changed.");
        }

        std::size_t addGrid(Checker &checker, const py::object &occupied, double size,
                            const std::vector<std::int64_t> &first, const std::vector<double> &origin)
        {
            const auto cells = toCells(occupied, first, checker.getDimension());
            const Eigen::Vector3d corner = toOrigin(origin, checker.getDimension());
            const GilRelease release;
            return checker.addGrid(cells, size, corner);
        }

        void changeGrid(Checker &checker, Number grid, const py::object &occupied,
                        const std::vector<std::int64_t> &first)
        {
            const auto cells = toCells(occupied, first, checker.getDimension());
            const auto others = toCells(occupied, first, checker.getDimension(), false);
            const GilRelease release;
            checker.changeGrid(grid, cells, others);
        }

        std::size_t addOctomap(Checker &checker, const py::object &data, double resolution, bool binary,
                               const std::string &id, unsigned int depth, bool unknownOccupied,
                               const std::optional<std::pair<double, double>> &heights,
                               const std::vector<double> &origin)
        {
            const auto map = makeOctomap(checker.getDimension(), toOctomapMessage(data, resolution, binary, id),
                                         {depth, unknownOccupied, heights, origin});
            const GilRelease release;
            return checker.addMap(map);
        }

        void changeOctomap(Checker &checker, Number grid, const py::object &data, double resolution, bool binary,
                           const std::string &id, unsigned int depth, bool unknownOccupied,
                           const std::optional<std::pair<double, double>> &heights, const std::vector<double> &origin)
        {
            const auto map = makeOctomap(checker.getDimension(), toOctomapMessage(data, resolution, binary, id),
                                         {depth, unknownOccupied, heights, origin});
            const GilRelease release;
            checker.replaceGrid(grid, *map);
        }

        /** The index of each cell in some boxes */
        py::array_t<std::int64_t> gridCells(const Checker &checker, Number grid)
        {
            const unsigned int dimension = checker.getDimension();
            std::vector<CellBox> boxes = [&]
            {
                const GilRelease release;
                return checker.getCells(grid);
            }();
            std::uint64_t count = 0;
            for (CellBox &box : boxes)
            {
                // In the plane boxes are flat.
                if (dimension == 2)
                    box.high[2] = box.low[2] + 1;
                std::uint64_t cells = 1;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    cells *= static_cast<std::uint64_t>(box.high[axis] - box.low[axis]);
                count += cells;
            }
            // A few boxes may stand for more cells than fit into memory.
            constexpr std::uint64_t most = 100000000;
            if (count > most)
                throw ompl::Exception("grid " + std::to_string(grid.value), "has " + std::to_string(count) +
                                                                                " occupied cells, more than " +
                                                                                std::to_string(most));
            py::array_t<std::int64_t> result({static_cast<py::ssize_t>(count), static_cast<py::ssize_t>(dimension)});
            std::int64_t *index = result.mutable_data();
            const GilRelease release;
            for (const CellBox &box : boxes)
                for (std::int64_t x = box.low[0]; x < box.high[0]; ++x)
                    for (std::int64_t y = box.low[1]; y < box.high[1]; ++y)
                        for (std::int64_t z = box.low[2]; z < box.high[2]; ++z)
                        {
                            const std::array cell{x, y, z};
                            index = std::copy_n(cell.begin(), dimension, index);
                        }
            return result;
        }

        void bindGrids(py::class_<Checker, std::shared_ptr<Checker>> &checker)
        {
            checker
                .def("add_grid", &addGrid, py::arg("occupied"), py::arg("size"),
                     py::arg("first") = std::vector<std::int64_t>(), py::arg("origin") = std::vector<double>(),
                     "Add obstacles that are cells of a grid, as Scene.add_grid does, and return its number.")
                .def(
                    "change_grid", &changeGrid, py::arg("grid"), py::arg("occupied"),
                    py::arg("first") = std::vector<std::int64_t>(),
                    "Set which cells of a grid are occupied, all at once: those that the array covers, whose first one "
                    "has the index first. Others stay. The scene's own grids and maps have the numbers that "
                    "Scene.add_grid and the like returned. Cells are those of the map itself, whatever depth it was loaded "
                    "with. Time goes with the cells that the array covers, and with the blocks of 16 cells a side of the "
                    "whole map; at the first change of a map with all of its cells. Where it raises an Error, nothing "
                    "has changed.")
                .def("add_octomap", &addOctomap, py::arg("data"), py::arg("resolution"), py::arg("binary") = true,
                     py::arg("id") = "OcTree", py::kw_only(), py::arg("depth") = 16,
                     py::arg("unknown_occupied") = false, py::arg("heights") = py::none(),
                     py::arg("origin") = std::vector<double>(),
                     "Add the occupied cells of an octomap, as Scene.add_octomap does, and return its number.")
                .def(
                    "change_octomap", &changeOctomap, py::arg("grid"), py::arg("data"), py::arg("resolution"),
                    py::arg("binary") = true, py::arg("id") = "OcTree", py::kw_only(), py::arg("depth") = 16,
                    py::arg("unknown_occupied") = false, py::arg("heights") = py::none(),
                    py::arg("origin") = std::vector<double>(),
                    "Let a map have the cells of another octomap alone, all at once: the next message of the same map. "
                    "The cells must be as large as before, from the same origin on. From the second such change on, certificates "
                    "stay where both are alike. Time goes with all cells of the map. Where it raises an Error, nothing has changed.")
                .def(
                    "remove_grid",
                    [](Checker &self, Number grid)
                    {
                        const GilRelease release;
                        self.removeGrid(grid);
                    },
                    py::arg("grid"), "Remove a grid or a map. No other one gets its number.")
                .def("grid_cells", &gridCells, py::arg("grid"),
                     "The occupied cells of a grid or a map now: their indices, of shape (n, dimension), in no order. "
                     "Cell (i, j) of a map begins at (i, j) times its resolution, from its origin on.");
        }
    }

    void bindChanges(py::class_<Checker, std::shared_ptr<Checker>> &checker)
    {
        bindObstacles(checker);
        bindClouds(checker);
        bindGrids(checker);
    }
}
