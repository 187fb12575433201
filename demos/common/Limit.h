#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_LIMIT_
#define OMPL_CERTIFICATES_DEMOS_COMMON_LIMIT_

#include <atomic>
#include <chrono>
#include <cstdint>
#include <ompl/base/PlannerTerminationCondition.h>

namespace demos
{
    /** \brief How long a planner may plan: for some time, or for a number of evaluations of its termination condition.
        Most of OMPL's planners evaluate that once in each iteration, some more often. An interrupt ends planning, too.
        */
    class Limit
    {
    public:
        /** \brief Plan for \e seconds, or, if \e evaluations is not 0, for that many evaluations. Time runs from now
            on. */
        Limit(double seconds, std::uint64_t evaluations);

        /** \brief The condition for a planner, to be used while this object lives */
        ompl::base::PlannerTerminationCondition condition();

        /** \brief How often the condition was evaluated and let the planner go on */
        std::uint64_t getEvaluations() const
        {
            return evaluations_;
        }

        /** \brief How much of the time or of the evaluations is used up, from 0 to 1 */
        double getFraction() const;

        /** \brief The seconds since construction */
        double getSeconds() const;

    private:
        bool isReached();

        double seconds_;
        std::uint64_t limit_;
        std::atomic<std::uint64_t> evaluations_{0};
        std::chrono::steady_clock::time_point start_;
    };
}

#endif
