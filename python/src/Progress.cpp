#include "Progress.h"

#include <limits>

namespace ompl_certificates_python
{
    namespace py = pybind11;

    namespace
    {
        /** How often Python is asked: often enough for people, too seldom to cost anything */
        constexpr double PERIOD = 0.05;
    }

    Progress::Progress(double seconds, std::uint64_t evaluations, py::object callback,
                       const ompl::base::Planner &planner)
      : limit_(seconds), evaluationLimit_(evaluations), callback_(std::move(callback)), planner_(planner)
    {
    }

    ompl::base::PlannerTerminationCondition Progress::condition()
    {
        return ompl::base::PlannerTerminationCondition([this] { return isOver(); });
    }

    double Progress::getSeconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    void Progress::rethrow() const
    {
        if (exception_)
            std::rethrow_exception(exception_);
    }

    bool Progress::isOver()
    {
        if (over_)
            return true;
        const double seconds = getSeconds();
        bool over = seconds >= limit_ || (evaluationLimit_ > 0 && evaluations_ >= evaluationLimit_);
        // Signals are for the thread that Python runs in, and the planner may have others.
        if (!over && seconds >= next_ && std::this_thread::get_id() == thread_)
        {
            over = report(seconds);
            next_ = getSeconds() + PERIOD;
        }
        if (over)
            over_ = true;
        else
            ++evaluations_;
        return over;
    }

    bool Progress::report(double seconds)
    {
        const py::gil_scoped_acquire acquire;
        try
        {
            if (PyErr_CheckSignals() != 0)
                throw py::error_already_set();
            if (callback_.is_none())
                return false;
            const py::object answer = callback_(seconds, bestCost());
            return answer.ptr() == Py_True;
        }
        catch (...)
        {
            // It must not pass through the planner, which is no place for exceptions.
            exception_ = std::current_exception();
            return true;
        }
    }

    double Progress::bestCost() const
    {
        for (const auto &[name, query] : planner_.getPlannerProgressProperties())
            if (name.compare(0, 10, "best cost ") == 0)
                return std::stod(query());
        return std::numeric_limits<double>::infinity();
    }
}
