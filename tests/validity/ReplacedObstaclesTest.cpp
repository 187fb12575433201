#include "support/Checkers.h"

#include "ompl_certificates/obstacles/ObstacleChange.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** Obstacles without a fingerprint, as a user may bring */
    class Nameless : public FclObstacles
    {
    public:
        using FclObstacles::FclObstacles;

        std::uint64_t getFingerprint() const override
        {
            return 0;
        }
    };

    std::vector<PlacedBody> worldOf(std::uint64_t seed)
    {
        Random random(seed);
        std::vector<PlacedBody> bodies;
        for (int i = 0; i < 60; ++i)
            bodies.push_back({Body::box(0.4, 0.4), random.pose(2, HALF)});
        return bodies;
    }

    template <typename Kind>
    ObstaclesPtr makeObstacles(const std::vector<PlacedBody> &bodies)
    {
        return std::make_shared<Kind>(bodies, 2U);
    }
}

TEST(ReplacedObstacles, LeaveNothingOfWhatWasKnown)
{
    const TeamStateSpacePtr team = teamOfDiscs();
    for (const auto &make : {makeObstacles<FclObstacles>, makeObstacles<Nameless>})
        for (const bool told : {false, true})
        {
            Random random(7);
            const ObstaclesPtr before = make(worldOf(1)), after = make(worldOf(2));
            TeamSetup setup(team, before);
            setup.getSpaceInformation()->setup();
            const auto checker = setup.getTeamChecker();
            checker->setCertificatesAfter(0);
            checker->setAdaptive(false);
            std::vector<ob::ScopedState<>> states;
            for (int i = 0; i < 2000; ++i)
                states.push_back(randomState(random, team));
            for (auto &state : states)
                checker->isValid(state.get());
            const std::size_t known = checker->getCertificateCount();
            ASSERT_GT(known, 50U);
            // The same obstacles once more: who has a fingerprint keeps what is known.
            checker->changeObstacles({make(worldOf(1)), {}, {}});
            EXPECT_EQ(checker->getCertificateCount(), known);
            checker->changeObstacles(told ? ObstacleChange::replacing(before, after)
                                          : ObstacleChange{after, nullptr, nullptr});
            TeamSetup fresh(team, after, Method::FCL);
            fresh.getSpaceInformation()->setup();
            for (const auto &state : states)
                ASSERT_EQ(checker->isValid(state.get()), fresh.getTeamChecker()->isValid(state.get()));
            for (const Certificate &certificate : checker->getCertificates())
                EXPECT_NEAR(certificate.clearance, after->clearance(certificate.point), 1e-6);
        }
}
