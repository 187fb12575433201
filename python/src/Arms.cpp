#include "Arms.h"

#include "Arrays.h"
#include "Gil.h"
#include "Mappings.h"

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
#include <variant>
#include <vector>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        using RobotHolder = std::shared_ptr<Robot>;

        using Packages = Mapping<std::string, std::filesystem::path>;
        using JointValues = Mapping<std::string, double>;

        /** That of all links, or of some by their names */
        using Padding = std::variant<double, Mapping<std::string, double>>;

        using Bounds = std::optional<std::pair<std::vector<double>, std::vector<double>>>;

        ArmFile readArmFile(const std::filesystem::path &urdf, const std::filesystem::path &srdf,
                            const Packages &packages, bool visuals)
        {
            const GilRelease release;
            ArmFile::Options options;
            options.useVisuals = visuals;
            options.packages.insert(packages.begin(), packages.end());
            return ArmFile(urdf, srdf, options);
        }

        /** What is asked of an arm beside its files and its group */
        struct Settings
        {
            const py::object &base;
            const JointValues &jointValues;
            const Bounds &bounds;
            const std::vector<AttachedBody> &attached;
            const std::vector<TouchableObstacle> &touchable;
            const std::vector<std::string> &mayTouchObstacles;
            const Padding &padding;

            ArmFile::ArmSettings get() const
            {
                ArmFile::ArmSettings settings;
                settings.base = toPose(base, 3);
                settings.jointValues = jointValues;
                if (bounds)
                    settings.bounds = toBounds(bounds->first, bounds->second);
                settings.attached = attached;
                settings.touchable = touchable;
                settings.mayTouchObstacles = mayTouchObstacles;
                if (const double *all = std::get_if<double>(&padding))
                    settings.padding = *all;
                else
                    settings.linkPadding = std::get<1>(padding);
                return settings;
            }
        };

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
        void requireMovingBase(const Bounds &bounds, const std::vector<std::shared_ptr<const Arm>> &arms)
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

        std::vector<RobotHolder> makeParts(const ArmFile &file, const std::vector<ArmFile::Part> &parts,
                                           const Settings &asked)
        {
            const ArmFile::ArmSettings settings = asked.get();
            std::vector<std::string> notes;
            const auto arms = [&]
            {
                // Large meshes take time.
                const GilRelease release;
                return file.makeArms(parts, settings, &notes);
            }();
            requireMovingBase(asked.bounds, arms);
            warnOf(notes);
            std::vector<RobotHolder> robots;
            for (const auto &arm : arms)
                robots.push_back(std::const_pointer_cast<Arm>(arm));
            return robots;
        }

        std::vector<ArmFile::Part> toParts(const py::object &groups)
        {
            constexpr const char *complaint = "groups: must be a dict from names of robots to names of groups";
            if (!isMapping(groups))
                throw py::type_error(complaint);
            std::vector<ArmFile::Part> parts;
            for (const auto &[name, group] : dictOf(groups))
            {
                if (!py::isinstance<py::str>(name) || !py::isinstance<py::str>(group))
                    throw py::type_error(complaint);
                parts.push_back({name.cast<std::string>(), group.cast<std::string>()});
            }
            return parts;
        }

        RobotHolder armOfFile(const ArmFile &file, const std::string &group, const std::optional<std::string> &name,
                              const py::object &base, const JointValues &jointValues, const Bounds &bounds,
                              const std::vector<AttachedBody> &attached,
                              const std::vector<TouchableObstacle> &touchable,
                              const std::vector<std::string> &mayTouchObstacles, const Padding &padding)
        {
            return makeParts(file, {{name.value_or(file.getName()), group}},
                             {base, jointValues, bounds, attached, touchable, mayTouchObstacles, padding})
                .front();
        }

        std::vector<RobotHolder> armsOfFile(const ArmFile &file, const py::object &groups, const py::object &base,
                                            const JointValues &jointValues, const Bounds &bounds,
                                            const std::vector<AttachedBody> &attached,
                                            const std::vector<TouchableObstacle> &touchable,
                                            const std::vector<std::string> &mayTouchObstacles, const Padding &padding)
        {
            return makeParts(file, toParts(groups),
                             {base, jointValues, bounds, attached, touchable, mayTouchObstacles, padding});
        }

        RobotHolder makeArm(const std::filesystem::path &urdf, const std::filesystem::path &srdf,
                            const std::string &group, const std::optional<std::string> &name, const py::object &base,
                            const JointValues &jointValues, const Bounds &bounds,
                            const std::vector<AttachedBody> &attached, const Packages &packages, bool visuals,
                            const std::vector<std::string> &mayTouchObstacles,
                            const std::vector<TouchableObstacle> &touchable, const Padding &padding)
        {
            return armOfFile(readArmFile(urdf, srdf, packages, visuals), group, name, base, jointValues, bounds,
                             attached, touchable, mayTouchObstacles, padding);
        }

        std::vector<RobotHolder> makeArms(const std::filesystem::path &urdf, const std::filesystem::path &srdf,
                                          const py::object &groups, const py::object &base,
                                          const JointValues &jointValues, const Bounds &bounds,
                                          const std::vector<AttachedBody> &attached, const Packages &packages,
                                          bool visuals, const std::vector<std::string> &mayTouchObstacles,
                                          const std::vector<TouchableObstacle> &touchable, const Padding &padding)
        {
            return armsOfFile(readArmFile(urdf, srdf, packages, visuals), groups, base, jointValues, bounds, attached,
                              touchable, mayTouchObstacles, padding);
        }

        void requireSpace(const Body &body)
        {
            if (body.getDimension() != 3)
                throw ompl::Exception("body", "must be a body in space, since arms are");
        }

        AttachedBody makeAttached(const std::string &name, const std::string &link, const Body &body,
                                  const py::object &pose, const std::vector<std::string> &touchLinks)
        {
            requireSpace(body);
            return {name, link, body, toPose(pose, 3), touchLinks};
        }

        TouchableObstacle makeTouchable(const std::string &name, const Body &body, const py::object &pose,
                                        const std::vector<std::string> &touchLinks)
        {
            requireSpace(body);
            return {name, body, toPose(pose, 3), touchLinks};
        }

        /** The states that the SRDF file describes for a group, those that tell the values of all its joints */
        std::map<std::string, Doubles> statesOfFile(const ArmFile &file, const std::string &group)
        {
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

        std::map<std::string, Doubles> armStates(const std::filesystem::path &urdf, const std::filesystem::path &srdf,
                                                 const std::string &group, const Packages &packages, bool visuals)
        {
            return statesOfFile(readArmFile(urdf, srdf, packages, visuals), group);
        }

        void bindArmFiles(py::module_ &module)
        {
            py::class_<ArmFile>(
                module, "ArmFile",
                "The description of an arm, read once: a URDF file, in meters, and an SRDF file. Arms of "
                "one ArmFile share their meshes and all that is made of them. So make the arm anew from "
                "it when it grasps something, which then takes milliseconds.")
                .def(py::init(&readArmFile), py::arg("urdf"), py::arg("srdf") = "", py::arg("packages") = Packages(),
                     py::arg("visuals") = false, "The arguments are those of Robot.arm.")
                .def("__repr__", [](const ArmFile &self) { return "<ArmFile '" + self.getName() + "'>"; })
                .def_property_readonly("name", &ArmFile::getName, "The robot's name, by the URDF file")
                .def_property_readonly(
                    "groups", &ArmFile::getGroups,
                    "The names of the groups of joints. Without an SRDF file there is one, without a "
                    "name, of all joints that can move.")
                .def("joints", &ArmFile::getJoints, py::arg("group") = "",
                     "The joints of a group, in the order of the numbers of a state")
                .def("states", &statesOfFile, py::arg("group") = "", "See Robot.arm_states.")
                .def("arm", &armOfFile, py::arg("group") = "", py::arg("name") = py::none(),
                     py::arg("base") = py::none(), py::arg("joint_values") = JointValues(),
                     py::arg("bounds") = py::none(), py::arg("attached") = std::vector<AttachedBody>(),
                     py::arg("touchable") = std::vector<TouchableObstacle>(),
                     py::arg("may_touch_obstacles") = std::vector<std::string>(), py::arg("padding") = Padding(0.0),
                     "An arm. The arguments are those of Robot.arm.")
                .def("arms", &armsOfFile, py::arg("groups"), py::arg("base") = py::none(),
                     py::arg("joint_values") = JointValues(), py::arg("bounds") = py::none(),
                     py::arg("attached") = std::vector<AttachedBody>(),
                     py::arg("touchable") = std::vector<TouchableObstacle>(),
                     py::arg("may_touch_obstacles") = std::vector<std::string>(), py::arg("padding") = Padding(0.0),
                     "The arms of one mechanism. The arguments are those of Robot.arms.");
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
        py::class_<TouchableObstacle>(module, "TouchableObstacle",
                                      "An obstacle that some links of an arm may touch, such as the table that a part "
                                      "stands on")
            .def(py::init(&makeTouchable), py::arg("name"), py::arg("body"), py::arg("pose") = py::none(),
                 py::arg("touch_links") = std::vector<std::string>(),
                 "pose is in the workspace. touch_links are links and attached bodies. All other links of the arm are "
                 "checked against it. It counts as a link of the arm, which must not have that name, and is not to be "
                 "added to the scene. Other robots must not touch it; an arm that has one of that name, too, heeds its "
                 "own alone.")
            .def("__repr__", [](const TouchableObstacle &self) { return "<TouchableObstacle '" + self.name + "'>"; });
        bindArmFiles(module);

        robots
            .def_static(
                "arm", &makeArm, py::arg("urdf"), py::arg("srdf") = "", py::arg("group") = "",
                py::arg("name") = py::none(), py::arg("base") = py::none(), py::arg("joint_values") = JointValues(),
                py::arg("bounds") = py::none(), py::arg("attached") = std::vector<AttachedBody>(),
                py::arg("packages") = Packages(), py::arg("visuals") = false,
                py::arg("may_touch_obstacles") = std::vector<std::string>(),
                py::arg("touchable") = std::vector<TouchableObstacle>(), py::arg("padding") = Padding(0.0),
                "An arm from a URDF file, in meters, and an SRDF file that names the group of joints to plan "
                "for. base is the pose of its root link; joint_values are those of joints that are not of the "
                "group. A planar or floating joint in the group needs bounds of its position, (low, high), of 2 "
                "or 3 numbers. attached are bodies that it carries. packages tells the folders of packages that "
                "meshes are in (package://name/...), where they are not around the URDF file; visuals takes visual "
                "geometry in place of that for collisions. may_touch_obstacles are links, and attached bodies, that are "
                "not checked against obstacles, such as the foot of a robot that is bolted to a table; touchable are "
                "obstacles that some of them may touch. A state has the values of the group's joints, in radians "
                "or meters. padding is the distance that all links and attached bodies keep from obstacles, or a dict "
                "of those that keep one, by their names; see Body.padded. An attached body that is padded keeps its own. The arm's links are checked against each "
                "other without. For several arms of the same files take an ArmFile. What was ignored in the files is "
                "told by warnings.")
            .def_static(
                "arms", &makeArms, py::arg("urdf"), py::arg("srdf"), py::arg("groups"), py::arg("base") = py::none(),
                py::arg("joint_values") = JointValues(), py::arg("bounds") = py::none(),
                py::arg("attached") = std::vector<AttachedBody>(), py::arg("packages") = Packages(),
                py::arg("visuals") = false, py::arg("may_touch_obstacles") = std::vector<std::string>(),
                py::arg("touchable") = std::vector<TouchableObstacle>(), py::arg("padding") = Padding(0.0),
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
