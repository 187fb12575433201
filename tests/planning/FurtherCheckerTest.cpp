#include "support/CrowdProblem.h"
#include "support/Message.h"
#include "support/Quiet.h"
#include "support/Warnings.h"

#include "ompl_certificates/planning/DRRTstar.h"
#include "ompl_certificates/team/TeamPathLength.h"
#include "ompl_certificates/validity/SharedProjection.h"

#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    using Mode = CertificateMotionValidator::Mode;

    /** The first disc keeps out of a zone that no obstacle fills. */
    bool keepsOut(const ob::State *state)
    {
        const auto *values =
            state->as<ob::CompoundState>()->components[0]->as<ob::RealVectorStateSpace::StateType>()->values;
        return std::hypot(values[0], values[1]) > 1.0;
    }

    class DerivedChecker : public SharedProjection
    {
    public:
        using SharedProjection::SharedProjection;

        bool isValid(const ob::State *state) const override
        {
            return keepsOut(state) && SharedProjection::isValid(state);
        }
    };

    /** Three robots among boxes whose states are asked of a checker of the user's, derived or put in its place */
    class FurtherChecker : public testing::TestWithParam<bool>
    {
    protected:
        TeamSetupPtr makeSetup(std::uint64_t seed, Mode mode = CertificateMotionValidator::DISCRETE,
                               unsigned int boxes = 5) const
        {
            auto setup = crowd(seed, 3, 4.0, boxes, Method::SHARED_PROJECTION, mode);
            const ob::SpaceInformationPtr &si = setup->getSpaceInformation();
            if (GetParam())
            {
                const auto obstacles = std::make_shared<FclObstacles>(
                    std::vector<PlacedBody>{{Body::box(0.5, 2.0), planarPose(2.0, 0.0)}}, 2);
                const auto derived = std::make_shared<DerivedChecker>(si, obstacles);
                setup->setStateValidityChecker(derived);
                si->setMotionValidator(std::make_shared<CertificateMotionValidator>(derived, mode));
            }
            else
                setup->setStateValidityChecker([checker = setup->getTeamChecker()](const ob::State *state)
                                               { return keepsOut(state) && checker->isValid(state); });
            si->setup();
            return setup;
        }

    private:
        const Quiet quiet_;
    };

    /** Plans, with the planner that the setup chooses, and simplifies */
    void planAroundTheZone(TeamSetup &setup, ob::ScopedState<> &start, ob::ScopedState<> &goal)
    {
        start = std::vector<double>{-3.0, 0.1, -3.0, 3.0, 0.0, 3.5, -3.5};
        goal = std::vector<double>{3.0, 0.1, 3.0, 3.0, 0.0, 3.5, 3.5};
        setup.setStartAndGoalStates(start, goal);
        ASSERT_EQ(setup.solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_EQ(setup.getPlanner()->getName(), "RRTConnect");
        setup.simplifySolution(2.0);
    }
}

TEST_P(FurtherChecker, DecidesMotionsAsWithOmplsValidator)
{
    for (std::uint64_t seed = 1; seed <= scaled(5); ++seed)
    {
        const auto setup = makeSetup(seed);
        const ob::SpaceInformationPtr &si = setup->getSpaceInformation();
        const ob::DiscreteMotionValidator reference(si);
        Random random(seed);
        ob::ScopedState<> last(si), expected(si);
        unsigned int refused = 0, motions = 0;
        for (int i = 0; i < 2000 && motions < 200; ++i)
        {
            const ob::ScopedState<> from = randomState(random, si->getStateSpace());
            const ob::ScopedState<> to = randomStateNear(random, from, random.uniform(0.0, 0.5));
            if (!si->isValid(from.get()))
                continue;
            ++motions;
            std::pair<ob::State *, double> found(last.get(), -1.0), wanted(expected.get(), -1.0);
            const bool valid = reference.checkMotion(from.get(), to.get());
            refused += !valid && setup->getTeamChecker()->isValid(to.get());
            ASSERT_EQ(si->checkMotion(from.get(), to.get()), valid) << "seed " << seed << " motion " << i;
            ASSERT_EQ(si->getMotionValidator()->checkMotion(from.get(), to.get(), found),
                      reference.checkMotion(from.get(), to.get(), wanted));
            ASSERT_DOUBLE_EQ(found.second, wanted.second) << "seed " << seed << " motion " << i;
            ASSERT_TRUE(valid || si->equalStates(last.get(), expected.get()));
        }
        EXPECT_GT(refused, 3U);
    }
}

