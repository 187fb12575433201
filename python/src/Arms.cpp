#include "Arms.h"

#include "Arrays.h"

#include <ompl_certificates/robots/Arm.h>
#include <ompl_certificates/scene/ArmFile.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <ompl/util/Exception.h>
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <utility>
#include <vector>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        using RobotHolder = std::shared_ptr<Robot>;

        using Packages = std::map<std::string, std::filesystem::path>;
        using JointValues = std::map<std::string, double>;
        using Bounds = std::optional<std::pair<std::vector<double>, std::vector<double>>>;

        ArmFile readArmFile(const std::filesystem::path &urdf, const std::filesystem::path &srdf,
                            const Packages &packages, bool visuals)
        {
            ArmFile::Options options;
            options.useVisuals = visuals;
            options.packages.insert(packages.begin(), packages.end());
            return ArmFile(urdf, srdf, options);
        }

        ArmFile::ArmSettings settingsOf(const py::object &base, const JointValues &jointValues, const Bounds &bounds,
                                        const std::vector<AttachedBody> &attached,
                                        const std::vector<std::string> &mayTouchObstacles)
        {
            ArmFile::ArmSettings settings;
            settings.base = toPose(base, 3);
            settings.jointValues = jointValues;
            if (bounds)
                settings.bounds = toBounds(bounds->first, bounds->second);
            settings.attached = attached;
            settings.mayTouchObstacles = mayTouchObstacles;
            return settings;
        }

        bool hasMovingBase(const Arm &arm)
        {
            using JointType = KinematicTree::JointType;
            const KinematicTree &tree = arm.getTree();
            return std::any_of(arm.getGroup().begin(), arm.getGroup().end(),
                               [&tree](const std::string &name)
                               {
                                   const JointType type = tree.getLinks()[tree.getChildOf(name)].joint.type;
                                   return type == JointType::PLANAR || type == JointType::FLOATING;
                               });
        }

        /** Refuse bounds that would make no difference. */
        void requireUse(const Bounds &bounds, const std::vector<std::shared_ptr<const Arm>> &arms)
        {
            if (bounds && std::none_of(arms.begin(), arms.end(), [](const auto &arm) { return hasMovingBase(*arm); }))
                throw ompl::Exception("bounds",
                                      "the group has no planar or floating joint, whose position they would "
                                      "bound; limits of other joints are those of the URDF file");
        }

        void warnOf(const std::vector<std::string> &notes)
        {
            for (const std::string &note : notes)
                if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 1) != 0)
                    throw py::error_already_set();
        }

        RobotHolder makeArm(const std::filesystem::path &urdf, const std::filesystem::path &srdf,
                            const std::string &group, const std::optional<std::string> &name, const py::object &base,
                            const JointValues &jointValues, const Bounds &bounds,
                            const std::vector<AttachedBody> &attached, const Packages &packages, bool visuals,
                            const std::vector<std::string> &mayTouchObstacles)
        {
            const ArmFile file = readArmFile(urdf, srdf, packages, visuals);
            std::vector<std::string> notes;
            const auto arm = file.makeArm(name.value_or(file.getName()), group,
                                          settingsOf(base, jointValues, bounds, attached, mayTouchObstacles), &notes);
            requireUse(bounds, {arm});
            warnOf(notes);
            return std::const_pointer_cast<Arm>(arm);
        }

        std::vector<RobotHolder> makeArms(const std::filesystem::path &urdf, const std::filesystem::path &srdf,
                                          const py::dict &groups, const py::object &base,
                                          const JointValues &jointValues, const Bounds &bounds,
                                          const std::vector<AttachedBody> &attached, const Packages &packages,
                                          bool visuals, const std::vector<std::string> &mayTouchObstacles)
        {
            std::vector<ArmFile::Part> parts;
            for (const auto &[name, group] : groups)
            {
                if (!py::isinstance<py::str>(name) || !py::isinstance<py::str>(group))
                    throw py::type_error("groups: must be a dict from names of robots to names of groups");
                parts.push_back({name.cast<std::string>(), group.cast<std::string>()});
            }
            std::vector<std::string> notes;
            const auto arms =
                readArmFile(urdf, srdf, packages, visuals)
                    .makeArms(parts, settingsOf(base, jointValues, bounds, attached, mayTouchObstacles), &notes);
            requireUse(bounds, arms);
            warnOf(notes);
            std::vector<RobotHolder> robots;
            for (const auto &arm : arms)
                robots.push_back(std::const_pointer_cast<Arm>(arm));
            return robots;
        }

        AttachedBody makeAttached(const std::string &name, const std::string &link, const Body &body,
                                  const py::object &pose, const std::vector<std::string> &touchLinks)
        {
            if (body.getDimension() != 3)
                throw ompl::Exception("body", "must be a body in space, since arms are");
            return {name, link, body, toPose(pose, 3), touchLinks};
        }

        /** The states that the SRDF file describes for a group, those that tell the values of all its joints */
        std::map<std::string, Doubles> armStates(const std::filesystem::path &urdf, const std::filesystem::path &srdf,
                                                 const std::string &group, const Packages &packages, bool visuals)
        {
            const ArmFile file = readArmFile(urdf, srdf, packages, visuals);
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
    }

    void bindArms(py::module_ &module, py::class_<Robot, RobotHolder> &robots)
    {
        py::class_<AttachedBody>(module, "AttachedBody", "A body that an arm carries, such as what it has grasped")
            .def(py::init(&makeAttached), py::arg("name"), py::arg("link"), py::arg("body"),
                 py::arg("pose") = py::none(), py::arg("touch_links") = std::vector<std::string>(),
                 "pose is in the frame of the link that holds the body. The two are not checked against each other, "
                 "nor are the body and the touch_links, such as fingers. No link may have that name.")
            .def("__repr__",
                 [](const AttachedBody &self) { return "<AttachedBody '" + self.name + "' on '" + self.link + "'>"; });

        robots
            .def_static(
                "arm", &makeArm, py::arg("urdf"), py::arg("srdf") = "", py::arg("group") = "",
                py::arg("name") = py::none(), py::arg("base") = py::none(), py::arg("joint_values") = JointValues(),
                py::arg("bounds") = py::none(), py::arg("attached") = std::vector<AttachedBody>(),
                py::arg("packages") = Packages(), py::arg("visuals") = false,
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
                "arms", &makeArms, py::arg("urdf"), py::arg("srdf"), py::arg("groups"), py::arg("base") = py::none(),
                py::arg("joint_values") = JointValues(), py::arg("bounds") = py::none(),
                py::arg("attached") = std::vector<AttachedBody>(), py::arg("packages") = Packages(),
                py::arg("visuals") = false, py::arg("may_touch_obstacles") = std::vector<std::string>(),
                "The arms of one mechanism as several robots, such as both arms of a torso. groups tells the group of "
                "joints that each moves, by the robot's name: {'left': 'left_arm', 'right': 'right_arm'}. A link "
                "belongs to the robot that moves it, and links that none moves to the first. The rest is as for "
                "arm().")
            .def_static(
                "arm_states", &armStates, py::arg("urdf"), py::arg("srdf"), py::arg("group"),
                py::arg("packages") = Packages(), py::arg("visuals") = false,
                "The states that the SRDF file names for a group, such as home: a dict of arrays, each a state "
                "of the group's arm. Those that lack a joint of the group are left out. packages and visuals are "
                "as for arm().");
    }
}
