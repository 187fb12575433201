#include "Reports.h"

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    py::dict toDict(const PlanReport &report)
    {
        return py::module_::import("json").attr("loads")(report.toJson());
    }

    py::dict statisticsOf(const Checker &checker)
    {
        PlanReport report;
        report.checks = checker.getSetup().getStatistics().getCounts();
        report.certificates = checker.getSetup().getTeamChecker()->getCertificateCount();
        py::dict checks = toDict(report)["checks"];
        checks["seconds"] = checker.getSetup().getStatistics().getCheckingSeconds();
        return checks;
    }
}
