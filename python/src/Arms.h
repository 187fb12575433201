#ifndef OMPL_CERTIFICATES_PYTHON_ARMS_
#define OMPL_CERTIFICATES_PYTHON_ARMS_

#include <ompl_certificates/robots/Robot.h>

#include <memory>
#include <pybind11/pybind11.h>

namespace ompl_certificates_python
{
    /** \brief Adds bodies that arms carry, and the makers of arms. */
    void bindArms(pybind11::module_ &module,
                  pybind11::class_<ompl_certificates::Robot, std::shared_ptr<ompl_certificates::Robot>> &robots);
}

#endif
