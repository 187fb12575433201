#include "support/Checkers.h"
#include "support/ErrorsOnly.h"
#include "support/Message.h"

#include "ompl_certificates/obstacles/CellObstacles.h"
#include "ompl_certificates/robots/Arm.h"

#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    Body ballOrBox(Random &random)
    {
        const double size = random.uniform(0.1, 0.3);
        return random.chance(0.7) ? Body::sphere(0.5 * size) : Body::box(size, size, random.uniform(0.1, 0.3));
    }

    TeamStateSpacePtr teamOfArms(Random &random, unsigned int arms)
    {
        auto team = std::make_shared<TeamStateSpace>();
        for (unsigned int i = 0; i < arms; ++i)
        {
            const std::string name = std::string(1, static_cast<char>('a' + i));
            KinematicTree tree(name + "0", ballOrBox(random));
            std::vector<std::string> joints;
            ArmOptions options;
            options.base = random.pose(3, 0.5);
            constexpr unsigned int links = 6;
            for (unsigned int k = 1; k <= links; ++k)
            {
                joints.push_back("joint" + std::to_string(k));
                KinematicTree::Joint joint;
                joint.name = joints.back();
                joint.type =
                    random.chance(0.8) ? KinematicTree::JointType::REVOLUTE : KinematicTree::JointType::PRISMATIC;
                joint.origin = poseAt(0.3 * random.direction(3));
                joint.axis = random.direction(3);
                joint.lower = -1.5;
                joint.upper = 1.5;
                tree.addLink(name + std::to_string(k - 1), joint, name + std::to_string(k), ballOrBox(random));
                for (unsigned int other = 0; other + 1 < k; ++other)
                    options.linkPairs.emplace_back(name + std::to_string(other), name + std::to_string(k));
            }
            team->addRobot(std::make_shared<Arm>(name, tree, joints, options));
        }
        team->lock();
        return team;
    }

    ObstaclesPtr obstaclesAmongArms(Random &random)
    {
        std::vector<PlacedBody> bodies;
        for (std::size_t count = random.below(30); count > 0; --count)
            bodies.push_back({ballOrBox(random), random.pose(3, 1.0)});
        return std::make_shared<FclObstacles>(bodies, 3);
    }

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

        /** Arms near each other, of balls and boxes: these touch as soon as their bounding volumes do */
        Scene(unsigned int seed, unsigned int arms)
          : random(seed)
          , team(teamOfArms(random, arms))
          , checkers(team, obstaclesAmongArms(random), random.logUniform(0.001, 0.05))
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

class MotionsOfArms : public ErrorsOnly<unsigned int>
{
};

TEST_P(MotionsOfArms, AreJudgedAsOmplsOwnValidatorDoes)
{
    unsigned int valid = 0, invalid = 0;
    const unsigned int seeds = scaled(100);
    for (unsigned int seed = 0; seed < seeds; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Scene scene(seed, GetParam());
        for (int i = 0; i < 20; ++i)
        {
            const auto from = scene.validState();
            const auto to = randomStateNear(scene.random, from, scene.random.logUniform(1e-3, 0.3));
            ASSERT_NO_FATAL_FAILURE(expectEqualMotions(scene, from, to));
            ++(scene.ompl.checkMotion(from.get(), to.get()) ? valid : invalid);
        }
    }
    EXPECT_GT(valid, seeds * 2);
    EXPECT_GT(invalid, seeds * 2);
}

INSTANTIATE_TEST_SUITE_P(Arms, MotionsOfArms, testing::Values(1U, 2U));

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

/** Without a resolution a motion has no samples. */
TEST_P(Motions, NeedASpaceThatWasSetUp)
{
    Random random(1);
    const TeamStateSpacePtr team = anyTeam(GetParam());
    const ObstaclesPtr obstacles = scatteredObstacles(random, team->getWorkspaceDimension(), 5);
    for (const Method method : allMethods())
    {
        SCOPED_TRACE(nameOf(method));
        const auto si = std::make_shared<ob::SpaceInformation>(team);
        const auto checker = std::make_shared<TeamValidityChecker>(si, obstacles, method);
        const CertificateMotionValidator validator(checker);
        ob::ScopedState<> from = randomState(random, team), to = randomState(random, team);
        while (!checker->isValid(from.get()))
            from = randomState(random, team);
        while (!checker->isValid(to.get()))
            to = randomState(random, team);
        std::pair<ob::State *, double> last{nullptr, 0.0};
        const std::function<void()> asked[] = {[&] { validator.checkMotion(from.get(), to.get()); },
                                               [&] { validator.checkMotion(from.get(), to.get(), last); },
                                               [&]
                                               {
                                                   checker->isRobotMotionFree(
                                                       0, from->as<ob::CompoundState>()->components[0],
                                                       to->as<ob::CompoundState>()->components[0]);
                                               }};
        for (const auto &ask : asked)
            EXPECT_NE(messageOf(ask).find("was not set up"), std::string::npos);
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

/** Obstacles tell the gap of a mesh. Its center stands, so that only the way of its tips says how long that lasts. */
TEST(MotionsOfABar, EndWhereItsTipMeetsAnObstacleAsItTurns)
{
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::inSE3("bar", Body::mesh(boxMesh({2.0, 0.1, 0.1})), cubeBounds(3, HALF)));
    const std::vector<PlacedBody> box{{Body::box(0.1, 0.1, 0.1), poseAt({0.85, 0.35, 0.0})}};
    const std::vector<CellBox> cell{{{8, 3, 0}, {9, 4, 1}}};
    for (const ObstaclesPtr &obstacles : {ObstaclesPtr(std::make_shared<FclObstacles>(box, 3)),
                                          ObstaclesPtr(std::make_shared<CellObstacles>(0.1, cell))})
    {
        const Checkers checkers(team, obstacles, 0.002);
        for (const auto &setup : checkers.setups)
        {
            SCOPED_TRACE(nameOf(setup->getTeamChecker()->getMethod()));
            setup->getTeamChecker()->setAdaptive(false);
            ob::ScopedState<> from(team), to(team);
            from = std::vector<double>{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
            to = std::vector<double>{0.0, 0.0, 0.0, 0.0, 0.0, std::sqrt(0.5), std::sqrt(0.5)};
            EXPECT_TRUE(setup->getTeamChecker()->isValid(from.get()));
            EXPECT_TRUE(setup->getTeamChecker()->isValid(to.get()));
            EXPECT_FALSE(setup->getSpaceInformation()->checkMotion(from.get(), to.get()));
        }
    }
}
