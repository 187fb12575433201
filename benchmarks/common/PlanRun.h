#ifndef OMPL_CERTIFICATES_BENCHMARKS_COMMON_PLAN_RUN_
#define OMPL_CERTIFICATES_BENCHMARKS_COMMON_PLAN_RUN_

#include "ompl_certificates/scene/Scene.h"

#include <string>
#include <vector>

namespace benchmarks
{
    /** \brief A plan of a scene with one planner and one method */
    struct PlanTask
    {
        const ompl_certificates::Scene &scene;

        /** \brief The name of a planner; see plannerNames() */
        std::string planner{"RRT"};

        ompl_certificates::Method method{ompl_certificates::Method::SHARED_PROJECTION};

        /** \brief How often the planner's termination condition is evaluated: mostly once per iteration */
        unsigned int iterations{10000};

        /** \brief The time after which a plan ends in any case, in seconds of the clock; 0 for none. What ends so is
            not the same again. */
        double seconds{0.0};

        /** \brief The length of the planner's steps; 0 for the planner's own */
        double range{0.0};

        /** \brief The longest valid segment as a fraction of a component's extent; 0 for the scene's */
        double resolution{0.0};

        std::uint_fast32_t seed{1};

        /** \brief Whether certificates are known from another plan of the same scene; else each tree begins without
            any. */
        bool warm{false};

        /** \brief Whether the checker steps aside where certificates do not pay. If not, counts do not depend on the
            clock. */
        bool adaptive{true};

        /** \brief Whether to plan as OMPL alone does, in place of \e method: a CompoundStateSpace with the team's
            distance, FCL's check, and the nearest-neighbor structure that OMPL gives the planner. */
        bool stock{false};

        /** \brief Whether to use up the iterations. Trees grow towards a goal that is never reached; planners that must
            sample their goal solve the same problem again and again. */
        bool keepGoing{true};
    };

    /** \brief The outcome of a PlanTask */
    struct PlanResult
    {
        /** \brief The digest of each tree that was grown; mostly one */
        std::vector<std::string> digests;

        /** \brief Whether the last plan is a solution */
        bool solved{false};

        /** \brief The number of states of all trees */
        std::size_t states{0};

        ompl_certificates::CheckCounts counts;

        /** \brief The certificates at the end of the last tree */
        std::size_t certificates{0};

        /** \brief The time in checks, in seconds by the clock */
        double checkingSeconds{0.0};

        /** \brief The time of planning, in seconds of the processor */
        double totalSeconds{0.0};

        /** \brief The time of planning, in seconds by the clock */
        double clockSeconds{0.0};
    };

    /** \brief The planners that run() knows */
    const std::vector<std::string> &plannerNames();

    /** \brief Plan. Tasks that differ only in the method grow equal trees.
        \throws ompl::Exception if there is no such planner, or if the start is not valid */
    PlanResult run(const PlanTask &task);

    /** \brief The middle one of \e values, which must not be empty, or the mean of the middle two */
    double median(std::vector<double> values);

    /** \brief The geometric mean of positive \e values */
    double geometricMean(const std::vector<double> &values);
}

#endif
