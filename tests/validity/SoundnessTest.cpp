#include "support/Checkers.h"
#include "support/ErrorsOnly.h"
#include "support/ExpensiveObstacles.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** The position among the coordinates of one robot's state */
    double *positionOf(const ob::StateSpacePtr &space, ob::State *state)
    {
        if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(space.get()))
            return positionOf(compound->getSubspace(0), state->as<ob::CompoundState>()->components[0]);
        return state->as<ob::RealVectorStateSpace::StateType>()->values;
    }

    /** A body that is a mesh with probability \e meshes */
    Body anyBody(Random &random, unsigned int dimension, double size, double meshes)
    {
        return random.chance(meshes) ? randomMeshBody(random, dimension, size) : randomBody(random, dimension, size);
    }

    TeamStateSpacePtr randomTeam(Random &random, unsigned int dimension, double meshes, double unit, double origin)
    {
        ob::RealVectorBounds bounds(dimension);
        bounds.setLow(origin - 3.0 * unit);
        bounds.setHigh(origin + 3.0 * unit);
        auto team = std::make_shared<TeamStateSpace>();
        for (unsigned int i = 0, count = 1 + random.below(3); i < count; ++i)
        {
            const std::string name = "robot" + std::to_string(i);
            Body body = anyBody(random, dimension, unit * random.logUniform(0.02, 1.0), meshes);
            if (random.chance(0.25))
                body = body.padded(unit * random.logUniform(1e-3, 0.3));
            const bool turns = random.chance(0.7);
            if (dimension == 3)
                team->addRobot(turns ? RigidRobot::inSE3(name, body, bounds) : RigidRobot::inR3(name, body, bounds));
            else if (random.chance(0.25))
                team->addRobot(std::make_shared<CarWithTrailer>(name, body, anyBody(random, 2, 0.5 * unit, meshes),
                                                                random.uniform(0.0, unit), bounds));
            else
                team->addRobot(turns ? RigidRobot::inSE2(name, body, bounds) : RigidRobot::inR2(name, body, bounds));
        }
        return team;
    }

    std::shared_ptr<FclObstacles> randomObstacles(Random &random, const TeamStateSpace &team, double meshes,
                                                  double unit, double origin)
    {
        const unsigned int dimension = team.getWorkspaceDimension();
        std::vector<PlacedBody> bodies;
        for (unsigned int count = 1 + random.below(6); count > 0; --count)
        {
            const Body body = anyBody(random, dimension, unit * random.logUniform(0.3, 3.0), meshes);
            Pose pose = random.pose(dimension, 3.0 * unit);
            pose.translation().head(dimension).array() += origin;
            bodies.push_back({body, pose});
        }
        if (random.chance(0.5))
            return std::make_shared<ExpensiveObstacles>(bodies, dimension, team.getZInterval());
        return std::make_shared<FclObstacles>(bodies, dimension, team.getZInterval());
    }

    /** Moves one robot of a state along a line, to where its verdict changes. */
    class Grazing
    {
    public:
        Grazing(Random &random, const Checkers &checkers, ob::ScopedState<> &state, double unit)
          : checkers_(checkers), state_(state), dimension_(checkers.team->getWorkspaceDimension())
        {
            const unsigned int robot = random.below(checkers.team->getRobotCount());
            position_ =
                positionOf(checkers.team->getSubspace(robot), state->as<ob::CompoundState>()->components[robot]);
            start_ = Eigen::Map<Eigen::VectorXd>(position_, dimension_);
            // Mostly towards something that can be hit
            const auto &obstacles =
                static_cast<const FclObstacles &>(checkers.reference().getTeamChecker()->getObstacles());
            const Eigen::Vector3d target =
                obstacles.getBodies()[random.below(obstacles.getBodies().size())].pose.translation();
            along_ = random.direction(checkers.team->getWorkspaceDimension()).head(dimension_);
            if (random.chance(0.8))
                along_ = (target.head(dimension_) - start_ + 0.2 * unit * along_).normalized();
            const double step = 0.1 * unit;
            const bool first = at(0.0);
            for (double t = step; t < 6.0 * unit && !found_; t += step)
                if (at(t) != first)
                {
                    found_ = true;
                    low_ = t - step;
                    high_ = t;
                }
            for (int i = 0; found_ && i < 50; ++i)
            {
                const double middle = 0.5 * (low_ + high_);
                (at(middle) == first ? low_ : high_) = middle;
            }
        }

        bool found() const
        {
            return found_;
        }

        /** Put the robot at this distance from where the verdict changes. */
        void moveTo(double gap)
        {
            Eigen::Map<Eigen::VectorXd>(position_, dimension_) = start_ + (high_ + gap) * along_;
        }

    private:
        bool at(double t)
        {
            Eigen::Map<Eigen::VectorXd>(position_, dimension_) = start_ + t * along_;
            return checkers_.isValid(state_.get());
        }

        const Checkers &checkers_;
        ob::ScopedState<> &state_;
        Eigen::Index dimension_;
        double *position_;
        Eigen::VectorXd start_, along_;
        double low_{0.0}, high_{0.0};
        bool found_{false};
    };

    struct Counts
    {
        unsigned int states{0}, valid{0}, invalid{0};
    };

    void expectEqualVerdicts(Random &random, const Checkers &checkers, const ob::ScopedState<> &state, Counts &counts)
    {
        const bool valid = checkers.isValid(state.get());
        ++counts.states;
        ++(valid ? counts.valid : counts.invalid);
        for (const auto &setup : checkers.compared())
        {
            // References must not matter: those of another method, of a near state, or random ones.
            if (random.chance(0.1))
                for (unsigned int i = 0; i < checkers.team->getBodyCount(); ++i)
                    state->as<TeamStateSpace::StateType>()->setReference(i, random.below(200));
            ASSERT_EQ(setup->getTeamChecker()->isValid(state.get()), valid)
                << nameOf(setup->getTeamChecker()->getMethod()) << " differs; "
                << checkers.reference().getTeamChecker()->describeCollision(state.get());
        }
    }
}

