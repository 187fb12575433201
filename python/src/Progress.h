#ifndef OMPL_CERTIFICATES_PYTHON_PROGRESS_
#define OMPL_CERTIFICATES_PYTHON_PROGRESS_

#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <ompl/base/Planner.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <pybind11/pybind11.h>
#include <thread>

namespace ompl_certificates_python
{
    /** \brief Ends a plan: after a time or a number of evaluations, on Ctrl-C, or when the callback says so.

        While the planner runs without Python's lock, the thread that plans takes it some 20 times in a second, to look
        for signals and to call the callback. An exception ends the plan and is thrown again by rethrow(). */
    class Progress
    {
    public:
        /** \brief Plan for \e seconds and, if \e evaluations is not 0, for at most that many evaluations.
            \param callback called with the seconds so far and the best cost (infinite if the planner does not tell);
            None for no call. It ends the plan if it returns True. */
        Progress(double seconds, std::uint64_t evaluations, pybind11::object callback,
                 const ompl::base::Planner &planner);

        /** \brief The condition for a planner, to be used while this object lives */
        ompl::base::PlannerTerminationCondition condition();

        /** \brief Throw what the callback or a signal handler has thrown; with Python's lock. */
        void rethrow() const;

        /** \brief How often the planner asked and was to go on */
        std::uint64_t getEvaluations() const
        {
            return evaluations_;
        }

        /** \brief The seconds since construction */
        double getSeconds() const;

    private:
        bool isOver();

        /** \brief Look for signals and call the callback; returns whether the plan shall end. */
        bool report(double seconds);

        /** \brief The planner's best cost so far */
        double bestCost() const;

        const double limit_;
        const std::uint64_t evaluationLimit_;
        const pybind11::object callback_;
        const ompl::base::Planner &planner_;
        const std::thread::id thread_{std::this_thread::get_id()};
        const std::chrono::steady_clock::time_point start_{std::chrono::steady_clock::now()};
        double next_{0.0};
        std::atomic<std::uint64_t> evaluations_{0};
        std::atomic<bool> over_{false};
        std::exception_ptr exception_;
    };
}

#endif
