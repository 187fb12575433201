#include "Goals.h"

#include "Arrays.h"
#include "Bindings.h"

#include <ompl_certificates/robots/LinkPoseGoal.h>
#include <ompl_certificates/robots/ZoneGoal.h>

#include <cmath>
#include <ompl/util/Exception.h>
#include <pybind11/stl.h>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        /** A box of positions */
        struct Zone
        {
            ompl::base::RealVectorBounds box;
        };

        /** A point of space, or of the plane */
        Eigen::Vector3d toPoint(const py::object &object, const std::string &what)
        {
            const std::vector<double> numbers = toNumbers(object, what);
            if (numbers.size() != 2 && numbers.size() != 3)
                throw ompl::Exception(what, "must have 2 or 3 numbers, not " + std::to_string(numbers.size()));
            return {numbers[0], numbers[1], numbers.size() == 3 ? numbers[2] : 0.0};
        }

        bool isNumber(const py::object &object)
        {
            return py::isinstance<py::float_>(object) || py::isinstance<py::int_>(object);
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
                    throw ompl::Exception(what, "must be at least 1e-9, not " + std::to_string(number));
            return {numbers[0], numbers[1], numbers[2]};
        }

        /** A rotation; one number is an angle in the plane. */
        Eigen::Matrix3d toTurn(const py::object &object)
        {
            if (!isNumber(object))
                return toRotation(object);
            const double angle = object.cast<double>();
            if (!std::isfinite(angle))
                throw ompl::Exception("rotation", "must be finite");
            return planarPose(0.0, 0.0, angle).linear();
        }

        LinkPose makeLinkPose(const std::string &link, const py::object &position, const py::object &rotation,
                              const py::object &point, const py::object &positionTolerance,
                              const py::object &rotationTolerance)
        {
            if (position.is_none() && rotation.is_none())
                throw ompl::Exception("LinkPose", "must have a position, a rotation or both");
            if (position.is_none() && (!point.is_none() || !positionTolerance.is_none()))
                throw ompl::Exception("LinkPose", "a point and a position_tolerance need a position");
            if (rotation.is_none() && !rotationTolerance.is_none())
                throw ompl::Exception("LinkPose", "a rotation_tolerance needs a rotation");
            LinkPose pose{link};
            if (!point.is_none())
                pose.point = toPoint(point, "point");
            if (!position.is_none())
                pose.position = LinkPose::Position{
                    toPoint(position, "position"),
                    toTolerance(positionTolerance, "position_tolerance", LinkPose::DEFAULT_POSITION_TOLERANCE)};
            if (!rotation.is_none())
                pose.rotation =
                    LinkPose::Rotation{toTurn(rotation), toTolerance(rotationTolerance, "rotation_tolerance",
                                                                     LinkPose::DEFAULT_ROTATION_TOLERANCE)};
            return pose;
        }
    }

    bool isGoal(const py::object &object)
    {
        return py::isinstance<LinkPose>(object) || py::isinstance<Zone>(object);
    }

    RobotGoalPtr toRobotGoal(const RobotPtr &robot, const py::object &object)
    {
        if (py::isinstance<Zone>(object))
            return std::make_shared<ZoneGoal>(robot, object.cast<Zone>().box);
        const auto arm = std::dynamic_pointer_cast<const Arm>(robot);
        if (!arm)
            throw ompl::Exception("robot '" + robot->getName() + "'",
                                  "a LinkPose is a goal of arms, which this robot is not");
        return std::make_shared<LinkPoseGoal>(arm, object.cast<LinkPose>());
    }

    void bindGoals(py::module_ &module)
    {
        py::class_<Zone>(
            module, "Zone",
            "A box that a rigid robot or a car with a trailer shall get into: a goal of all states with its "
            "position there, however it is turned")
            .def(py::init([](const std::vector<double> &low, const std::vector<double> &high)
                          { return Zone{toBounds(low, high)}; }),
                 py::arg("low"), py::arg("high"), "low and high bound the position, with 2 or 3 numbers.")
            .def("__repr__", [](const Zone &) { return "<Zone>"; });

        py::class_<LinkPose>(module, "LinkPose",
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
                "that axis will do.")
            .def("__repr__", [](const LinkPose &self) { return "<LinkPose of '" + self.link + "'>"; });
    }
}
