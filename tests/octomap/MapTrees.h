#ifndef OMPL_CERTIFICATES_TESTS_OCTOMAP_MAP_TREES_
#define OMPL_CERTIFICATES_TESTS_OCTOMAP_MAP_TREES_

#include "ompl_certificates/planning/Planners.h"
#include "support/Checkers.h"
#include "support/IterationLimit.h"
#include "support/Quiet.h"

#include <ompl/base/PlannerData.h>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief Plans anew with \e setup. Returns the states and edges of the planner's tree. */
        inline std::vector<double> growTree(TeamSetup &setup, const std::string &plannerName, unsigned int seed,
                                            const ompl::base::ScopedState<> &start,
                                            const ompl::base::ScopedState<> &goal)
        {
            const Quiet quiet;
            setup.getSpaceInformation()->setup();  // draws random numbers the first time
            ompl::RNG::setSeed(seed);
            setup.clear();
            setup.setStartAndGoalStates(start, goal);
            const auto planner = makePlanner(plannerName, setup.getSpaceInformation());
            setup.setPlanner(planner);
            setup.setup();
            ompl::base::IterationTerminationCondition condition(plannerName == "RRTstar" ? 100 : 400);
            setup.solve(ompl::base::PlannerTerminationCondition(condition));
            ompl::base::PlannerData data(setup.getSpaceInformation());
            planner->getPlannerData(data);
            std::vector<double> tree;
            for (unsigned int i = 0; i < data.numVertices(); ++i)
            {
                for (const double real : realsOf(dynamic_cast<const TeamStateSpace &>(*setup.getStateSpace()),
                                                 data.getVertex(i).getState()))
                    tree.push_back(real);
                std::vector<unsigned int> edges;
                data.getEdges(i, edges);
                tree.insert(tree.end(), edges.begin(), edges.end());
            }
            return tree;
        }

        /** \brief A random state that is valid */
        inline ompl::base::ScopedState<> validState(Random &random, const TeamStateSpacePtr &team,
                                                    const TeamSetup &setup)
        {
            auto state = randomState(random, team);
            while (!setup.getTeamChecker()->isValid(state.get()))
                state = randomState(random, team);
            return state;
        }
    }
}

#endif
