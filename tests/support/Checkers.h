#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_CHECKERS_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_CHECKERS_

#include "Teams.h"

#include "ompl_certificates/planning/TeamSetup.h"

#include <memory>
#include <vector>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief The methods with certificates */
        inline const std::vector<Method> CERTIFIED{Method::BASIC, Method::PARTIAL, Method::SHARED_PROJECTION};

        /** \brief All methods for one team among the same obstacles, FCL alone first */
        struct Checkers
        {
            Checkers(const TeamStateSpacePtr &space, const ObstaclesPtr &obstacles, double resolution = 0.01)
              : team(space)
            {
                for (const Method method : allMethods())
                {
                    setups.push_back(std::make_shared<TeamSetup>(team, obstacles, method));
                    setups.back()->getSpaceInformation()->setStateValidityCheckingResolution(resolution);
                    setups.back()->getSpaceInformation()->setup();
                    // Tests are short.
                    setups.back()->getTeamChecker()->setCertificatesAfter(0);
                }
            }

            /** \brief FCL alone, the reference for the others */
            const TeamSetup &reference() const
            {
                return *setups.front();
            }

            /** \brief All others: with the contact test but no certificates, and with certificates */
            std::vector<TeamSetupPtr> compared() const
            {
                return {setups.begin() + 1, setups.end()};
            }

            /** \brief The setups of the methods with certificates */
            std::vector<TeamSetupPtr> certified() const
            {
                return {setups.begin() + 2, setups.end()};
            }

            bool isValid(const ompl::base::State *state) const
            {
                return reference().getTeamChecker()->isValid(state);
            }

            TeamStateSpacePtr team;
            std::vector<TeamSetupPtr> setups;
        };
    }
}

#endif
