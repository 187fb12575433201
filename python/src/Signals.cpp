#include "Signals.h"

#include "Gil.h"

#include <pybind11/pybind11.h>

namespace ompl_certificates_python
{
    namespace py = pybind11;

    void Signals::look()
    {
        // Another thread of Python may keep the lock for 5 ms, so it is not asked for often.
        constexpr std::chrono::milliseconds period(100);
        const auto now = std::chrono::steady_clock::now();
        if (now - last_ < period && !isPythonEnding())
            return;
        const GilAcquire acquire;
        if (PyErr_CheckSignals() != 0)
            throw py::error_already_set();
        last_ = std::chrono::steady_clock::now();
    }
}
