#include "Bindings.h"
#include "Gil.h"

#include <ompl/util/Exception.h>

PYBIND11_MODULE(_core, module)
{
    namespace py = pybind11;
    module.doc() = "Planning for teams of robots with safety certificates";
    module.attr("__version__") = OMPL_CERTIFICATES_VERSION;
    py::register_exception<ompl::Exception>(module, "Error", PyExc_RuntimeError).attr("__doc__") =
        "What was given makes no sense; one line that names the file or the argument, and the value.";
    ompl_certificates_python::waitForWorkAtEnd();
    ompl_certificates_python::bindBodies(module);
    ompl_certificates_python::bindRobots(module);
    ompl_certificates_python::bindGoals(module);
    ompl_certificates_python::bindScenes(module);
    ompl_certificates_python::bindChecker(module);
    ompl_certificates_python::bindProof(module);
    ompl_certificates_python::bindPassingOrder(module);
    ompl_certificates_python::bindPlanning(module);
    ompl_certificates_python::bindControlPlanning(module);
}
