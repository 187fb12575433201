#ifndef OMPL_CERTIFICATES_PLANNING_LIMITED_RRT_CONNECT_
#define OMPL_CERTIFICATES_PLANNING_LIMITED_RRT_CONNECT_

#include <memory>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <string>

namespace ompl_certificates
{
    /** \brief RRTConnect with a limit of its iterations, which can be stopped and goes on */
    class LimitedRRTConnect
    {
    public:
        /** \brief A search for a path in at most \e iterations
            \param name what its log messages begin with, which would otherwise look like those of the user's planner
            \param range its longest step */
        LimitedRRTConnect(ompl::base::ProblemDefinitionPtr problem, const std::string &name, double range,
                          unsigned int iterations);

        /** \brief Search until \e condition becomes true; again goes on from there.
            \return a path to the goal, or null */
        std::shared_ptr<ompl::geometric::PathGeometric>
        search(const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Whether the iterations are used up */
        bool isOver() const
        {
            return limit_.getTimesCalled() > iterations_;
        }

    private:
        const ompl::base::ProblemDefinitionPtr problem_;
        const unsigned int iterations_;
        ompl::geometric::RRTConnect planner_;
        ompl::base::IterationTerminationCondition limit_;
    };
}

#endif
