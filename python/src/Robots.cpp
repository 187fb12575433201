#include "Arrays.h"
#include "Bindings.h"
#include "DynamicRobots.h"
#include "Goals.h"
#include "Signals.h"

#include <ompl_certificates/robots/CarWithTrailer.h>
#include <ompl_certificates/robots/RigidRobot.h>
#include <ompl_certificates/scene/ArmFile.h>
#include <ompl_certificates/pictures/PathFile.h>

#include <ompl/base/ScopedState.h>
#include <ompl/util/Exception.h>
#include <optional>
#include <pybind11/stl.h>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        // pybind11 holds shared pointers to robots that are not constant; nothing here changes them.
        using RobotHolder = std::shared_ptr<Robot>;

        RobotHolder hold(const RobotPtr &robot)
        {
            return std::const_pointer_cast<Robot>(robot);
        }

        RobotHolder makeRigid(const std::string &name, const Body &body, const std::vector<double> &low,
                              const std::vector<double> &high, bool turns, std::optional<double> turningRadius)
        {
            const auto bounds = toBounds(low, high);
            if (turningRadius && (!turns || body.getDimension() == 3))
                throw ompl::Exception("turning_radius", "is for planar bodies that turn");
            if (turningRadius)
                return hold(RigidRobot::inReedsShepp(name, body, *turningRadius, bounds));
            if (body.getDimension() == 2)
                return hold(turns ? RigidRobot::inSE2(name, body, bounds) : RigidRobot::inR2(name, body, bounds));
            return hold(turns ? RigidRobot::inSE3(name, body, bounds) : RigidRobot::inR3(name, body, bounds));
        }

        RobotHolder makeArm(const std::filesystem::path &urdf, const std::filesystem::path &srdf,
                            const std::string &group, const std::optional<std::string> &name, const py::object &base,
                            const std::map<std::string, double> &jointValues,
                            const std::optional<std::pair<std::vector<double>, std::vector<double>>> &bounds,
                            const std::vector<AttachedBody> &attached,
                            const std::map<std::string, std::filesystem::path> &packages, bool visuals,
                            const std::vector<std::string> &mayTouchObstacles)
        {
            ArmFile::Options options;
            options.useVisuals = visuals;
            options.packages.insert(packages.begin(), packages.end());
            const ArmFile file(urdf, srdf, options);
            ArmFile::ArmSettings settings;
            settings.base = toPose(base, 3);
            settings.jointValues = jointValues;
            if (bounds)
                settings.bounds = toBounds(bounds->first, bounds->second);
            settings.attached = attached;
            settings.mayTouchObstacles = mayTouchObstacles;
            std::vector<std::string> notes;
            const auto arm = file.makeArm(name.value_or(file.getName()), group, settings, &notes);
            for (const std::string &note : notes)
                if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 1) != 0)
                    throw py::error_already_set();
            return hold(arm);
        }

        AttachedBody makeAttached(const std::string &name, const std::string &link, const Body &body,
                                  const py::object &pose, const std::vector<std::string> &touchLinks)
        {
            if (body.getDimension() != 3)
                throw ompl::Exception("body", "must be a body in space, since arms are");
            return {name, link, body, toPose(pose, 3), touchLinks};
        }

        const Arm &requireArm(const Robot &robot)
        {
            const auto *arm = dynamic_cast<const Arm *>(&robot);
            if (!arm)
                throw ompl::Exception("robot '" + robot.getName() + "'", "is no arm, so it has no links");
            return *arm;
        }

        std::vector<std::string> linksOf(const Robot &robot)
        {
            std::vector<std::string> links;
            for (std::size_t body = 0; body < robot.getBodies().size(); ++body)
                links.push_back(requireArm(robot).getLinkOfBody(body));
            return links;
        }

        /** The states that the SRDF file describes for a group, those that tell the values of all its joints */
        std::map<std::string, Doubles> armStates(const std::filesystem::path &urdf, const std::filesystem::path &srdf,
                                                 const std::string &group,
                                                 const std::map<std::string, std::filesystem::path> &packages,
                                                 bool visuals)
        {
            ArmFile::Options options;
            options.useVisuals = visuals;
            options.packages.insert(packages.begin(), packages.end());
            const ArmFile file(urdf, srdf, options);
            const std::vector<std::string> &joints = file.getJoints(group);
            std::map<std::string, Doubles> states;
            for (const std::string &name : file.getStates(group))
            {
                const std::map<std::string, double> &values = file.getState(group, name);
                std::vector<double> state;
                for (const std::string &joint : joints)
                    if (const auto value = values.find(joint); value != values.end())
                        state.push_back(value->second);
                if (state.size() == joints.size())
                    states.emplace(name, Doubles(static_cast<py::ssize_t>(state.size()), state.data()));
            }
            return states;
        }

        using RowMatrix = Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>;

        ompl::base::ScopedState<> toState(const Robot &robot, const std::vector<double> &state)
        {
            const auto &space = robot.getStateSpace();
            if (state.size() != space->getValueLocations().size())
                throw ompl::Exception("state", "must have " + std::to_string(space->getValueLocations().size()) +
                                                   " numbers, not " + std::to_string(state.size()));
            ompl::base::ScopedState<> scoped(space);
            space->copyFromReals(scoped.get(), state);
            return scoped;
        }

        py::array_t<double> posesOf(const Robot &robot, const std::vector<double> &state)
        {
            std::vector<Pose> poses(robot.getBodies().size());
            robot.placeBodies(toState(robot, state).get(), poses.data());
            py::array_t<double> result({static_cast<py::ssize_t>(poses.size()), py::ssize_t(4), py::ssize_t(4)});
            for (std::size_t i = 0; i < poses.size(); ++i)
                RowMatrix(result.mutable_data() + 16 * i) = poses[i].matrix();
            return result;
        }

        py::array_t<double> linkPose(const Robot &robot, const std::vector<double> &state, const std::string &link)
        {
            const Pose pose = requireArm(robot).getLinkPose(toState(robot, state).get(), link);
            py::array_t<double> result({py::ssize_t(4), py::ssize_t(4)});
            RowMatrix(result.mutable_data()) = pose.matrix();
            return result;
        }

        /** States of a goal, one a row: fewer than \e count if no more are found */
        Doubles sampleGoal(const std::shared_ptr<Robot> &robot, const py::object &object, unsigned int count,
                           unsigned int seed)
        {
            const RobotGoalPtr goal = toRobotGoal(robot, object);
            const auto &space = robot->getStateSpace();
            std::vector<double> rows, row;
            {
                const py::gil_scoped_release release;
                ompl::RNG random(seed);
                ompl::base::ScopedState<> state(space);
                Signals signals;
                for (unsigned int i = 0; i < count && goal->sample(random, state.get()); ++i)
                {
                    signals.handle();
                    space->copyToReals(row, state.get());
                    rows.insert(rows.end(), row.begin(), row.end());
                }
            }
            const auto width = static_cast<py::ssize_t>(space->getValueLocations().size());
            Doubles result({static_cast<py::ssize_t>(rows.size()) / width, width});
            std::copy(rows.begin(), rows.end(), result.mutable_data());
            return result;
        }

        double goalDistance(const std::shared_ptr<Robot> &robot, const py::object &object,
                            const std::vector<double> &state)
        {
            return toRobotGoal(robot, object)->distance(toState(*robot, state).get());
        }
    }

    void bindRobots(py::module_ &module)
    {
        py::class_<AttachedBody>(module, "AttachedBody", "A body that an arm carries, such as what it has grasped")
            .def(py::init(&makeAttached), py::arg("name"), py::arg("link"), py::arg("body"),
                 py::arg("pose") = py::none(), py::arg("touch_links") = std::vector<std::string>(),
                 "pose is in the frame of the link that holds the body. The two are not checked against each other, "
                 "nor are the body and the touch_links, such as fingers. No link may have that name.")
            .def("__repr__",
                 [](const AttachedBody &self) { return "<AttachedBody '" + self.name + "' on '" + self.link + "'>"; });

        py::class_<Robot, RobotHolder> robots(module, "Robot",
                                              "One member of a team: a rigid body, a car with a trailer, an arm, or a "
                                              "robot that moves by controls");
        forbidNew(robots, "Robot.rigid(), Robot.arm() and other functions of the class make robots");
        robots
            .def_static("rigid", &makeRigid, py::arg("name"), py::arg("body"), py::arg("low"), py::arg("high"),
                        py::arg("turns") = true, py::arg("turning_radius") = py::none(),
                        "A robot of one body. low and high bound its position, with 2 or 3 numbers. A state is x, y "
                        "and, if it turns, the angle in radians; in space x, y, z and the quaternion qx, qy, qz, qw. "
                        "With a turning_radius it drives as a car does, forward and backward along the curves of Reeds "
                        "and Shepp; its x axis points ahead.")
            .def_static(
                "car_with_trailer",
                [](const std::string &name, const Body &car, const Body &trailer, double hitchLength,
                   const std::vector<double> &low, const std::vector<double> &high) -> RobotHolder
                { return std::make_shared<CarWithTrailer>(name, car, trailer, hitchLength, toBounds(low, high)); },
                py::arg("name"), py::arg("car"), py::arg("trailer"), py::arg("hitch_length"), py::arg("low"),
                py::arg("high"), "A car that pulls a trailer in the plane: x, y, its angle, the trailer's angle")
            .def_static(
                "arm", &makeArm, py::arg("urdf"), py::arg("srdf") = "", py::arg("group") = "",
                py::arg("name") = py::none(), py::arg("base") = py::none(),
                py::arg("joint_values") = std::map<std::string, double>(), py::arg("bounds") = py::none(),
                py::arg("attached") = std::vector<AttachedBody>(),
                py::arg("packages") = std::map<std::string, std::filesystem::path>(), py::arg("visuals") = false,
                py::arg("may_touch_obstacles") = std::vector<std::string>(),
                "An arm from a URDF file, in meters, and an SRDF file that names the group of joints to plan "
                "for. base is the pose of its root link; joint_values are those of joints that are not of the "
                "group. A planar or floating joint in the group needs bounds of its position, (low, high), of 2 "
                "or 3 numbers. attached are bodies that it carries. packages tells the folders of packages that "
                "meshes are in (package://name/...), where they are not around the URDF file; visuals takes visual "
                "geometry in place of that for collisions. may_touch_obstacles are links, and attached bodies, that are "
                "not checked against obstacles, such as the foot of a robot that is bolted to a table. A state has the values of the group's joints, in radians "
                "or meters. What was ignored in the files is told by warnings.")
            .def_static(
                "arm_states", &armStates, py::arg("urdf"), py::arg("srdf"), py::arg("group"),
                py::arg("packages") = std::map<std::string, std::filesystem::path>(), py::arg("visuals") = false,
                "The states that the SRDF file names for a group, such as home: a dict of arrays, each a state "
                "of the group's arm. Those that lack a joint of the group are left out. packages and visuals are "
                "as for arm().")
            .def("__repr__", [](const Robot &robot) { return "<Robot '" + robot.getName() + "'>"; })
            .def_property_readonly("name", &Robot::getName, "The robot's name, unique in its team")
            .def_property_readonly("bodies", &Robot::getBodies, "The bodies that the robot moves")
            .def_property_readonly(
                "coordinates", [](const Robot &robot) { return coordinateNames(robot); },
                "The names of the numbers of a state")
            .def_property_readonly("dimension", &Robot::getWorkspaceDimension, "The dimension of the workspace: 2 or 3")
            .def("poses", &posesOf, py::arg("state"),
                 "Where each body is in a state: matrices, of shape (bodies, 4, 4). Bodies of an arm have frames of "
                 "their own, see link_pose.")
            .def_property_readonly("links", &linksOf, "Of an arm, the name of the link of each body")
            .def("link_pose", &linkPose, py::arg("state"), py::arg("link"),
                 "Of an arm, where the frame of a link is in a state, such as that of its tool: a matrix, of shape "
                 "(4, 4)")
            .def("sample_goal", &sampleGoal, py::arg("goal"), py::arg("count") = 1, py::arg("seed") = 1,
                 "Random states of a LinkPose or a Zone, of shape (count, coordinates); fewer rows if no more are "
                 "found. This is the inverse kinematics of an arm. Bounds are kept, collisions do not matter.")
            .def("goal_distance", &goalDistance, py::arg("goal"), py::arg("state"),
                 "How far a state is from a LinkPose or a Zone; 0 if it is in it. For a LinkPose lengths beyond the "
                 "position's tolerances and radians beyond the rotation's are added.");
        bindDynamicRobots(robots);
    }
}
