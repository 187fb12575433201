#include "support/Checkers.h"

#include <gtest/gtest.h>
#include <limits>
#include <ompl/util/Console.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

class NotFinite : public testing::TestWithParam<unsigned int>
{
};

TEST_P(NotFinite, StatesAreInvalidForAllMethods)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    Random random(GetParam());
    const auto team = anyTeam(GetParam());
    // Also without obstacles, where certificates are infinite
    for (const unsigned int obstacles : {0U, 5U})
    {
        const Checkers checkers(team, anyObstacles(random, GetParam(), obstacles));
        for (int i = 0; i < 100; ++i)
        {
            const auto state = randomState(random, team);
            if (!checkers.isValid(state.get()))
                continue;
            std::vector<double> reals;
            team->copyToReals(reals, state.get());
            const double broken =
                random.chance(0.5) ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
            for (std::size_t k = 0; k < reals.size(); ++k)
            {
                std::vector<double> changed = reals;
                changed[k] = broken;
                ob::ScopedState<> to(team);
                team->copyFromReals(to.get(), changed);
                for (const auto &setup : checkers.setups)
                {
                    SCOPED_TRACE(nameOf(setup->getTeamChecker()->getMethod()) + ", coordinate " + std::to_string(k));
                    EXPECT_FALSE(setup->getTeamChecker()->isValid(to.get()));
                    EXPECT_FALSE(setup->getSpaceInformation()->checkMotion(state.get(), to.get()));
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kind, NotFinite, testing::Range(0U, TEAMS));
