#ifndef OMPL_CERTIFICATES_PYTHON_REPORTS_
#define OMPL_CERTIFICATES_PYTHON_REPORTS_

#include "Checker.h"

#include <ompl_certificates/pictures/PlanReport.h>

namespace ompl_certificates_python
{
    /** \brief A report as a dict, with the keys of its JSON */
    py::dict toDict(const ompl_certificates::PlanReport &report);

    /** \brief The counts of a checker as a dict, with the keys of a report's "checks" and "seconds" */
    py::dict statisticsOf(const Checker &checker);
}

#endif