/** The dimension, and whether there are meshes */
class Soundness : public ErrorsOnly<std::tuple<unsigned int, bool>>
{
};

TEST_P(Soundness, VerdictsAreThoseOfTheStandardCheck)
{
    Counts counts;
    const unsigned int seeds = scaled(std::get<1>(GetParam()) ? 400 : 1000);
    for (unsigned int seed = 0; seed < seeds; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double unit = seed % 3 == 0 ? 1.0 : seed % 3 == 1 ? 1e-3 : 1e4;
        // Now and then far from the origin, as in surveyed maps
        const double origin = random.chance(0.1) ? 1e6 * unit : 0.0;
        // In a world of meshes, some robots and obstacles are primitives, or all robots or all obstacles.
        const auto chance = [&, some = std::get<1>(GetParam())] { return some ? random.below(3) / 2.0 : 0.0; };
        const auto team = randomTeam(random, std::get<0>(GetParam()), chance(), unit, origin);
        const Checkers checkers(team, randomObstacles(random, *team, chance(), unit, origin));
        auto state = randomState(random, team);
        for (int i = 0; i < 20; ++i)
        {
            state = random.chance(0.5) ? randomState(random, team) : randomStateNear(random, state, 0.05);
            ASSERT_NO_FATAL_FAILURE(expectEqualVerdicts(random, checkers, state, counts));
        }
        for (int i = 0; i < 8; ++i)
        {
            state = randomState(random, team);
            Grazing grazing(random, checkers, state, unit);
            for (int k = 0; k < 10 && grazing.found(); ++k)
            {
                grazing.moveTo(random.sign() * unit * random.logUniform(1e-9, 1e-2));
                ASSERT_NO_FATAL_FAILURE(expectEqualVerdicts(random, checkers, state, counts));
            }
        }
    }
    RecordProperty("states", static_cast<int>(counts.states));
    EXPECT_GT(counts.states, 50 * seeds);
    EXPECT_GT(counts.valid, counts.states / 8);
    EXPECT_GT(counts.invalid, counts.states / 8);
}

INSTANTIATE_TEST_SUITE_P(Kind, Soundness, testing::Combine(testing::Values(2U, 3U), testing::Bool()),
                         [](const auto &tested)
                         {
                             return std::string(std::get<0>(tested.param) == 2 ? "InThePlane" : "InSpace") +
                                    (std::get<1>(tested.param) ? "WithMeshes" : "");
                         });
