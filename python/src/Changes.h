#ifndef OMPL_CERTIFICATES_PYTHON_CHANGES_
#define OMPL_CERTIFICATES_PYTHON_CHANGES_

#include "Checker.h"

namespace ompl_certificates_python
{
    /** \brief Adds the methods that change a checker's obstacles. */
    void bindChanges(py::class_<Checker, std::shared_ptr<Checker>> &checker);
}

#endif
