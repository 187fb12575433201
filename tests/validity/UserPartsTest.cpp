#include "support/Checkers.h"
#include "support/ErrorsOnly.h"

#include <gtest/gtest.h>
#include <ompl/util/Console.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** Obstacles that know only a lower bound of the clearance, as a user may bring */
    class BoundedObstacles : public Obstacles
    {
    public:
        BoundedObstacles(std::shared_ptr<FclObstacles> exact, double factor) : exact_(std::move(exact)), factor_(factor)
        {
        }

        unsigned int getDimension() const override
        {
            return exact_->getDimension();
        }

        bool collides(const Body &body, const Pose &pose) const override
        {
            return exact_->collides(body, pose);
        }

        bool knowsPadding() const override
        {
            return true;
        }

        double clearance(const Eigen::Vector3d &point) const override
        {
            const double clearance = exact_->clearance(point);
            return clearance > 0.0 ? factor_ * clearance : clearance;
        }

        double getTolerance() const override
        {
            return exact_->getTolerance();
        }

        bool provesCollisions() const override
        {
            return false;
        }

    private:
        std::shared_ptr<FclObstacles> exact_;
        double factor_;
    };

    /** Obstacles whose clearances, but not collisions, include a margin: negative although nothing is touched */
    class ShyObstacles : public BoundedObstacles
    {
    public:
        ShyObstacles(std::shared_ptr<FclObstacles> exact, double shyness)
          : BoundedObstacles(std::move(exact), 1.0), shyness_(shyness)
        {
        }

        double clearance(const Eigen::Vector3d &point) const override
        {
            return BoundedObstacles::clearance(point) - shyness_;
        }

    private:
        double shyness_;
    };

    /** An arm of two links about a fixed joint, as a user may bring */
    class Arm : public Robot
    {
    public:
        explicit Arm(const std::string &name, double x, double y)
          : Robot(name, makeSpace(), {Body::planarCapsule(0.1, 1.0), Body::box(1.0, 0.1)}), x_(x), y_(y)
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            const auto *q = state->as<ob::CompoundState>();
            const double first = q->as<ob::SO2StateSpace::StateType>(0)->value;
            const double second = q->as<ob::SO2StateSpace::StateType>(1)->value;
            const Pose shoulder = planarPose(x_, y_, first), elbow = shoulder * planarPose(1.2, 0.0, second);
            poses[0] = shoulder * planarPose(0.6, 0.0);
            poses[1] = elbow * planarPose(0.6, 0.0);
        }

        void computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const override
        {
            const auto *a = from->as<ob::CompoundState>(), *b = to->as<ob::CompoundState>();
            const auto *space = getStateSpace()->as<ob::CompoundStateSpace>();
            const double first = space->getSubspace(0)->distance(a->components[0], b->components[0]);
            const double second = space->getSubspace(1)->distance(a->components[1], b->components[1]);
            bounds[0] = {0.6 * first, first};
            bounds[1] = {1.2 * first + 0.6 * (first + second), first + second};
        }

    private:
        static ob::StateSpacePtr makeSpace()
        {
            auto space = std::make_shared<ob::CompoundStateSpace>();
            space->addSubspace(std::make_shared<ob::SO2StateSpace>(), 1.0);
            space->addSubspace(std::make_shared<ob::SO2StateSpace>(), 1.0);
            return space;
        }

        double x_, y_;
    };

    TeamStateSpacePtr teamWithArms()
    {
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(std::make_shared<Arm>("left", -1.5, 0.0));
        team->addRobot(std::make_shared<Arm>("right", 1.5, 0.5));
        team->addRobot(RigidRobot::inSE2("box", Body::box(0.5, 0.3), cubeBounds(2, 3.0)));
        return team;
    }

    struct OwnCounts
    {
        unsigned int states{0}, valid{0}, validMotions{0};

        /** Expects both verdicts to have occurred. */
        void expectVariety() const
        {
            EXPECT_GT(valid, states / 20);
            EXPECT_LT(valid, states);
            EXPECT_GT(validMotions, states / 100);
        }
    };

    void expectEqualVerdicts(Random &random, const Checkers &checkers, OwnCounts &counts)
    {
        auto from = randomState(random, checkers.team);
        for (unsigned int i = 0; i < 100; ++i)
        {
            const auto to = random.chance(0.5) ? randomState(random, checkers.team)
                                               : randomStateNear(random, from, random.logUniform(1e-3, 0.3));
            ob::ScopedState<> expectedState(checkers.team), state(checkers.team);
            std::pair<ob::State *, double> expected{expectedState.get(), 1.0};
            const bool isValid = checkers.isValid(to.get());
            const bool motion = checkers.reference().getSpaceInformation()->checkMotion(from.get(), to.get(), expected);
            ++counts.states;
            counts.valid += isValid ? 1 : 0;
            counts.validMotions += motion ? 1 : 0;
            for (const auto &setup : checkers.compared())
            {
                SCOPED_TRACE(nameOf(setup->getTeamChecker()->getMethod()));
                std::pair<ob::State *, double> last{state.get(), 1.0};
                ASSERT_EQ(setup->getTeamChecker()->isValid(to.get()), isValid);
                ASSERT_EQ(setup->getSpaceInformation()->checkMotion(from.get(), to.get()), motion);
                ASSERT_EQ(setup->getSpaceInformation()->checkMotion(from.get(), to.get(), last), motion);
                ASSERT_EQ(last.second, expected.second);
            }
            if (isValid)
                from = to;
        }
    }
}

class UserParts : public ErrorsOnly<unsigned int>
{
};

TEST_P(UserParts, ObstaclesWithALowerBoundOnlyGiveEqualVerdicts)
{
    OwnCounts counts;
    for (unsigned int seed = 0; seed < scaled(10); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto team = anyTeam(GetParam());
        const auto exact = anyObstacles(random, GetParam(), 10);
        const Checkers half(team, std::make_shared<BoundedObstacles>(exact, 0.5));
        ASSERT_NO_FATAL_FAILURE(expectEqualVerdicts(random, half, counts));
        const Checkers shy(team, std::make_shared<ShyObstacles>(exact, 0.5));
        ASSERT_NO_FATAL_FAILURE(expectEqualVerdicts(random, shy, counts));
    }
    counts.expectVariety();
}

INSTANTIATE_TEST_SUITE_P(Kind, UserParts, testing::Range(0U, TEAMS));

TEST(UserRobot, GivesEqualVerdicts)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    OwnCounts counts;
    for (unsigned int seed = 0; seed < scaled(10); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto team = teamWithArms();
        const Checkers checkers(team, scatteredObstacles(random, 2, 5));
        ASSERT_NO_FATAL_FAILURE(expectEqualVerdicts(random, checkers, counts));
    }
    counts.expectVariety();
}

TEST(UserRobot, PassesTheSanityChecksInItsTeam)
{
    const auto team = teamWithArms();
    team->setup();
    EXPECT_NO_THROW(team->sanityChecks());
}
