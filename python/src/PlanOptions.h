#ifndef OMPL_CERTIFICATES_PYTHON_PLAN_OPTIONS_
#define OMPL_CERTIFICATES_PYTHON_PLAN_OPTIONS_

#include <ompl_certificates/pictures/PlanReport.h>

#include <cstdint>
#include <map>
#include <ompl/base/Planner.h>
#include <pybind11/pybind11.h>
#include <string>

namespace ompl_certificates_python
{
    namespace py = pybind11;

    /** \brief What plan() and plan_controls() both are asked for */
    struct PlanOptions
    {
        /** \brief The planner's name */
        std::string planner;
        double seconds;
        /** \brief 0 for no limit */
        std::uint64_t iterations;
        std::uint32_t seed;
        py::object callback;
        std::map<std::string, py::object> parameters;
    };

    /** \brief Refuse a \e value that is not positive, or infinite if it must be \e finite.
        \throws ompl::Exception that names \e what */
    void requirePositive(double value, const char *what, bool finite = false);

    /** \brief Seed OMPL's random numbers, for this plan. */
    void seedRandomNumbers(std::uint32_t seed);

    /** \brief Set the parameters of \e planner
        \throws ompl::Exception as ompl_certificates::setParameter() does */
    void setParameters(ompl::base::Planner &planner, const PlanOptions &options);

    /** \brief The parameters of a planner, with their values and the ranges that OMPL suggests */
    py::dict parametersOf(const ompl::base::Planner &planner);

    /** \brief Report times and counts of \e setup, which has planned.
        \param setup a TeamSetup or a TeamControlSetup */
    template <typename Setup>
    void setCounts(ompl_certificates::PlanReport &report, const Setup &setup, std::uint64_t iterations)
    {
        report.approximate = !report.solved && setup.haveSolutionPath();
        report.totalSeconds = setup.getLastPlanComputationTime();
        report.checkingSeconds = setup.getStatistics().getCheckingSeconds();
        report.checks = setup.getStatistics().getCounts();
        report.iterations = iterations;
        report.certificates = setup.getTeamChecker()->getCertificateCount();
    }
}

#endif
