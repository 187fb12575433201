#include "Arrays.h"
#include "Bindings.h"
#include "World.h"

#include <ompl_certificates/obstacles/PointCloudObstacles.h>
#include <ompl_certificates/pictures/PathFile.h>
#include <ompl_certificates/scene/CloudFile.h>
#include <ompl_certificates/scene/MoveItFiles.h>
#include <ompl_certificates/scene/SceneFile.h>

#include <cmath>
#include <ompl/util/Exception.h>
#include <pybind11/stl.h>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        Scene makeScene(const std::vector<double> &low, const std::vector<double> &high, const std::string &name)
        {
            return Scene(name, name, toBounds(low, high));
        }

        std::size_t addObstacle(Scene &scene, const Body &body, const py::object &pose)
        {
            scene.addObstacle({body, toPose(pose, scene.getDimension())});
            return scene.getObstacles().size() - 1;
        }

        std::size_t addCloud(Scene &scene, PointCloud cloud, double cell, bool haveHeights = true)
        {
            if (!(cell >= 0.0))
                throw ompl::Exception("cell", "must not be negative, not " + std::to_string(cell));
            if (cell > 0.0)
                cloud = thinned(std::move(cloud), cell);
            if (scene.getDimension() == 2)
                cloud.points =
                    inPlane({std::move(cloud.points), haveHeights}, cloud.radius, scene.getZInterval(), "points");
            const std::size_t number = scene.getSensedObstacles().size();
            scene.addSensedObstacles(std::make_shared<PointCloudObstacles>(std::move(cloud), scene.getDimension()),
                                     "clouds[" + std::to_string(number) + "]");
            return number;
        }

        void addRobot(Scene &scene, const std::shared_ptr<Robot> &robot, const std::vector<double> &start,
                      const std::vector<double> &goal, double weight)
        {
            const auto refuse = [&](const std::string &what, double value)
            {
                throw ompl::Exception(scene.getSource(),
                                      "robot '" + robot->getName() + "': " + what + ", not " + std::to_string(value));
            };
            if (!(weight >= 0.0) || !std::isfinite(weight))
                refuse("weight must be finite and not negative", weight);
            for (const auto *coordinates : {&start, &goal})
                for (const double coordinate : *coordinates)
                    if (!std::isfinite(coordinate))
                        refuse(coordinates == &start ? "start must be finite" : "goal must be finite", coordinate);
            scene.addMember({robot, start, goal, weight});
        }

        /** The starts or the goals of all robots, one after the other */
        std::vector<double> joined(const Scene &scene, std::vector<double> Scene::Member::*coordinates)
        {
            std::vector<double> all;
            for (const Scene::Member &member : scene.getMembers())
                all.insert(all.end(), (member.*coordinates).begin(), (member.*coordinates).end());
            return all;
        }

        Doubles toArray(const std::vector<double> &values)
        {
            return Doubles(static_cast<py::ssize_t>(values.size()), values.data());
        }

        std::string describe(const Scene &scene)
        {
            const auto count = [](std::size_t number, const std::string &what)
            { return std::to_string(number) + " " + what + (number == 1 ? "" : "s"); };
            return "<Scene '" + scene.getName() + "' of " + count(scene.getMembers().size(), "robot") + ", " +
                   count(scene.getObstacles().size() + scene.getSensedObstacles().size(), "obstacle") + ">";
        }

        void bindBuilding(py::class_<Scene> &scene)
        {
            scene
                .def(py::init(&makeScene), py::arg("low"), py::arg("high"), py::arg("name") = "scene",
                     "A scene without obstacles and robots. low and high bound the workspace, with 2 or 3 numbers.")
                .def("add_obstacle", &addObstacle, py::arg("body"), py::arg("pose") = py::none(),
                     "Add an obstacle and return its number, from 0 on. pose is (x, y) or (x, y, angle) in the plane, "
                     "(x, y, z) or (x, y, z, qx, qy, qz, qw) in space, or a 4 × 4 matrix.")
                .def(
                    "add_cloud",
                    [](Scene &self, const Doubles &points, double radius, double cell) {
                        return addCloud(self, {toPoints3(points, "points", self.getDimension() == 2), radius}, cell,
                                        points.shape(1) == 3);
                    },
                    py::arg("points"), py::arg("radius"), py::arg("cell") = 0.0,
                    "Add obstacles that are points, of shape (n, 3) or in the plane (n, 2), and return the number of the "
                    "cloud, from 0 on. All within radius of a point is occupied. With a cell larger than 0 fewer "
                    "points stand for them, one in each cell of a grid; the radius grows, so that all that was "
                    "occupied still is, and what Checker.change_cloud inserts has that larger radius, too. In a "
                    "planar scene points of shape (n, 2) are in the robots' way at any height. Of those of shape (n, "
                    "3) only the ones count that a robot reaches with its meshes; so add the robots first.")
                .def(
                    "add_cloud_file",
                    [](Scene &self, const std::filesystem::path &file, double radius, double cell)
                    {
                        PointCloud cloud = loadCloud(file);
                        cloud.radius = radius;
                        return addCloud(self, std::move(cloud), cell);
                    },
                    py::arg("file"), py::arg("radius"), py::arg("cell") = 0.0,
                    "The same, from a PCD, PLY, .xyz or .txt file")
                .def("add_robot", &addRobot, py::arg("robot"), py::arg("start"), py::arg("goal"),
                     py::arg("weight") = 1.0,
                     "Add a robot, with its start and goal; its distances count weight times.");
        }
    }

    void bindScenes(py::module_ &module)
    {
        py::class_<Scene> scene(module, "Scene",
                                "A workspace with obstacles, and robots with their starts and goals. Lengths are in "
                                "the scene's unit, angles in radians.");
        bindBuilding(scene);
        scene.def("__repr__", &describe)
            .def_property_readonly("name", &Scene::getName, "What the scene is called")
            .def_property_readonly("dimension", &Scene::getDimension, "The dimension of the workspace: 2 or 3")
            .def_property_readonly(
                "low", [](const Scene &self) { return toArray(self.getBounds().low); },
                "The lower bounds of the workspace, of shape (dimension,)")
            .def_property_readonly(
                "high", [](const Scene &self) { return toArray(self.getBounds().high); },
                "The upper bounds of the workspace, of shape (dimension,)")
            .def_property_readonly("notes", &Scene::getNotes, "What a user should know about how files were read")
            .def_property_readonly(
                "robots",
                [](const Scene &self)
                {
                    std::vector<std::shared_ptr<Robot>> robots;
                    for (const Scene::Member &member : self.getMembers())
                        robots.push_back(std::const_pointer_cast<Robot>(member.robot));
                    return robots;
                },
                "The robots, in the order of the numbers of a state")
            .def_property_readonly(
                "obstacle_count", [](const Scene &self) { return self.getObstacles().size(); },
                "The number of obstacles that are bodies")
            .def_property_readonly(
                "coordinates", [](const Scene &self) { return coordinateNames(*self.makeTeam()); },
                "The names of the numbers of a state of the team, such as scout.x")
            .def_property_readonly(
                "start", [](const Scene &self) { return toArray(joined(self, &Scene::Member::start)); },
                "The team's start, of shape (coordinates,)")
            .def_property_readonly(
                "goal", [](const Scene &self) { return toArray(joined(self, &Scene::Member::goal)); },
                "The team's goal, of shape (coordinates,)")
            .def_property("resolution", &Scene::getResolution, &Scene::setResolution,
                          "The longest step between samples of a motion, as a fraction of each robot's extent: from "
                          "1e-6 to below 1, or 0 for OMPL's own")
            .def("first_robots", &Scene::withFirstRobots, py::arg("count"),
                 "The same scene with the first robots alone")
            .def(
                "validate", [](const Scene &self) { self.validate(); },
                "Raise an Error unless the team can stand at its start and goal.");

        module.def(
            "load_scene", [](const std::filesystem::path &file) { return loadScene(file); }, py::arg("file"),
            "The scene in a YAML file (docs/scene-format.md) or a .cfg file of OMPL.app");
        module.def(
            "scene_from_yaml",
            [](const std::string &text, const std::string &source) { return sceneFromYaml(text, source); },
            py::arg("text"), py::arg("source") = "scene.yaml",
            "The scene in a text. Errors name source, and meshes are looked for in its folder.");
        module.def(
            "load_moveit",
            [](const std::filesystem::path &file, const std::filesystem::path &request,
               const std::filesystem::path &urdf, const std::filesystem::path &srdf)
            { return readMoveItFiles(file, request, ArmFile(urdf, srdf)).scene; },
            py::arg("scene"), py::arg("request"), py::arg("urdf"), py::arg("srdf"),
            "The scene in MoveIt's planning scene and motion plan request (YAML)");
    }
}
