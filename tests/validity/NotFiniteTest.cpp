#include "support/Checkers.h"
#include "support/ErrorsOnly.h"
#include "support/RandomTrees.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/base/DiscreteMotionValidator.h>
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
                    EXPECT_LE(setup->getTeamChecker()->clearance(to.get()), 0.0);
                    EXPECT_NE(setup->getTeamChecker()->describeCollision(to.get()).find("not finite"),
                              std::string::npos);
                    EXPECT_FALSE(setup->getSpaceInformation()->checkMotion(state.get(), to.get()));
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kind, NotFinite, testing::Range(0U, TEAMS));

/** One robot moves to a position that is not finite, the others to true ones. No angle is tried: OMPL aborts where it
    measures the distance to an angle that is not a number. */
TEST(NotFinite, MotionsHaveNoSampleThatIsValid)
{
    const auto team = teamOfDiscs();
    for (const unsigned int obstacles : {0U, 5U})
    {
        Random random(obstacles);
        const Checkers checkers(team, anyObstacles(random, 0, obstacles));
        const ob::DiscreteMotionValidator ompl(checkers.reference().getSpaceInformation());
        for (unsigned int i = 0; i < scaled(200); ++i)
        {
            const auto from = randomState(random, team);
            auto to = randomState(random, team);
            if (!checkers.isValid(from.get()))
                continue;
            to[random.below(6)] =
                random.chance(0.5) ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
            std::pair<ob::State *, double> expected{nullptr, -7.0};
            EXPECT_FALSE(ompl.checkMotion(from.get(), to.get(), expected));
            EXPECT_EQ(expected.second, 0.0);
            for (const auto &setup : checkers.setups)
            {
                SCOPED_TRACE(nameOf(setup->getTeamChecker()->getMethod()));
                // So that certificates know how long the start stays free
                setup->getTeamChecker()->setAdaptive(false);
                EXPECT_TRUE(setup->getTeamChecker()->isValid(from.get()));
                std::pair<ob::State *, double> lastValid{nullptr, -7.0};
                EXPECT_FALSE(setup->getSpaceInformation()->checkMotion(from.get(), to.get(), lastValid));
                EXPECT_EQ(lastValid.second, 0.0);
            }
        }
    }
}

namespace
{
    /** A bar, from \e low to \e high */
    Body barOf(unsigned int kind, const Eigen::Vector3d &low, const Eigen::Vector3d &high)
    {
        const Eigen::Vector3d center = 0.5 * (low + high), size = high - low;
        switch (kind)
        {
            case 0:
                return Body::mesh(boxMesh(size, center));
            case 1:
                return Body({{Shape::box(size), poseAt(center)}});
            case 2:
                return Body::convexPolytope(boxMesh(size, center)->getVertices());
            default:
            {
                Pose pose = poseAt(center);
                pose.rotate(Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitY()));
                return Body({{Shape::cylinder(0.5 * size.y(), size.x()), pose}});
            }
        }
    }

    /** A bar that slides, and another that turns on it */
    TeamStateSpacePtr slidingArm(unsigned int kind)
    {
        using JointType = KinematicTree::JointType;
        KinematicTree tree("base");
        tree.addLink("base", joint("slide", JointType::PRISMATIC, {0.0, 0.0, 0.0}, {1.0, 0.3, 0.0}), "one",
                     barOf(kind, {-0.5, -0.05, -0.05}, {0.5, 0.05, 0.05}));
        tree.addLink("one", joint("turn", JointType::REVOLUTE, {0.3, 0.5, 0.0}, {0.0, 0.0, 1.0}, -3.0, 3.0), "two",
                     barOf(kind, {0.0, -0.05, -0.05}, {1.0, 0.05, 0.05}));
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(std::make_shared<Arm>("arm", tree, std::vector<std::string>{"slide", "turn"}, allPairs(tree)));
        return team;
    }
}

class NotFiniteArms : public ErrorsOnly<unsigned int>
{
};

/** What checkers remember of an arm alone, all checkers of it share. */
TEST_P(NotFiniteArms, AreNotRemembered)
{
    constexpr int TURNS = 500;
    const auto turnOf = [](int i) { return -3.0 + 6.0 * (i + 0.5) / TURNS; };
    for (const double broken :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e17, 1e45, -1e300})
    {
        SCOPED_TRACE(broken);
        const auto team = slidingArm(GetParam());
        const auto obstacles = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 3);
        const Checkers checkers(team, obstacles);
        ob::ScopedState<> state(team);
        for (int i = 0; i < TURNS; ++i)
            for (const auto &setup : checkers.setups)
            {
                SCOPED_TRACE(nameOf(setup->getTeamChecker()->getMethod()));
                state = std::vector<double>{broken, turnOf(i)};
                // Often, since what is remembered is proved in two steps, from large cells to small ones.
                for (int time = 0; time < 4; ++time)
                {
                    const bool valid = setup->getTeamChecker()->isValid(state.get());
                    const bool free = setup->getSpaceInformation()->checkMotion(state.get(), state.get());
                    ASSERT_TRUE(std::isfinite(broken) || (!valid && !free));
                }
            }
        const Checkers others(team, obstacles);
        unsigned int valid = 0;
        for (int i = 0; i < TURNS; ++i)
        {
            state = std::vector<double>{0.0, turnOf(i)};
            const bool expected = checkers.isValid(state.get());
            valid += expected ? 1 : 0;
            for (const Checkers *all : {&checkers, &others})
                for (const auto &setup : all->setups)
                    ASSERT_EQ(setup->getTeamChecker()->isValid(state.get()), expected)
                        << nameOf(setup->getTeamChecker()->getMethod()) << ", turned by " << turnOf(i);
        }
        EXPECT_GT(valid, TURNS / 4U);
        EXPECT_LT(valid, TURNS - TURNS / 20U);
    }
}

INSTANTIATE_TEST_SUITE_P(Kind, NotFiniteArms, testing::Range(0U, 4U));
