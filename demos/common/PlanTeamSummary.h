#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_PLAN_TEAM_SUMMARY_
#define OMPL_CERTIFICATES_DEMOS_COMMON_PLAN_TEAM_SUMMARY_

#include "common/PlanTeamOptions.h"

#include "ompl_certificates/pictures/PlanReport.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/scene/Scene.h"

namespace demos
{
    /** \brief Print what came of a plan, and how its checks were settled */
    void print(const ompl_certificates::PlanReport &report, const ompl_certificates::TeamSetup &setup);

    /** \brief Print which files of a path were not written, if there is none */
    void printUnwritten(const PlanTeamOptions &options, const ompl_certificates::PlanReport &report);

    /** \brief Print the planner's iterations, and how large its tree is if the report knows it */
    void printTree(const ompl_certificates::PlanReport &report);

    /** \brief Print what is known of the solution between the states at which it was checked, if the report tells
        \param count the number of its motions
        \param motions what these are called
        \param samples what the states are called, between which collisions were looked for */
    void printProof(const ompl_certificates::PlanReport &report, std::size_t count, const char *motions,
                    const char *samples);

    /** \brief Print what was left out of \e scene, or changed, when it was read */
    void printNotes(const ompl_certificates::Scene &scene);

    /** \brief Print what would be planned, for --dry-run */
    void printTask(const PlanTeamOptions &options, const ompl_certificates::Scene &scene,
                   const ompl::base::Planner &planner);
}

#endif
