#ifndef OMPL_CERTIFICATES_PYTHON_BINDINGS_
#define OMPL_CERTIFICATES_PYTHON_BINDINGS_

#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>

#include <string>

namespace ompl_certificates_python
{
    /** \brief Let a class have no constructor in Python, and no __new__() either, which would hand out memory that
        nothing was written to.
        \param instead what to call, for the message of the TypeError */
    template <typename Class>
    void forbidNew(Class &bound, const std::string &instead)
    {
        namespace py = pybind11;
        bound.attr("__new__") = py::staticmethod(
            py::cpp_function([instead](const py::args & /*args*/, const py::kwargs & /*keywords*/) -> py::object
                             { throw py::type_error("no constructor: " + instead); }));
    }

    /** \brief Each adds its classes and functions to the module, after those that it names. */
    void bindBodies(pybind11::module_ &module);
    void bindRobots(pybind11::module_ &module);
    void bindGoals(pybind11::module_ &module);
    void bindScenes(pybind11::module_ &module);
    void bindChecker(pybind11::module_ &module);
    void bindProof(pybind11::module_ &module);
    void bindPassingOrder(pybind11::module_ &module);
    void bindPlanning(pybind11::module_ &module);
    void bindControlPlanning(pybind11::module_ &module);
}

#endif
