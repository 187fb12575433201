#ifndef OMPL_CERTIFICATES_PYTHON_DYNAMIC_ROBOTS_
#define OMPL_CERTIFICATES_PYTHON_DYNAMIC_ROBOTS_

#include "Arrays.h"

#include <ompl_certificates/robots/Robot.h>

#include <memory>
#include <pybind11/pybind11.h>
#include <vector>

namespace ompl_certificates_python
{
    /** \brief \e robot, kept out of \e zones, if there are any
        \throws ompl::Exception as ConfinedRobot */
    ompl_certificates::RobotPtr confined(const ompl_certificates::RobotPtr &robot, const std::vector<Placed> &zones);

    /** \brief Adds the makers of robots that move by controls. */
    void
    bindDynamicRobots(pybind11::class_<ompl_certificates::Robot, std::shared_ptr<ompl_certificates::Robot>> &robot);
}

#endif
