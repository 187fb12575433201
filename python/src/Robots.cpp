#include "Arms.h"
#include "Arrays.h"
#include "Bindings.h"
#include "DynamicRobots.h"
#include "Gil.h"
#include "Goals.h"
#include "Numbers.h"
#include "Signals.h"

#include <ompl_certificates/robots/Arm.h>
#include <ompl_certificates/robots/CarWithTrailer.h>
#include <ompl_certificates/robots/LinkPoseGoal.h>
#include <ompl_certificates/robots/RigidRobot.h>
#include <ompl_certificates/team/Coordinates.h>
#include <ompl_certificates/team/Rotations.h>

#include <algorithm>
#include <cmath>
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

        RobotHolder makeRigid(const std::string &name, const Body &body, const py::object &low, const py::object &high,
                              bool turns, std::optional<double> turningRadius, const std::vector<Placed> &keepOut)
        {
            const auto bounds = toBounds(low, high);
            if (turningRadius && (!turns || body.getDimension() == 3))
                throw ompl::Exception("turning_radius", "is for planar bodies that turn");
            if (turningRadius)
                return hold(confined(RigidRobot::inReedsShepp(name, body, *turningRadius, bounds), keepOut));
            if (body.getDimension() == 2)
                return hold(confined(
                    turns ? RigidRobot::inSE2(name, body, bounds) : RigidRobot::inR2(name, body, bounds), keepOut));
            return hold(confined(turns ? RigidRobot::inSE3(name, body, bounds) : RigidRobot::inR3(name, body, bounds),
                                 keepOut));
        }

        RobotHolder makeCarWithTrailer(const std::string &name, const Body &car, const Body &trailer,
                                       double hitchLength, const py::object &low, const py::object &high,
                                       const std::vector<Placed> &keepOut)
        {
            return hold(confined(std::make_shared<CarWithTrailer>(name, car, trailer, hitchLength, toBounds(low, high)),
                                 keepOut));
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

        using RowMatrix = Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>;

        ompl::base::ScopedState<> toState(const Robot &robot, const std::vector<double> &state)
        {
            const auto &space = robot.getStateSpace();
            if (state.size() != space->getValueLocations().size())
                throw ompl::Exception("state", "must have " + std::to_string(space->getValueLocations().size()) +
                                                   " numbers, not " + std::to_string(state.size()));
            // OMPL aborts at angles and quaternions out of their range.
            if (!std::all_of(state.begin(), state.end(), [](double number) { return std::isfinite(number); }))
                throw ompl::Exception("state", "all numbers must be finite");
            const Rotations rotations(*space);
            std::vector<double> numbers = state;
            rotations.wrapAngles(numbers);
            if (const double length = rotations.normalizeQuaternions(numbers); length != 1.0)
                throw ompl::Exception("state", "a quaternion must have length 1, not " + std::to_string(length));
            ompl::base::ScopedState<> scoped(space);
            space->copyFromReals(scoped.get(), numbers);
            return scoped;
        }

        /** How many bodies a robot moves: zones come after them. */
        std::size_t countMoved(const Robot &robot)
        {
            std::size_t count = robot.getBodies().size();
            while (robot.isZone(count - 1))
                --count;
            return count;
        }

        std::vector<Body> bodiesOf(const Robot &robot)
        {
            const std::vector<Body> &all = robot.getBodies();
            return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(countMoved(robot))};
        }

        py::array_t<double> posesOf(const Robot &robot, const std::vector<double> &state)
        {
            std::vector<Pose> poses(robot.getBodies().size());
            robot.placeBodies(toState(robot, state).get(), poses.data());
            poses.resize(countMoved(robot));
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
        Doubles sampleGoal(const std::shared_ptr<Robot> &robot, const py::object &object, const Number &count,
                           const Number &seed)
        {
            const RobotGoalPtr goal = toRobotGoal(robot, object);
            const auto &space = robot->getStateSpace();
            std::vector<double> rows, row;
            {
                const GilRelease release;
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

        /** The state of a goal that the robot reaches from \e state on, or None */
        py::object reach(const std::shared_ptr<Robot> &robot, const py::object &object,
                         const std::vector<double> &state)
        {
            const auto goal = std::dynamic_pointer_cast<const LinkPoseGoal>(toRobotGoal(robot, object));
            if (!goal)
                throw ompl::Exception("goal", "must be a LinkPose: of others, take sample_goal()");
            auto reached = toState(*robot, state);
            if (!goal->reach(reached.get()))
                return py::none();
            const std::vector<double> row = reached.reals();
            return Doubles(static_cast<py::ssize_t>(row.size()), row.data());
        }

        double goalDistance(const std::shared_ptr<Robot> &robot, const py::object &object,
                            const std::vector<double> &state)
        {
            return toRobotGoal(robot, object)->distance(toState(*robot, state).get());
        }
    }

    void bindRobots(py::module_ &module)
    {
        py::class_<Robot, RobotHolder> robots(module, "Robot",
                                              "One member of a team: a rigid body, a car with a trailer, an arm, or a "
                                              "robot that moves by controls");
        forbidNew(robots, "Robot.rigid(), Robot.arm() and other functions of the class make robots");
        robots
            .def_static(
                "rigid", &makeRigid, py::arg("name"), py::arg("body"), py::arg("low"), py::arg("high"),
                py::arg("turns") = true, py::arg("turning_radius") = py::none(), py::kw_only(),
                py::arg("keep_out") = std::vector<Placed>(),
                "A robot of one body. low and high bound its position, with 2 or 3 numbers. A state is x, y "
                "and, if it turns, the angle in radians; in space x, y, z and the quaternion qx, qy, qz, qw. "
                "With a turning_radius it drives as a car does, forward and backward along the curves of Reeds "
                "and Shepp; its x axis points ahead. keep_out lists zones that this robot alone must not enter, "
                "pairs of a body and its pose.")
            .def_static("car_with_trailer", &makeCarWithTrailer, py::arg("name"), py::arg("car"), py::arg("trailer"),
                        py::arg("hitch_length"), py::arg("low"), py::arg("high"), py::kw_only(),
                        py::arg("keep_out") = std::vector<Placed>(),
                        "A car that pulls a trailer in the plane: x, y, its angle, the trailer's angle. It moves "
                        "straight from state to state, also sideways, as if it had no wheels: to drive take Robot.car "
                        "with a trailer, and plan_controls(). keep_out lists zones that it must not enter, pairs of a "
                        "body and its pose.")
            .def("__repr__", [](const Robot &robot) { return "<Robot '" + robot.getName() + "'>"; })
            .def_property_readonly("name", &Robot::getName, "The robot's name, unique in its team")
            .def_property_readonly("bodies", &bodiesOf, "The bodies that the robot moves")
            .def_property_readonly(
                "coordinates", [](const Robot &robot) { return coordinateNames(robot); },
                "The names of the numbers of a state")
            .def_property_readonly(
                "bounds", [](const Robot &robot) { return toBoundArrays(*robot.getStateSpace()); },
                "From where to where the numbers of a state may be: two arrays, low and high. A joint without limits, "
                "and an angle, is from -pi to pi.")
            .def_property_readonly("dimension", &Robot::getWorkspaceDimension, "The dimension of the workspace: 2 or 3")
            .def("poses", &posesOf, py::arg("state"),
                 "Where each body is in a state: matrices, of shape (bodies, 4, 4). Bodies of an arm have frames of "
                 "their own, see link_pose.")
            .def_property_readonly("links", &linksOf, "Of an arm, the name of the link of each body")
            .def("link_pose", &linkPose, py::arg("state"), py::arg("link"),
                 "Of an arm, where the frame of a link is in a state, such as that of its tool: a matrix, of shape "
                 "(4, 4)")
            .def(
                "sample_goal", &sampleGoal, py::arg("goal"), py::arg("count") = 1, py::arg("seed") = 1,
                "Random states of a LinkPose, a Zone or an AnyOf, of shape (count, coordinates); fewer rows if no more are "
                "found. This is the inverse kinematics of an arm. Bounds are kept, collisions do not matter.")
            .def("reach", &reach, py::arg("goal"), py::arg("state"),
                 "The state of a LinkPose that an arm reaches from a state on by small changes of its joints, of shape "
                 "(coordinates,); None if the search got stuck. Bounds are kept, collisions do not matter.")
            .def(
                "goal_distance", &goalDistance, py::arg("goal"), py::arg("state"),
                "How far a state is from a LinkPose, a Zone or an AnyOf; 0 if it is in it. For a LinkPose lengths beyond the "
                "position's tolerances and radians beyond the rotation's are added.");
        bindArms(module, robots);
        bindDynamicRobots(robots);
    }
}
