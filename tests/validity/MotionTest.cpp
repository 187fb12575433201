#include "support/Checkers.h"
#include "support/ErrorsOnly.h"

#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** A team, its checkers, and OMPL's own validator over the standard checker */
    struct Scene
    {
        Scene(unsigned int seed, unsigned int kind, double unit)
          : random(seed)
          , team(anyTeam(kind, unit))
          , checkers(team, anyObstacles(random, kind, 3 + random.below(15), unit), random.logUniform(0.001, 0.05))
          , ompl(checkers.reference().getSpaceInformation())
        {
        }

        ob::ScopedState<> validState()
        {
            for (int i = 0; i < 1000; ++i)
                if (auto state = randomState(random, team); checkers.isValid(state.get()))
                    return state;
            return randomState(random, team);
        }

        Random random;
        TeamStateSpacePtr team;
        Checkers checkers;
        ob::DiscreteMotionValidator ompl;
    };

    void expectEqualMotions(Scene &scene, const ob::ScopedState<> &from, const ob::ScopedState<> &to)
    {
        ob::ScopedState<> expectedState(scene.team), state(scene.team);
        std::pair<ob::State *, double> expected{expectedState.get(), -7.0};
        const bool valid = scene.ompl.checkMotion(from.get(), to.get(), expected);
        ASSERT_EQ(scene.ompl.checkMotion(from.get(), to.get()), valid);
        for (const auto &setup : scene.checkers.setups)
        {
            const auto &validator = setup->getSpaceInformation()->getMotionValidator();
            SCOPED_TRACE(nameOf(setup->getTeamChecker()->getMethod()));
            const unsigned int validCount = validator->getValidMotionCount();
            const unsigned int invalidCount = validator->getInvalidMotionCount();
            // Not the state as allocated: it may hold NaN, which equals nothing.
            scene.team->copyState(state.get(), from.get());
            const auto before = realsOf(*scene.team, state.get());
            std::pair<ob::State *, double> lastValid{state.get(), -7.0}, timeOnly{nullptr, -7.0};
            // In both orders, so that either overload may be the one without any knowledge.
            const bool first = scene.random.chance(0.5);
            if (first)
            {
                ASSERT_EQ(validator->checkMotion(from.get(), to.get()), valid);
            }
            ASSERT_EQ(validator->checkMotion(from.get(), to.get(), lastValid), valid);
            if (!first)
            {
                ASSERT_EQ(validator->checkMotion(from.get(), to.get()), valid);
            }
            ASSERT_EQ(validator->checkMotion(from.get(), to.get(), timeOnly), valid);
            EXPECT_EQ(validator->getValidMotionCount() - validCount, valid ? 3U : 0U);
            EXPECT_EQ(validator->getInvalidMotionCount() - invalidCount, valid ? 0U : 3U);
            ASSERT_EQ(timeOnly.second, lastValid.second);
            ASSERT_EQ(lastValid.first, state.get());
            if (valid)
            {
                ASSERT_EQ(lastValid.second, -7.0) << "not to be touched";
                ASSERT_EQ(realsOf(*scene.team, state.get()), before) << "not to be touched";
            }
            else
            {
                ASSERT_EQ(lastValid.second, expected.second);
                ASSERT_EQ(realsOf(*scene.team, state.get()), realsOf(*scene.team, expectedState.get()));
            }
        }
    }
}

class Motions : public ErrorsOnly<unsigned int>
{
};

TEST_P(Motions, AreJudgedAsOmplsOwnValidatorDoes)
{
    unsigned int valid = 0, invalid = 0;
    const unsigned int seeds = scaled(GetParam() < FIRST_OF_MESHES ? 300 : 60);
    for (unsigned int seed = 0; seed < seeds; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Scene scene(seed, GetParam(), seed % 3 == 0 ? 1.0 : seed % 3 == 1 ? 1e-3 : 1e4);
        for (int i = 0; i < 40; ++i)
        {
            // Mostly from a valid state, as OMPL requires, and from there anywhere: far, near, and very near
            const auto from = scene.random.chance(0.9) ? scene.validState() : randomState(scene.random, scene.team);
            if (scene.random.chance(0.5))
                scene.checkers.certified()[scene.random.below(3)]->getTeamChecker()->isValid(from.get());
            const double fraction = scene.random.chance(0.2) ? 1.0 : scene.random.logUniform(1e-7, 1.0);
            auto to = randomStateNear(scene.random, from, fraction);
            if (scene.random.chance(0.5))
                scene.team->clearReferences(to.get());
            ASSERT_NO_FATAL_FAILURE(expectEqualMotions(scene, from, to));
            ASSERT_NO_FATAL_FAILURE(expectEqualMotions(scene, from, to)) << "again";
            ++(scene.ompl.checkMotion(from.get(), to.get()) ? valid : invalid);
        }
    }
    EXPECT_GT(valid, seeds * 4);
    EXPECT_GT(invalid, seeds * 4);
}

TEST_P(Motions, FromAStateToItselfAreAsValidAsTheState)
{
    for (unsigned int seed = 0; seed < scaled(20); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Scene scene(seed, GetParam(), 1.0);
        for (int i = 0; i < 20; ++i)
        {
            const auto state = randomState(scene.random, scene.team);
            const bool valid = scene.checkers.isValid(state.get());
            for (const auto &setup : scene.checkers.certified())
            {
                const auto &validator = setup->getSpaceInformation()->getMotionValidator();
                ob::ScopedState<> last(scene.team);
                std::pair<ob::State *, double> lastValid{last.get(), -7.0};
                ASSERT_EQ(validator->checkMotion(state.get(), state.get()), valid);
                ASSERT_EQ(validator->checkMotion(state.get(), state.get(), lastValid), valid);
                ASSERT_EQ(lastValid.second, valid ? -7.0 : 0.0);
                if (!valid)
                {
                    ASSERT_EQ(realsOf(*scene.team, last.get()), realsOf(*scene.team, state.get()));
                }
            }
        }
    }
}

/** With the address sanitizer, this fails if the validator uses what it does not own. */
TEST_P(Motions, LeaveAValidatorThatOutlivesItsSetup)
{
    ob::MotionValidatorPtr validator;
    Random random(1);
    {
        const TeamStateSpacePtr team = anyTeam(GetParam());
        TeamSetup setup(team, scatteredObstacles(random, team->getWorkspaceDimension(), 5));
        setup.getSpaceInformation()->setup();
        validator = setup.getSpaceInformation()->getMotionValidator();
        const ob::ScopedState<> from = randomState(random, team), to = randomState(random, team);
        validator->checkMotion(from.get(), to.get());
    }
    EXPECT_EQ(validator.use_count(), 1);
    validator.reset();
}

INSTANTIATE_TEST_SUITE_P(Kind, Motions, testing::Range(0U, TEAMS));
