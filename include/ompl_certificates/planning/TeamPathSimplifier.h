#ifndef OMPL_CERTIFICATES_PLANNING_TEAM_PATH_SIMPLIFIER_
#define OMPL_CERTIFICATES_PLANNING_TEAM_PATH_SIMPLIFIER_

#include "ompl_certificates/team/Team.h"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/RandomNumbers.h>

namespace ompl_certificates
{
    /** \brief Lowers the cost of a team's path by changing one robot's path at a time, with the others' motions fixed.

        ompl::geometric::PathSimplifier replaces a part of a path by one motion of the whole team, which is rarely free
        for many robots. Here a robot takes a shortcut, moves a corner of its way, or goes the same way at another pace.
        A change is kept if it lowers the cost, or makes ways shorter at the same cost, and the motion validator, of any
        class, accepts the motions that change. So no robot wanders where a makespan would let it.
        The cost of a path must be the sum of its motions' costs, as of all objectives of this library; that of the rest
        is not looked at.

        @par External documentation
        R. Geraerts, M. Overmars, Creating high-quality paths for motion planning, 2007 (partial shortcuts). */
    class TeamPathSimplifier
    {
    public:
        /** \brief A simplifier for paths of \e si's space. The robots are those of a TeamValidityChecker in \e si, if it
            or the motion validator has one; else those of the space.
            \throws ompl::Exception as Team::Team() if there are none */
        TeamPathSimplifier(ompl::base::SpaceInformationPtr si, ompl::base::OptimizationObjectivePtr objective);

        /** \brief Try \e attempts changes of a valid path; fewer if \e condition becomes true
            \return whether the path has a lower cost now, or shorter ways */
        bool simplify(ompl::geometric::PathGeometric &path, std::uint64_t attempts,
                      const ompl::base::PlannerTerminationCondition &condition);

        /** \brief Try changes of a valid path as long as they help. It ends when some 20 for each of its corners lower
            the cost by less than a thousandth, or when \e condition becomes true.
            \return whether the path has a lower cost now */
        bool simplify(ompl::geometric::PathGeometric &path, const ompl::base::PlannerTerminationCondition &condition);

    private:
        const ompl::base::SpaceInformationPtr si_;
        const ompl::base::OptimizationObjectivePtr objective_;
        const Team team_;
        ompl::RNG random_;
    };
}

#endif