TEST_P(FurtherChecker, KeepsItsRuleInContinuousMode)
{
    const auto setup = makeSetup(3, CertificateMotionValidator::CONTINUOUS);
    const ob::SpaceInformationPtr &si = setup->getSpaceInformation();
    const ob::DiscreteMotionValidator reference(si);
    Random random(3);
    ob::ScopedState<> last(si);
    unsigned int accepted = 0, refused = 0;
    for (int i = 0; i < 1000; ++i)
    {
        const ob::ScopedState<> from = randomState(random, si->getStateSpace());
        const ob::ScopedState<> to = randomStateNear(random, from, random.uniform(0.0, 0.5));
        if (!si->isValid(from.get()))
            continue;
        const bool valid = si->checkMotion(from.get(), to.get());
        ++(valid ? accepted : refused);
        EXPECT_TRUE(!valid || reference.checkMotion(from.get(), to.get())) << "motion " << i;
        std::pair<ob::State *, double> found(last.get(), -1.0);
        EXPECT_EQ(si->getMotionValidator()->checkMotion(from.get(), to.get(), found), valid);
        EXPECT_TRUE(valid || si->checkMotion(from.get(), last.get())) << "motion " << i;
    }
    EXPECT_GT(accepted, 20U);
    EXPECT_GT(refused, 20U);
}

// It may be expensive.
TEST(FurtherCheckers, AreAskedOnlyWhereCertificatesSayFree)
{
    const auto setup = crowd(1, 3, 4.0, 8, Method::SHARED_PROJECTION, CertificateMotionValidator::DISCRETE);
    const ob::SpaceInformationPtr &si = setup->getSpaceInformation();
    unsigned int asked = 0, invalid = 0;
    dynamic_cast<CertificateMotionValidator &>(*si->getMotionValidator())
        .setRule(
            [&, checker = setup->getTeamChecker()](const ob::State *state)
            {
                ++asked;
                invalid += checker->isValid(state) ? 0 : 1;
                return true;
            });
    si->setup();
    Random random(1);
    ob::ScopedState<> last(si);
    unsigned int blocked = 0;
    for (int i = 0; i < 500; ++i)
    {
        const ob::ScopedState<> from = randomState(random, si->getStateSpace());
        ob::ScopedState<> to = randomStateNear(random, from, random.uniform(0.0, 2.0));
        to.enforceBounds();
        if (!setup->getTeamChecker()->isValid(from.get()))
            continue;
        std::pair<ob::State *, double> found(last.get(), -1.0);
        blocked += si->getMotionValidator()->checkMotion(from.get(), to.get(), found) ? 0 : 1;
        si->checkMotion(from.get(), to.get());
    }
    EXPECT_GT(blocked, 20U);
    EXPECT_GT(asked, 100U);
    EXPECT_EQ(invalid, 0U);
}

TEST(FurtherCheckers, MayBeGivenAsARuleAlone)
{
    const Quiet quiet;
    for (std::uint64_t seed = 1; seed <= scaled(5); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const auto setup = crowd(seed, 3, 4.0, 5);
        const ob::SpaceInformationPtr &si = setup->getSpaceInformation();
        unsigned int asked = 0, ruled = 0;
        setup->setStateValidityChecker(
            [&, checker = setup->getTeamChecker()](const ob::State *state)
            {
                ++asked;
                return keepsOut(state) && checker->isValid(state);
            });
        si->setup();
        auto &validator = dynamic_cast<CertificateMotionValidator &>(*si->getMotionValidator());
        validator.setRule([&](const ob::State *state) { return ++ruled > 0 && keepsOut(state); });
        const ob::DiscreteMotionValidator reference(si);
        Random random(seed);
        ob::ScopedState<> last(si), expected(si);
        unsigned int refused = 0;
        for (int i = 0; i < 300; ++i)
        {
            const ob::ScopedState<> from = randomState(random, si->getStateSpace());
            const ob::ScopedState<> to = randomStateNear(random, from, random.uniform(0.0, 0.5));
            if (!si->isValid(from.get()))
                continue;
            std::pair<ob::State *, double> found(last.get(), -1.0), wanted(expected.get(), -1.0);
            const bool valid = reference.checkMotion(from.get(), to.get(), wanted);
            refused += valid ? 0 : 1;
            const unsigned int before = asked;
            ASSERT_EQ(validator.checkMotion(from.get(), to.get()), valid) << "motion " << i;
            ASSERT_EQ(validator.checkMotion(from.get(), to.get(), found), valid);
            EXPECT_EQ(asked, before);
            ASSERT_DOUBLE_EQ(found.second, wanted.second) << "motion " << i;
        }
        EXPECT_GT(refused, 3U);
        EXPECT_GT(ruled, 100U);
        validator.setRule({});
        EXPECT_EQ(validator.getFurtherChecker(), si->getStateValidityChecker().get());
    }
}

