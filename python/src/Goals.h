#ifndef OMPL_CERTIFICATES_PYTHON_GOALS_
#define OMPL_CERTIFICATES_PYTHON_GOALS_

#include <ompl_certificates/robots/Robot.h>
#include <ompl_certificates/robots/RobotGoal.h>

#include <pybind11/pybind11.h>

namespace ompl_certificates_python
{
    namespace py = pybind11;

    /** \brief Whether \e object is a LinkPose, a Zone or an AnyOf */
    bool isGoal(const py::object &object);

    /** \brief The goal of \e robot that \e object, a LinkPose, a Zone or an AnyOf, describes
        \throws ompl::Exception if a LinkPose is for a robot that is no arm, or as LinkPoseGoal, ZoneGoal and AnyOfGoals
        do */
    ompl_certificates::RobotGoalPtr toRobotGoal(const ompl_certificates::RobotPtr &robot, const py::object &object);
}

#endif
