#include "Progress.h"

#include "Gil.h"

#include <charconv>
#include <exception>
#include <future>

namespace ompl_certificates_python
{
    namespace py = pybind11;

    namespace
    {
        /** How often Python is asked: often enough for people, too seldom to cost anything */
        constexpr std::chrono::duration<double> PERIOD(0.05);
    }

    Progress::Progress(double seconds, std::uint64_t evaluations, py::object callback,
                       const ompl::base::Planner &planner, double secondsBefore, double cost)
      : limit_(seconds)
      , evaluationLimit_(evaluations)
      , callback_(std::move(callback))
      , hasCallback_(!callback_.is_none())
      , planner_(planner)
      , secondsBefore_(secondsBefore)
      , cost_(cost)
    {
        requireCallable(callback_);
    }

    void requireCallable(const py::object &callback)
    {
        if (!callback.is_none() && !PyCallable_Check(callback.ptr()))
            throw py::type_error("callback must be callable");
    }

    ompl::base::PlannerTerminationCondition Progress::condition()
    {
        return ompl::base::PlannerTerminationCondition([this] { return isOver(); });
    }

    double Progress::getSeconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    std::exception_ptr Progress::run(const std::function<void()> &work)
    {
        std::exception_ptr exception;
        {
            const GilRelease release;
            std::future<void> end = std::async(std::launch::async,
                                               [this, &work]
                                               {
                                                   const WorkWithoutGil counted;
                                                   planning_ = std::this_thread::get_id();
                                                   work();
                                               });
            while (end.wait_for(PERIOD) != std::future_status::ready)
            {
                if (isPythonEnding())
                    over_ = true;
                if (over_)
                    continue;
                const GilAcquire acquire;
                try
                {
                    if (report())
                        over_ = true;
                }
                catch (...)
                {
                    // The planner uses this object until it has ended.
                    exception = std::current_exception();
                    over_ = true;
                }
            }
            end.get();
        }
        return exception;
    }

    bool Progress::isOver()
    {
        // This thread ends by itself then, though that which waits for it may have to stop for good.
        if (over_ || isPythonEnding())
            return true;
        const double seconds = getSeconds();
        if (seconds >= limit_ || (evaluationLimit_ > 0 && evaluations_ >= evaluationLimit_))
        {
            over_ = true;
            return true;
        }
        if (hasCallback_)
            readCost(seconds);
        ++evaluations_;
        return false;
    }

    bool Progress::report() const
    {
        if (PyErr_CheckSignals() != 0)
            throw py::error_already_set();
        if (!hasCallback_)
            return false;
        int truth = -1;
        callOrWaitForEnd(
            [&]
            {
                PyObject *const answer =
                    PyObject_CallFunction(callback_.ptr(), "dd", secondsBefore_ + getSeconds(), cost_.load());
                // numpy has a True of its own.
                if (answer)
                    truth = PyObject_IsTrue(answer);
                Py_XDECREF(answer);
            });
        if (truth < 0)
            throw py::error_already_set();
        return truth == 1;
    }

    void Progress::readCost(double seconds)
    {
        if (std::this_thread::get_id() != planning_ || seconds < nextCost_)
            return;
        nextCost_ = seconds + PERIOD.count();
        for (const auto &[name, query] : planner_.getPlannerProgressProperties())
            if (name.compare(0, 10, "best cost ") == 0)
            {
                // Whatever the program's locale; it is inf without a solution.
                const std::string text = query();
                double cost;
                if (std::from_chars(text.data(), text.data() + text.size(), cost).ec == std::errc())
                    cost_ = cost;
            }
    }

    void rethrowWith(const std::exception_ptr &exception, const std::function<py::object()> &plan)
    {
        if (!exception)
            return;
        try
        {
            std::rethrow_exception(exception);
        }
        catch (const py::error_already_set &error)
        {
            // A class of exceptions may refuse attributes; what it tells matters more.
            if (PyObject_SetAttrString(error.value().ptr(), "plan", plan().ptr()) != 0)
                PyErr_Clear();
            throw;
        }
    }
}
