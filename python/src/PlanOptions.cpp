#include "PlanOptions.h"

#include "Numbers.h"
#include "Quiet.h"

#include <ompl_certificates/planning/Planners.h>

#include <cmath>
#include <ompl/util/Exception.h>
#include <ompl/util/RandomNumbers.h>

namespace ompl_certificates_python
{
    namespace ob = ompl::base;

    void requirePositive(double value, const char *what, bool finite)
    {
        if (!(value > 0.0) || (finite && std::isinf(value)))
            throw ompl::Exception(what, std::string("must be positive") + (finite ? " and finite" : "") + ", not " +
                                            py::str(py::float_(value)).cast<std::string>());
    }

    void seedRandomNumbers(std::uint32_t seed)
    {
        // OMPL warns of a second seed, which is meant for programs that plan once.
        const Quiet quiet(ompl::msg::LOG_NONE);
        ompl::RNG::setSeed(seed);
    }

    void setParameters(ob::Planner &planner, const PlanOptions &options)
    {
        for (const auto &[key, value] : options.parameters)
            ompl_certificates::setParameter(
                planner, key, isBool(value) ? (py::bool_(value) ? "1" : "0") : std::string(py::str(value)));
    }

    py::dict parametersOf(const ob::Planner &planner)
    {
        py::dict parameters;
        for (const auto &[key, parameter] : planner.params().getParams())
            parameters[py::str(key)] = py::make_tuple(parameter->getValue(), parameter->getRangeSuggestion());
        return parameters;
    }
}
