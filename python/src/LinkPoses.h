#ifndef OMPL_CERTIFICATES_PYTHON_LINK_POSES_
#define OMPL_CERTIFICATES_PYTHON_LINK_POSES_

#include <ompl_certificates/robots/Robot.h>
#include <ompl_certificates/robots/RobotGoal.h>

#include <pybind11/pybind11.h>

namespace ompl_certificates_python
{
    namespace py = pybind11;

    /** \brief Whether \e object is a LinkPose */
    bool isLinkPose(const py::object &object);

    /** \brief The goal of \e robot that \e object, a LinkPose, describes
        \throws ompl::Exception if the robot is no arm, or as LinkPoseGoal does */
    ompl_certificates::RobotGoalPtr toRobotGoal(const ompl_certificates::RobotPtr &robot, const py::object &object);
}

#endif
