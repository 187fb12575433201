#ifndef OMPL_CERTIFICATES_BENCHMARKS_COMMON_NO_GOAL_
#define OMPL_CERTIFICATES_BENCHMARKS_COMMON_NO_GOAL_

#include <limits>
#include <ompl/base/Goal.h>

namespace benchmarks
{
    /** \brief A goal that no state is in, and that nothing is known of: a plan to it does all its iterations */
    class NoGoal : public ompl::base::Goal
    {
    public:
        using Goal::Goal;

        bool isSatisfied(const ompl::base::State * /*state*/) const override
        {
            return false;
        }

        bool isSatisfied(const ompl::base::State * /*state*/, double *distance) const override
        {
            if (distance)
                *distance = std::numeric_limits<double>::infinity();
            return false;
        }
    };
}

#endif
