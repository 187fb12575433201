#include "Arrays.h"
#include "Bindings.h"
#include "Gil.h"
#include "Goals.h"
#include "Mappings.h"
#include "Numbers.h"
#include "Outcome.h"
#include "SensedObstacles.h"

#include <ompl_certificates/control/DynamicRobot.h>
#include <ompl_certificates/pictures/PathReader.h>
#include <ompl_certificates/pictures/ScenePicture.h>
#include <ompl_certificates/scene/CloudFile.h>
#include <ompl_certificates/scene/MoveItFiles.h>
#include <ompl_certificates/scene/SceneFile.h>
#include <ompl_certificates/team/Coordinates.h>
#include <ompl_certificates/team/Rotations.h>

#include <ompl/util/Exception.h>
#include <pybind11/stl.h>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        Scene makeScene(const py::object &low, const py::object &high, const std::string &name)
        {
            return Scene(name, name, toBounds(low, high));
        }

        std::size_t addObstacle(Scene &scene, const Body &body, const py::object &pose, const std::string &name)
        {
            if (name.find_first_of("\r\n") != std::string::npos)
                throw ompl::Exception("name", "must not have a line break");
            scene.addObstacle({body, toPose(pose, scene.getDimension())}, name.empty() ? name : "'" + name + "'");
            return scene.getObstacles().size() - 1;
        }

        void addRobot(Scene &scene, const std::shared_ptr<Robot> &robot, const py::object &from, const py::object &to,
                      double weight, double speed)
        {
            const bool isDynamic = std::dynamic_pointer_cast<DynamicRobot>(robot) != nullptr;
            if (isGoal(to) && isDynamic)
                throw ompl::Exception(scene.getSource(), "robot '" + robot->getName() +
                                                             "': goal must be one state, as the robot has dynamics");
            std::vector<double> start = toNumbers(from, "start"), goal;
            const RobotGoalPtr region = isGoal(to) ? toRobotGoal(robot, to) : nullptr;
            if (!region)
                goal = toNumbers(to, "goal");
            const auto refuse = [&](const std::string &what, double value)
            {
                throw ompl::Exception(scene.getSource(),
                                      "robot '" + robot->getName() + "': " + what + ", not " + std::to_string(value));
            };
            if (!(weight >= 0.0) || !std::isfinite(weight))
                refuse("weight must be finite and not negative", weight);
            if (!(speed >= 1e-9 && speed <= 1e9))
                refuse("speed must be from 1e-9 to 1e9", speed);
            if (isDynamic && speed != 1.0)
                refuse("speed must be 1, as the robot has dynamics", speed);
            for (const auto *coordinates : {&start, &goal})
                for (const double coordinate : *coordinates)
                    if (!std::isfinite(coordinate))
                        refuse(coordinates == &start ? "start must be finite" : "goal must be finite", coordinate);
            const Rotations rotations(*robot->getStateSpace());
            bool mayBeDegrees = false;
            for (auto *coordinates : {&start, &goal})
                // Another number of them is refused below.
                if (coordinates->size() == rotations.count)
                {
                    for (const std::size_t angle : rotations.angles)
                        mayBeDegrees = mayBeDegrees || std::abs((*coordinates)[angle]) > 2.0 * M_PI;
                    rotations.wrapAngles(*coordinates);
                    const double length = rotations.normalizeQuaternions(*coordinates);
                    if (length != 1.0)
                        refuse(coordinates == &start ? "start: a quaternion must have length 1"
                                                     : "goal: a quaternion must have length 1",
                               length);
                }
            scene.addMember({robot, start, goal, weight, region, speed});
            if (mayBeDegrees)
                scene.addNote("robot '" + robot->getName() +
                              "': an angle is more than a whole turn; angles are in radians");
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

        std::string describeScene(const Scene &scene)
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
                .def(
                    "add_obstacle", &addObstacle, py::arg("body"), py::arg("pose") = py::none(), py::arg("name") = "",
                    "Add an obstacle and return its number, from 0 on. pose is (x, y) or (x, y, angle) in the plane, "
                    "(x, y, z) or (x, y, z, qx, qy, qz, qw) in space, or a 4 × 4 matrix. Messages call it by its name, "
                    "if it has one.")
                .def(
                    "add_robot", &addRobot, py::arg("robot").none(false), py::arg("start"), py::arg("goal"),
                    py::arg("weight") = 1.0, py::arg("speed") = 1.0,
                    "Add a robot, with its start and goal; its distances count weight times. The goal may also be a "
                    "LinkPose, for an arm, a Zone, or an AnyOf. speed is how much of its distance it moves in a unit of time: "
                    "times of plans, and the objectives makespan and arrival, go by it.");
        }
    }

    void bindScenes(py::module_ &module)
    {
        py::class_<Scene> scene(module, "Scene",
                                "A workspace with obstacles, and robots with their starts and goals. Lengths are in "
                                "the scene's unit, angles in radians.");
        bindBuilding(scene);
        bindSensed(scene);
        scene.def("__repr__", &describeScene)
            .def_property_readonly("name", &Scene::getName, "What the scene is called")
            .def_property_readonly("dimension", &Scene::getDimension, "The dimension of the workspace: 2 or 3")
            .def_property_readonly(
                "low", [](const Scene &self) { return toArray(self.getBounds().low); },
                "The lower bounds of the workspace, of shape (dimension,)")
            .def_property_readonly(
                "high", [](const Scene &self) { return toArray(self.getBounds().high); },
                "The upper bounds of the workspace, of shape (dimension,)")
            .def_property_readonly(
                "notes", &Scene::getNotes,
                "What a user should know about how files were read, and about angles of robots that look like degrees")
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
                "state_bounds", [](const Scene &self) { return toBoundArrays(*self.makeTeam()); },
                "From where to where the numbers of a state of the team may be: two arrays, low and high")
            .def_property_readonly(
                "start", [](const Scene &self) { return toArray(joined(self, &Scene::Member::start)); },
                "The team's start, of shape (coordinates,)")
            .def_property_readonly(
                "goal", [](const Scene &self) { return toArray(joined(self, &Scene::Member::goal)); },
                "The team's goal, of shape (coordinates,); for a LinkPose, a Zone or an AnyOf, one state of many")
            .def_property("resolution", &Scene::getResolution, &Scene::setResolution,
                          "The longest step between samples of a motion, as a fraction of each robot's extent: from "
                          "1e-6 to below 1, or 0 for OMPL's own")
            .def(
                "first_robots", [](const Scene &self, const Number &count) { return self.withFirstRobots(count); },
                py::arg("count"), "The same scene with the first robots alone")
            .def(
                "validate",
                [](const Scene &self)
                {
                    // Another thread may change the scene meanwhile.
                    Scene copy = self;
                    const GilRelease release;
                    copy.chooseGoals();
                    copy.validate();
                },
                "Raise an Error unless the team can stand at its start and goal.")
            .def(
                "load_path",
                [](const Scene &self, const std::filesystem::path &file)
                {
                    const auto si = std::make_shared<ompl::base::SpaceInformation>(self.makeTeam());
                    const ompl::geometric::PathGeometric path = [&]
                    {
                        const GilRelease release;
                        return loadPath(file, si);
                    }();
                    return toRows(*si->getStateSpace(), static_cast<unsigned int>(path.getStateCount()),
                                  [&path](unsigned int i) { return path.getState(i); });
                },
                py::arg("file"),
                "The states of a path that Plan.save() wrote, or another program: comma-separated values whose first "
                "line names the columns, in any order. Columns that are no coordinates are passed over. An array of "
                "shape (states, coordinates), as for Checker.prove()")
            .def(
                "save_picture",
                [](const Scene &self, const std::filesystem::path &file)
                {
                    requireSvg(file);
                    const Scene now(self);  // Another thread may add to the scene.
                    const GilRelease release;
                    ScenePicture(now).write(file.string());
                },
                py::arg("file"), "Write a picture of the scene, as SVG. The name must end in .svg.");

        module.def(
            "load_scene", [](const std::filesystem::path &file, bool dynamics) { return loadScene(file, dynamics); },
            py::call_guard<GilRelease>(), py::arg("file"), py::kw_only(), py::arg("dynamics") = false,
            "The scene in a YAML file (docs/scene-format.md) or a .cfg file of OMPL.app. With dynamics robots of "
            "db-CBS move by controls, and their velocities count; there may be no others.");
        module.def(
            "scene_from_yaml",
            [](const std::string &text, const std::string &source, bool dynamics)
            { return sceneFromYaml(text, source, dynamics); },
            py::call_guard<GilRelease>(), py::arg("text"), py::arg("source") = "scene.yaml", py::kw_only(),
            py::arg("dynamics") = false,
            "The scene in a text, as load_scene() reads it. Errors name source, and meshes are looked for in its "
            "folder.");
        module.def(
            "load_cloud",
            [](const std::filesystem::path &file)
            {
                const auto points = [&]
                {
                    const GilRelease release;
                    return loadCloud(file).points;
                }();
                return fromPoints(points, 3);
            },
            py::arg("file"),
            "The points of a PCD or PLY file, or of a text (.xyz, .txt, .asc, .pts or .csv), of shape (n, 3), without "
            "those that are not finite: to be moved, scaled and cut by numpy, for add_cloud and change_cloud.");
        module.def(
            "load_moveit",
            [](const std::filesystem::path &file, const std::filesystem::path &request,
               const std::filesystem::path &urdf, const std::filesystem::path &srdf,
               const Mapping<std::string, std::filesystem::path> &packages)
            {
                ArmFile::Options options;
                options.packages.insert(packages.begin(), packages.end());
                return readMoveItFiles(file, request, ArmFile(urdf, srdf, options)).scene;
            },
            py::call_guard<GilRelease>(), py::arg("scene"), py::arg("request"), py::arg("urdf"), py::arg("srdf"),
            py::arg("packages") = Mapping<std::string, std::filesystem::path>(),
            "The scene in MoveIt's planning scene and motion plan request (YAML). packages are as for Robot.arm().");
    }
}
