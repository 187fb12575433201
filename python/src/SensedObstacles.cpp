#include "SensedObstacles.h"

#include "Arrays.h"
#include "Gil.h"
#include "Octomaps.h"
#include "World.h"

#include <ompl_certificates/obstacles/CellObstacles.h>
#include <ompl_certificates/obstacles/PointCloudObstacles.h>
#include <ompl_certificates/scene/CloudFile.h>
#include <ompl_certificates/scene/OccupancyMapFile.h>

#include <ompl/util/Exception.h>
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        /** Add obstacles that are no bodies, and return their number. */
        std::size_t addSensed(Scene &scene, const ObstaclesPtr &obstacles, const std::string &kind)
        {
            const std::size_t number = scene.getSensedObstacles().size();
            scene.addSensedObstacles(obstacles, kind + "[" + std::to_string(number) + "]");
            return number;
        }

        /** The same of obstacles that are made while other Python threads run */
        template <typename Make>
        std::size_t makeSensed(Scene &scene, const Make &make, const std::string &kind)
        {
            ObstaclesPtr obstacles;
            {
                const GilRelease release;
                obstacles = make();
            }
            return addSensed(scene, obstacles, kind);
        }

        std::size_t addCloud(Scene &scene, PointCloud cloud, double cell, bool haveHeights = true)
        {
            if (!(cell >= 0.0))
                throw ompl::Exception("cell", "must not be negative, not " + std::to_string(cell));
            const ZInterval heights = scene.getZInterval();
            const unsigned int dimension = scene.getDimension();
            return makeSensed(
                scene,
                [&]() -> ObstaclesPtr
                {
                    if (cell > 0.0)
                        cloud = thinned(std::move(cloud), cell);
                    if (dimension == 2)
                        cloud.points = inPlane({std::move(cloud.points), haveHeights}, cloud.radius, heights, "points");
                    return std::make_shared<PointCloudObstacles>(std::move(cloud), dimension);
                },
                "clouds");
        }

        std::size_t addGrid(Scene &scene, const py::object &occupied, double size,
                            const std::vector<std::int64_t> &first, const std::vector<double> &origin)
        {
            const unsigned int dimension = scene.getDimension();
            const auto cells = toCells(occupied, first, dimension);
            const Eigen::Vector3d corner = toOrigin(origin, dimension);
            return makeSensed(
                scene, [&] { return std::make_shared<CellObstacles>(size, cells, dimension, corner); }, "grids");
        }

        std::size_t addOccupancyMapFile(Scene &scene, const std::filesystem::path &file, bool unknownOccupied)
        {
            return makeSensed(
                scene, [&] { return loadOccupancyMap(file.string(), unknownOccupied); }, "maps");
        }

        std::size_t addOctomap(Scene &scene, const MapSource &source, const MapOptions &options)
        {
            return addSensed(scene, makeOctomap(scene.getDimension(), source, options), "octomaps");
        }

        std::size_t addOctomapFile(Scene &scene, const std::filesystem::path &file, unsigned int depth,
                                   bool unknownOccupied, const std::optional<std::pair<double, double>> &heights,
                                   const std::vector<double> &origin)
        {
            return addOctomap(scene, file.string(), {depth, unknownOccupied, heights, origin});
        }

        std::size_t addOctomapMessage(Scene &scene, const py::object &data, double resolution, bool binary,
                                      const std::string &id, unsigned int depth, bool unknownOccupied,
                                      const std::optional<std::pair<double, double>> &heights,
                                      const std::vector<double> &origin)
        {
            return addOctomap(scene, toOctomapMessage(data, resolution, binary, id),
                              {depth, unknownOccupied, heights, origin});
        }
    }

    void bindSensed(py::class_<Scene> &scene)
    {
        scene
            .def(
                "add_cloud",
                [](Scene &self, const py::object &object, double radius, double cell)
                {
                    const Doubles array = toDoubles(object, "points");
                    auto points = toPoints3(array, "points", self.getDimension() == 2);
                    return addCloud(self, {std::move(points), radius}, cell, haveHeights(array));
                },
                py::arg("points"), py::arg("radius"), py::arg("cell") = 0.0,
                "Add obstacles that are points, of shape (n, 3) or in the plane (n, 2), and return the number of the "
                "cloud, from 0 on. All within radius of a point is occupied. With a cell larger than 0 fewer "
                "points stand for them, one in each cell of a grid; the radius grows, so that all that was "
                "occupied still is, and what Checker.change_cloud inserts has that larger radius, too. In a "
                "planar scene points of shape (n, 2) are in the robots' way at any height. Of those of shape (n, "
                "3) only the ones count that are within radius of the heights of a robot's meshes with their "
                "padding; so add the robots first. Robots of other shapes reach all heights, so leave out the floor "
                "before.")
            .def(
                "add_cloud_file",
                [](Scene &self, const std::filesystem::path &file, double radius, double cell)
                {
                    PointCloud cloud = [&file]
                    {
                        const GilRelease release;
                        return loadCloud(file);
                    }();
                    cloud.radius = radius;
                    return addCloud(self, std::move(cloud), cell);
                },
                py::arg("file"), py::arg("radius"), py::arg("cell") = 0.0,
                "The same, from a PCD or PLY file, or a text: .xyz, .txt, .asc, .pts or .csv")
            .def("add_grid", &addGrid, py::arg("occupied"), py::arg("size"),
                 py::arg("first") = std::vector<std::int64_t>(), py::arg("origin") = std::vector<double>(),
                 "Add obstacles that are cells of a grid with edges of length size, and return its number; clouds, "
                 "grids and maps are numbered together, from 0 on. occupied has bools, of shape (nx, ny) in "
                 "the plane or (nx, ny, nz). Cell (i, j) reaches from (i, j) to (i + 1, j + 1), times size, from "
                 "origin on, by default 0; first is the index of occupied[0, 0], by default 0.")
            .def("add_occupancy_map_file", &addOccupancyMapFile, py::arg("file"), py::arg("unknown_occupied") = false,
                 "Add the occupied cells of a map of ROS's map_server, from its .yaml file and the image that "
                 "this names, and return its number. For planar scenes. Unknown cells are free, or occupied; beyond "
                 "the map all is free.")
            .def("add_octomap_file", &addOctomapFile, py::arg("file"), py::arg("depth") = 16,
                 py::arg("unknown_occupied") = false, py::arg("heights") = py::none(),
                 py::arg("origin") = std::vector<double>(),
                 "Add the occupied cells of an octomap, from a .bt or .ot file, and return its number. Each level "
                 "of depth less doubles the edges of its smallest cells. Unknown cells are free; or occupied, "
                 "within the box of all known ones. In a planar scene those cells count that reach into the "
                 "heights (low, high). origin is where the map's own origin is in the scene, with 3 numbers, by "
                 "default 0.")
            .def("add_octomap", &addOctomapMessage, py::arg("data"), py::arg("resolution"), py::arg("binary") = true,
                 py::arg("id") = "OcTree", py::kw_only(), py::arg("depth") = 16, py::arg("unknown_occupied") = false,
                 py::arg("heights") = py::none(), py::arg("origin") = std::vector<double>(),
                 "The same, from the fields of ROS's message octomap_msgs/Octomap: data as bytes, an array or a "
                 "list of numbers.");
    }
}
