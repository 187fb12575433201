#ifndef OMPL_CERTIFICATES_PYTHON_BINDINGS_
#define OMPL_CERTIFICATES_PYTHON_BINDINGS_

#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>

namespace ompl_certificates_python
{
    /** \brief Each adds its classes and functions to the module, after those that it names. */
    void bindBodies(pybind11::module_ &module);
    void bindRobots(pybind11::module_ &module);
    void bindGoals(pybind11::module_ &module);
    void bindScenes(pybind11::module_ &module);
    void bindChecker(pybind11::module_ &module);
    void bindProof(pybind11::module_ &module);
    void bindPlanning(pybind11::module_ &module);
    void bindControlPlanning(pybind11::module_ &module);
}

#endif
