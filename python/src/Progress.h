#ifndef OMPL_CERTIFICATES_PYTHON_PROGRESS_
#define OMPL_CERTIFICATES_PYTHON_PROGRESS_

#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <ompl/base/Planner.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <pybind11/pybind11.h>
#include <thread>

namespace ompl_certificates_python
{
    /** \brief Refuse what cannot be called, and is not None.
        \throws pybind11::type_error if so */
    void requireCallable(const pybind11::object &callback);

    /** \brief Ends a plan: after a time or a number of evaluations, on Ctrl-C, or when the callback says so.

        The planner runs in a thread of its own. Meanwhile the thread that called looks for signals and calls the
        callback some 20 times in a second. So planners may have as many threads as they like: none of these ever
        waits for Python. */
    class Progress
    {
    public:
        /** \brief Plan for \e seconds and, if \e evaluations is not 0, for at most that many evaluations.
            \param callback called with the seconds so far and the best cost (infinite if the planner does not tell);
            None for no call. It ends the plan if it returns what is true.
            \param secondsBefore, cost what the callback was told before, if this goes on with a plan */
        Progress(double seconds, std::uint64_t evaluations, pybind11::object callback,
                 const ompl::base::Planner &planner, double secondsBefore = 0.0,
                 double cost = std::numeric_limits<double>::infinity());

        /** \brief The condition for a planner, to be used while this object lives */
        ompl::base::PlannerTerminationCondition condition();

        /** \brief Call \e work in another thread, and return when it has ended. Call it with Python's lock, which is
            released meanwhile.
            \return what the callback or the handler of a signal threw, such as KeyboardInterrupt, which made \e work
            end before its time; null if neither did. See rethrowWith().
            \throws what \e work throws */
        [[nodiscard]] std::exception_ptr run(const std::function<void()> &work);

        /** \brief How often the planner asked and was to go on */
        std::uint64_t getEvaluations() const
        {
            return evaluations_;
        }

        /** \brief Whether the planner was told to end; if not, it ended by itself */
        bool wasOver() const
        {
            return over_;
        }

        /** \brief The seconds since construction */
        double getSeconds() const;

    private:
        bool isOver();

        /** \brief Look for signals and call the callback; returns whether the plan shall end. With Python's lock. */
        bool report() const;

        /** \brief Keep the planner's best cost for the callback. In the thread that plans, for no other may ask. */
        void readCost(double seconds);

        const double limit_;
        const std::uint64_t evaluationLimit_;
        const pybind11::object callback_;
        const bool hasCallback_;
        const ompl::base::Planner &planner_;
        const double secondsBefore_;
        const std::chrono::steady_clock::time_point start_{std::chrono::steady_clock::now()};
        std::thread::id planning_;
        double nextCost_{0.0};
        std::atomic<double> cost_;
        std::atomic<std::uint64_t> evaluations_{0};
        std::atomic<bool> over_{false};
    };

    /** \brief Throw \e exception, unless it is null. If it is one of Python, then \e plan is its attribute of that
        name, if it takes attributes: what had been found by then is not lost. */
    void rethrowWith(const std::exception_ptr &exception, const std::function<pybind11::object()> &plan);
}

#endif