TEST(FurtherCheckers, ThatPermitMoreAreWarnedOf)
{
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::disc("disc", 0.2, cubeBounds(2, 4.0)));
    ob::ScopedState<> from(team), to(team);
    from = std::vector<double>{-2.0, 0.0};
    to = std::vector<double>{2.0, 0.0};
    for (const bool permits : {false, true})
    {
        TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(0.5, 2.0)}}, 2));
        const ob::SpaceInformationPtr &si = setup.getSpaceInformation();
        setup.setStateValidityChecker([permits, checker = setup.getTeamChecker()](const ob::State *state)
                                      { return permits || checker->isValid(state); });
        si->setup();
        const Warnings warnings("permits states that the TeamValidityChecker does not");
        std::pair<ob::State *, double> last(nullptr, 0.0);
        for (int i = 0; i < 5; ++i)
            EXPECT_FALSE(si->getMotionValidator()->checkMotion(from.get(), to.get(), last));
        EXPECT_EQ(warnings.count, permits ? 1U : 0U);
        for (int i = 0; i < 5; ++i)
            EXPECT_FALSE(si->checkMotion(from.get(), to.get()));
        EXPECT_EQ(warnings.count, permits ? 1U : 0U);
    }
}

TEST_P(FurtherChecker, IsHeededInPlansAndSimplerPaths)
{
    ompl::RNG::setSeed(4);
    const auto setup = makeSetup(4, CertificateMotionValidator::DISCRETE, 0);
    ob::ScopedState<> start(setup->getStateSpace()), goal(setup->getStateSpace());
    ASSERT_NO_FATAL_FAILURE(planAroundTheZone(*setup, start, goal));
    og::PathGeometric path = setup->getSolutionPath();
    EXPECT_TRUE(path.check());
    for (unsigned int i = 1; i < path.getStateCount(); ++i)
        EXPECT_TRUE(ob::DiscreteMotionValidator(setup->getSpaceInformation())
                        .checkMotion(path.getState(i - 1), path.getState(i)));

    setup->setPlanner(std::make_shared<DRRTstar>(setup->getSpaceInformation()));
    EXPECT_NE(messageOf([&] { setup->solve(0.1); }).find(GetParam() ? "of your own" : "needs a TeamValidityChecker"),
              std::string::npos);
}

TEST_P(FurtherChecker, PlansWithOmplsValidator)
{
    ompl::RNG::setSeed(4);
    const auto setup = makeSetup(4, CertificateMotionValidator::DISCRETE, 0);
    const ob::SpaceInformationPtr &si = setup->getSpaceInformation();
    si->setMotionValidator(std::make_shared<ob::DiscreteMotionValidator>(si));
    ob::ScopedState<> start(setup->getStateSpace()), goal(setup->getStateSpace());
    ASSERT_NO_FATAL_FAILURE(planAroundTheZone(*setup, start, goal));
    og::PathGeometric path = setup->getSolutionPath();
    EXPECT_TRUE(path.check());
    for (unsigned int i = 0; i < path.getStateCount(); ++i)
        EXPECT_TRUE(keepsOut(path.getState(i)));
    // Two go straight, and the first one goes around the zone.
    EXPECT_LT(path.length(), 1.1 * TeamPathLength(si).motionCost(start.get(), goal.get()).value());
}

INSTANTIATE_TEST_SUITE_P(Kinds, FurtherChecker, testing::Bool());
