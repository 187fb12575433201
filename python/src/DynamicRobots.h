#ifndef OMPL_CERTIFICATES_PYTHON_DYNAMIC_ROBOTS_
#define OMPL_CERTIFICATES_PYTHON_DYNAMIC_ROBOTS_

#include <ompl_certificates/robots/Robot.h>

#include <memory>
#include <pybind11/pybind11.h>

namespace ompl_certificates_python
{
    /** \brief Adds the makers of robots that move by controls. */
    void
    bindDynamicRobots(pybind11::class_<ompl_certificates::Robot, std::shared_ptr<ompl_certificates::Robot>> &robot);
}

#endif
