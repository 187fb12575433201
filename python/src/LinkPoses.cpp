#include "LinkPoses.h"

#include "Arrays.h"
#include "Bindings.h"

#include <ompl_certificates/robots/LinkPoseGoal.h>

#include <ompl/util/Exception.h>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        Eigen::Vector3d toPoint(const py::object &object, const std::string &what)
        {
            const std::vector<double> numbers = toNumbers(object, what);
            if (numbers.size() != 3)
                throw ompl::Exception(what, "must have 3 numbers, not " + std::to_string(numbers.size()));
            return {numbers[0], numbers[1], numbers[2]};
        }

        /** One tolerance for all axes, or three */
        Eigen::Vector3d toTolerance(const py::object &object, const std::string &what)
        {
            if (py::isinstance<py::float_>(object) || py::isinstance<py::int_>(object))
                return Eigen::Vector3d::Constant(object.cast<double>());
            return toPoint(object, what);
        }

        LinkPose makeLinkPose(const std::string &link, const py::object &position, const py::object &rotation,
                              const py::object &point, const py::object &positionTolerance,
                              const py::object &rotationTolerance)
        {
            LinkPose pose{link, toPoint(point, "point")};
            if (!position.is_none())
                pose.position = LinkPose::Position{toPoint(position, "position"),
                                                   toTolerance(positionTolerance, "position_tolerance")};
            if (!rotation.is_none())
                pose.rotation =
                    LinkPose::Rotation{toRotation(rotation), toTolerance(rotationTolerance, "rotation_tolerance")};
            return pose;
        }
    }

    bool isLinkPose(const py::object &object)
    {
        return py::isinstance<LinkPose>(object);
    }

    RobotGoalPtr toRobotGoal(const RobotPtr &robot, const py::object &object)
    {
        const auto arm = std::dynamic_pointer_cast<const Arm>(robot);
        if (!arm)
            throw ompl::Exception("robot '" + robot->getName() + "'",
                                  "a LinkPose is a goal of arms, which this robot is not");
        return std::make_shared<LinkPoseGoal>(arm, object.cast<LinkPose>());
    }

    void bindLinkPoses(py::module_ &module)
    {
        py::class_<LinkPose>(module, "LinkPose",
                             "Where a link of an arm shall be, such as its tool: a goal of all states in which it is "
                             "there")
            .def(py::init(&makeLinkPose), py::arg("link"), py::arg("position") = py::none(),
                 py::arg("rotation") = py::none(), py::kw_only(), py::arg("point") = py::make_tuple(0.0, 0.0, 0.0),
                 py::arg("position_tolerance") = LinkPose::DEFAULT_POSITION_TOLERANCE,
                 py::arg("rotation_tolerance") = LinkPose::DEFAULT_ROTATION_TOLERANCE,
                 "position is where point, in the link's frame, shall be in the workspace: anywhere if it is None. "
                 "rotation, a matrix of shape (3, 3) or (qx, qy, qz, qw), is how the link shall be turned: any way if "
                 "it is None. The tolerances are one number or three: along the workspace's axes, and in radians about "
                 "the link's. From pi on any turn about that axis will do.")
            .def("__repr__", [](const LinkPose &self) { return "<LinkPose of '" + self.link + "'>"; });
    }
}
