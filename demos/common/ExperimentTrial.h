#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_EXPERIMENT_TRIAL_
#define OMPL_CERTIFICATES_DEMOS_COMMON_EXPERIMENT_TRIAL_

#include "common/ExperimentGrid.h"

#include <functional>
#include <nlohmann/json.hpp>

namespace demos
{
    /** \brief One run of one planner with one method: the unit of an experiment, with a seed and a file of its own */
    struct ExperimentTrial
    {
        const ExperimentGrid *grid;
        const ExperimentGrid::Workspace *workspace;
        unsigned int robots;
        const ExperimentGrid::Planner *planner;
        ompl_certificates::Method method;

        /** \brief From 1 to the grid's number of trials */
        unsigned int number;

        /** \brief The seed; the same for all that is compared in a trial */
        std::uint32_t getSeed() const
        {
            return grid->seed + number - 1;
        }

        /** \brief What the trial has in common with its repetitions, such as polygons-r3-RRT-shared */
        std::string getCell() const;

        /** \brief The name of the trial, such as polygons-r3-RRT-shared-t0007 */
        std::string getName() const;

        /** \brief Run it. Sets the seed of OMPL's random numbers, so it is for a process of its own.
            \param stop asked once in each iteration
            \return what is to be written; null if it was stopped
            \throws ompl::Exception if the planner cannot start */
        nlohmann::ordered_json run(const std::function<bool()> &stop) const;
    };
}

#endif
