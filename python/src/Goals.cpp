#include "Goals.h"

#include "Arrays.h"
#include "Bindings.h"

#include <ompl_certificates/robots/AnyOfGoals.h>
#include <ompl_certificates/robots/LinkPoseGoal.h>
#include <ompl_certificates/robots/ZoneGoal.h>
#include <ompl_certificates/team/Rotations.h>

#include <cmath>
#include <ompl/util/Exception.h>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <sstream>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        /** A box of positions */
        struct Zone
        {
            std::vector<double> low, high;
        };

        /** A pose, and whether its points and its rotation were given as in the plane */
        struct PoseOfLink
        {
            LinkPose pose;
            std::optional<bool> planar{};

            /** Note how something was given, which must not contradict what was given before. */
            void note(bool isPlanar, const std::string &what)
            {
                if (planar && *planar != isPlanar)
                    throw ompl::Exception(what, isPlanar ? "must be of space, as what comes before is"
                                                         : "must be of the plane, as what comes before is");
                planar = isPlanar;
            }
        };

        /** Goals of which any will do: Zones and LinkPoses, and states */
        struct AnyOf
        {
            std::vector<py::object> goals;
        };

        std::string listOf(const std::vector<double> &numbers)
        {
            std::ostringstream text;
            for (std::size_t i = 0; i < numbers.size(); ++i)
                text << (i == 0 ? "(" : ", ") << numbers[i];
            return text.str() + ")";
        }

        std::vector<double> listOf(const Eigen::Vector3d &point, bool planar)
        {
            return {point.data(), point.data() + (planar ? 2 : 3)};
        }

        Zone makeZone(const py::object &lowest, const py::object &highest)
        {
            Zone zone{toNumbers(lowest, "Zone: low"), toNumbers(highest, "Zone: high")};
            if (zone.low.size() != zone.high.size() || (zone.low.size() != 2 && zone.low.size() != 3))
                throw ompl::Exception("Zone", "low and high must both have 2 or 3 numbers, not " +
                                                  std::to_string(zone.low.size()) + " and " +
                                                  std::to_string(zone.high.size()));
            for (std::size_t i = 0; i < zone.low.size(); ++i)
                if (!std::isfinite(zone.low[i]) || !std::isfinite(zone.high[i]) || zone.low[i] > zone.high[i])
                    throw ompl::Exception("Zone", "must be finite with no number of low above that of high, not from " +
                                                      listOf(zone.low) + " to " + listOf(zone.high));
            return zone;
        }

        /** A point of space, or of the plane */
        Eigen::Vector3d toPoint(const py::object &object, const std::string &what, PoseOfLink &pose)
        {
            const std::vector<double> numbers = toNumbers(object, what);
            if (numbers.size() != 2 && numbers.size() != 3)
                throw ompl::Exception(what, "must have 2 or 3 numbers, not " + std::to_string(numbers.size()));
            for (const double number : numbers)
                if (!std::isfinite(number))
                    throw ompl::Exception(what, "must be finite, not " + listOf(numbers));
            pose.note(numbers.size() == 2, what);
            return {numbers[0], numbers[1], numbers.size() == 3 ? numbers[2] : 0.0};
        }

        /** One tolerance for all axes, or three */
        Eigen::Vector3d toTolerance(const py::object &object, const std::string &what, double byDefault)
        {
            if (object.is_none())
                return Eigen::Vector3d::Constant(byDefault);
            const std::vector<double> numbers =
                isNumber(object) ? std::vector<double>(3, object.cast<double>()) : toNumbers(object, what);
            if (numbers.size() != 3)
                throw ompl::Exception(what, "must be one number or three, not " + std::to_string(numbers.size()));
            for (const double number : numbers)
                if (!(number >= LinkPose::LEAST_TOLERANCE))
                    throw ompl::Exception(what, "must be at least 1e-9, not " + listOf(numbers));
            return {numbers[0], numbers[1], numbers[2]};
        }

        /** A rotation; one number is an angle in the plane. */
        Eigen::Matrix3d toTurn(const py::object &object, PoseOfLink &pose)
        {
            pose.note(isNumber(object), "rotation");
            if (!isNumber(object))
                return toRotation(object);
            const double angle = object.cast<double>();
            if (!std::isfinite(angle))
                throw ompl::Exception("rotation", "must be finite");
            return planarPose(0.0, 0.0, angle).linear();
        }

        PoseOfLink makeLinkPose(const std::string &link, const py::object &position, const py::object &rotation,
                                const py::object &point, const py::object &positionTolerance,
                                const py::object &rotationTolerance)
        {
            if (position.is_none() && rotation.is_none())
                throw ompl::Exception("LinkPose", "must have a position, a rotation or both");
            if (position.is_none() && (!point.is_none() || !positionTolerance.is_none()))
                throw ompl::Exception("LinkPose", "a point and a position_tolerance need a position");
            if (rotation.is_none() && !rotationTolerance.is_none())
                throw ompl::Exception("LinkPose", "a rotation_tolerance needs a rotation");
            PoseOfLink result{LinkPose{link}};
            LinkPose &pose = result.pose;
            if (!position.is_none())
                pose.position = LinkPose::Position{
                    toPoint(position, "position", result),
                    toTolerance(positionTolerance, "position_tolerance", LinkPose::DEFAULT_POSITION_TOLERANCE)};
            if (!point.is_none())
                pose.point = toPoint(point, "point", result);
            if (!rotation.is_none())
                pose.rotation =
                    LinkPose::Rotation{toTurn(rotation, result), toTolerance(rotationTolerance, "rotation_tolerance",
                                                                             LinkPose::DEFAULT_ROTATION_TOLERANCE)};
            return result;
        }

        std::string describePose(const PoseOfLink &self)
        {
            const bool planar = self.planar.value_or(false);
            std::string text = "<LinkPose of '" + self.pose.link + "'";
            if (self.pose.position)
                text += " at " + listOf(listOf(self.pose.position->point, planar));
            return text + (self.pose.rotation ? ", turned>" : ">");
        }
    }

    namespace
    {
        AnyOf makeAnyOf(const py::object &goals)
        {
            AnyOf result;
            for (const py::handle goal : py::iter(goals))
                if (py::isinstance<AnyOf>(goal))
                {
                    // All goals are drawn equally often.
                    const auto more = goal.cast<AnyOf>().goals;
                    result.goals.insert(result.goals.end(), more.begin(), more.end());
                }
                else if (isNumber(py::reinterpret_borrow<py::object>(goal)))
                    throw ompl::Exception("AnyOf", "takes a list of goals; a number is none");
                else
                    result.goals.push_back(py::reinterpret_borrow<py::object>(goal));
            if (result.goals.empty())
                throw ompl::Exception("AnyOf", "must have one goal at least");
            return result;
        }

        RobotGoalPtr toAnyOfGoals(const RobotPtr &robot, const AnyOf &any)
        {
            const Rotations rotations(*robot->getStateSpace());
            std::vector<std::vector<double>> states;
            std::vector<RobotGoalPtr> goals;
            for (const py::object &goal : any.goals)
            {
                if (isGoal(goal))
                {
                    goals.push_back(toRobotGoal(robot, goal));
                    continue;
                }
                std::vector<double> state = toNumbers(goal, "goal");
                if (state.size() == rotations.count)
                {
                    rotations.wrapAngles(state);
                    if (const double length = rotations.normalizeQuaternions(state); length != 1.0)
                        throw ompl::Exception("robot '" + robot->getName() + "'",
                                              "goal: a quaternion must have length 1, not " + std::to_string(length));
                }
                states.push_back(std::move(state));
            }
            return std::make_shared<AnyOfGoals>(robot, states, std::move(goals));
        }
    }

    bool isGoal(const py::object &object)
    {
        return py::isinstance<PoseOfLink>(object) || py::isinstance<Zone>(object) || py::isinstance<AnyOf>(object);
    }

    RobotGoalPtr toRobotGoal(const RobotPtr &robot, const py::object &object)
    {
        if (py::isinstance<Zone>(object))
        {
            const Zone zone = object.cast<Zone>();
            ompl::base::RealVectorBounds box(static_cast<unsigned int>(zone.low.size()));
            box.low = zone.low;
            box.high = zone.high;
            return std::make_shared<ZoneGoal>(robot, box);
        }
        if (py::isinstance<AnyOf>(object))
            return toAnyOfGoals(robot, object.cast<AnyOf>());
        if (!isGoal(object))
            throw ompl::Exception("goal", "must be a LinkPose, a Zone or an AnyOf");
        const auto arm = std::dynamic_pointer_cast<const Arm>(robot);
        if (!arm)
            throw ompl::Exception("robot '" + robot->getName() + "'",
                                  "a LinkPose is a goal of arms, which this robot is not");
        const auto goal = object.cast<PoseOfLink>();
        if (goal.planar && *goal.planar != (arm->getWorkspaceDimension() == 2))
            throw ompl::Exception(
                "robot '" + robot->getName() + "': goal of link '" + goal.pose.link + "'",
                *goal.planar ? "points must have 3 numbers, and a rotation more than an angle: the arm moves in space"
                             : "points must have 2 numbers, and a rotation must be an angle: the arm is planar");
        return std::make_shared<LinkPoseGoal>(arm, goal.pose);
    }

    void bindGoals(py::module_ &module)
    {
        py::class_<Zone>(
            module, "Zone",
            "A box that a rigid robot or a car with a trailer shall get into: a goal of all states with its "
            "position there, however it is turned")
            .def(py::init(&makeZone), py::arg("low"), py::arg("high"),
                 "low and high bound the position, with 2 or 3 numbers.")
            .def_readonly("low", &Zone::low, "The least numbers of the position")
            .def_readonly("high", &Zone::high, "The largest numbers of the position")
            .def("__repr__",
                 [](const Zone &self) { return "<Zone from " + listOf(self.low) + " to " + listOf(self.high) + ">"; });

        py::class_<AnyOf>(
            module, "AnyOf",
            "Several goals of a robot, any of which will do: such as docks, grasps, or the states that an "
            "inverse kinematics of your own found")
            .def(
                py::init(&makeAnyOf), py::arg("goals"),
                "goals are states, and whatever else may be a goal of that robot: a Zone, a LinkPose. The goals of an AnyOf "
                "among them are taken out of it.")
            .def_readonly("goals", &AnyOf::goals, "The goals: a list")
            .def("__repr__",
                 [](const AnyOf &self)
                 {
                     const std::size_t count = self.goals.size();
                     return "<AnyOf " + std::to_string(count) + (count == 1 ? " goal>" : " goals>");
                 });

        py::class_<PoseOfLink>(module, "LinkPose",
                               "Where a link of an arm shall be, such as its tool: a goal of all states in which it is "
                               "there")
            .def(
                py::init(&makeLinkPose), py::arg("link"), py::arg("position") = py::none(),
                py::arg("rotation") = py::none(), py::kw_only(), py::arg("point") = py::none(),
                py::arg("position_tolerance") = py::none(), py::arg("rotation_tolerance") = py::none(),
                "position is where point, in the link's frame, shall be in the workspace: anywhere if it is None. "
                "rotation, a matrix of shape (3, 3) or (qx, qy, qz, qw), is how the link shall be turned: any way if "
                "it is None. In the plane points have 2 numbers, and the rotation is an angle. The tolerances are "
                "one number or three, 0.001 and 0.01 if they are None: how far off the point may be along the "
                "workspace's axes, and the link about its own: XYZ Euler angles, in radians. From pi on any turn about "
                "that axis will do, and the angles are XZY if that is the y axis.")
            .def_property_readonly(
                "link", [](const PoseOfLink &self) { return self.pose.link; }, "The name of the link")
            .def("__repr__", &describePose);
    }
}
