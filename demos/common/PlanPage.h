#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_PLAN_PAGE_
#define OMPL_CERTIFICATES_DEMOS_COMMON_PLAN_PAGE_

#include "ompl_certificates/pictures/PlanViewer.h"

#include <string>

namespace demos
{
    /** \brief The page of a plan for browsers
        \param setup a TeamSetup or a TeamControlSetup, after it has planned
        \param tree the planner's */
    template <typename Setup>
    std::string planPage(const ompl_certificates::Scene &scene, const Setup &setup,
                         const ompl_certificates::PlanReport &report, const ompl::base::PlannerData &tree)
    {
        ompl_certificates::PlanViewer viewer(scene);
        if (report.solved)
            viewer.setPath(setup.getSolutionPath());
        viewer.setTree(tree);
        viewer.setCertificates(setup.getTeamChecker()->getCertificates());
        viewer.setReport(report);
        return viewer.toHtml();
    }
}

#endif
