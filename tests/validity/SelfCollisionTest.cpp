// Robots that name pairs of their own bodies are free only if these are apart.

#include "validity/RobotPairs.h"

#include "ompl_certificates/robots/Arm.h"

#include "support/Chain.h"
#include "support/Checkers.h"
#include "support/ErrorsOnly.h"
#include "support/Fcl.h"
#include "support/TeamOf.h"

#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** Whether FCL finds two bodies of a pair that touch */
    bool touchesItself(const Robot &robot, const ob::State *state)
    {
        std::vector<Pose> poses(robot.getBodies().size());
        robot.computePoses(state, poses.data());
        const auto &bodies = robot.getBodies();
        const auto &pairs = robot.getBodyPairs();
        return std::any_of(
            pairs.begin(), pairs.end(),
            [&](const BodyPair &pair)
            { return touchForFcl(bodies[pair.first], poses[pair.first], bodies[pair.second], poses[pair.second]); });
    }

    /** How many states touch, and how many do not */
    struct Tally
    {
        unsigned int touching{0}, apart{0};
    };

    /** Expect of all methods that they call a state of one robot what FCL calls it. */
    void expectFclsVerdict(const Checkers &checkers, const Robot &robot, const ob::State *state, Tally &tally)
    {
        const bool touches = touchesItself(robot, state->as<ob::CompoundState>()->components[0]);
        ++(touches ? tally.touching : tally.apart);
        for (const auto &setup : checkers.setups)
            ASSERT_EQ(setup->getTeamChecker()->isValid(state), !touches)
                << nameOf(setup->getTeamChecker()->getMethod());
    }

    ObstaclesPtr noObstacles(unsigned int dimension)
    {
        return std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, dimension);
    }

    /** Three equal links; the last reaches back to the first. */
    RobotPtr threeLinks()
    {
        const Body link({{Shape::box(Eigen::Vector2d(1.0, 0.1)), planarPose(0.5, 0.0)}});
        const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
        return std::make_shared<Chain>("arm",
                                       std::vector<Chain::Link>{{link, planarPose(0.0, 0.0), z, 0.0},
                                                                {link, planarPose(1.0, 0.0), z, 0.0},
                                                                {link, planarPose(1.0, 0.0), z, 0.0}},
                                       pairsApart(3));
    }

    /** Three boxes in a row, the first on a rail. The third reaches back to it. */
    std::shared_ptr<const Chain> linksOnARail(std::uint64_t seed)
    {
        Random random(seed);
        const Body link({{Shape::box(Eigen::Vector3d(1.0, 0.2, 0.2)), poseAt({0.5, 0.0, 0.0})}});
        std::vector<Chain::Link> links{{link, Pose::Identity(), random.direction(3), 1.0}};
        for (int i = 0; i < 2; ++i)
            links.push_back({link, poseAt({1.0, 0.0, 0.0}), random.direction(3), 0.0});
        return std::make_shared<Chain>("arm", links, pairsApart(3));
    }

    /** A small box at the end of a bar that turns towards a wall, which it touches at \e angle. The wall is on a rail
        that begins \e far from the origin. */
    std::shared_ptr<const Chain> wallOnARail(double far, double angle, double half)
    {
        const Pose joint = poseAt({0.3, 0.4, 0.1});
        const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
        Pose wall = joint, rail = poseAt({far, far, far});
        wall.rotate(Eigen::AngleAxisd(angle + half, z));
        wall.translate(Eigen::Vector3d(1.0, 0.25, 0.0));
        const Shape large = Shape::box(Eigen::Vector3d(0.5, 0.5, 0.5)),
                    small = Shape::box(Eigen::Vector3d(2.0 * half, 2.0 * half, 2.0 * half));
        return std::make_shared<Chain>(
            "arm",
            std::vector<Chain::Link>{{Body({{large, wall}}), rail, z, 1.0},
                                     {Body({{small, poseAt({1.0, 0.0, 0.0})}}), joint, z, 0.0}},
            std::vector<BodyPair>{{0, 1}});
    }
}

class SelfCollision : public ErrorsOnly<unsigned int>
{
};

TEST_P(SelfCollision, IsWhatFclSaysOfTheBodyPairs)
{
    unsigned int touching = 0, apart = 0;
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const RobotPtr robot = randomChain(random, GetParam());
        const Checkers checkers(teamOf({robot}), noObstacles(GetParam()));
        for (int i = 0; i < 40; ++i)
        {
            const auto state = randomState(random, checkers.team);
            const ob::State *own = state->as<ob::CompoundState>()->components[0];
            const bool touches = touchesItself(*robot, own);
            ++(touches ? touching : apart);
            for (const auto &setup : checkers.setups)
            {
                const TeamValidityChecker &checker = *setup->getTeamChecker();
                SCOPED_TRACE(nameOf(checker.getMethod()));
                ASSERT_EQ(checker.isValid(state.get()), !touches);
                ASSERT_EQ(checker.isRobotFree(0, own), !touches);
                ASSERT_EQ(checker.describeCollision(state.get()).empty(), !touches);
                ASSERT_TRUE(!touches || !(checker.clearance(state.get()) > 0.0));
            }
        }
    }
    EXPECT_GT(touching, scaled(1000));
    EXPECT_GT(apart, scaled(1000));
}

TEST_P(SelfCollision, StopsMotionsWhereOmplsOwnValidatorDoes)
{
    unsigned int free = 0, blocked = 0;
    for (unsigned int seed = 0; seed < scaled(60); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const RobotPtr robot = randomChain(random, GetParam());
        const auto obstacles =
            random.chance(0.5) ? noObstacles(GetParam()) : ObstaclesPtr(scatteredObstacles(random, GetParam(), 2));
        const Checkers checkers(teamOf({robot}), obstacles);
        const ob::DiscreteMotionValidator ompls(checkers.reference().getSpaceInformation());
        auto from = randomState(random, checkers.team);
        for (int i = 0; i < 40; ++i)
        {
            const auto to = randomStateNear(random, from, random.logUniform(1e-3, 1.0));
            ob::ScopedState<> expectedState(checkers.team), state(checkers.team);
            std::pair<ob::State *, double> expected{expectedState.get(), 1.0}, last{state.get(), 1.0};
            const bool isFree = ompls.checkMotion(from.get(), to.get());
            ASSERT_EQ(ompls.checkMotion(from.get(), to.get(), expected), isFree);
            ++(isFree ? free : blocked);
            const bool isValid = checkers.isValid(from.get());
            for (const auto &setup : checkers.setups)
            {
                SCOPED_TRACE(nameOf(setup->getTeamChecker()->getMethod()));
                last.second = 1.0;
                ASSERT_EQ(setup->getSpaceInformation()->checkMotion(from.get(), to.get()), isFree);
                ASSERT_EQ(setup->getSpaceInformation()->checkMotion(from.get(), to.get(), last), isFree);
                ASSERT_EQ(last.second, expected.second);
                // The robot alone is the whole team.
                const auto component = [](const ob::ScopedState<> &whole)
                { return whole->as<ob::CompoundState>()->components[0]; };
                ASSERT_EQ(setup->getTeamChecker()->isRobotMotionFree(0, component(from), component(to)), isFree);
            }
            if (checkers.isValid(to.get()) || !isValid)
                from = to;
        }
    }
    EXPECT_GT(free, scaled(100));
    EXPECT_GT(blocked, scaled(100));
}

TEST_P(SelfCollision, IsExcludedForAsLongAsAValidIntervalSays)
{
    unsigned int intervals = 0;
    for (unsigned int seed = 0; seed < scaled(400); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const RobotPtr robot = randomChain(random, GetParam());
        const Team team(robot->getStateSpace(), {robot});
        const RobotPairs pairs(team, Method::SHARED_PROJECTION, nullptr);
        ASSERT_EQ(pairs.getPairCount(), 1U);
        CheckContext context(team, pairs.getBodyPairCount());
        ++context.motion;
        const auto &space = robot->getStateSpace();
        const auto from = randomState(random, space), to = randomStateNear(random, from, random.logUniform(0.01, 1.0));
        robot->computeMotionBounds(from.get(), to.get(), context.motionBounds.data());
        robot->computePairMotionBounds(from.get(), to.get(), context.motionBounds.data(),
                                       context.pairMotionBounds[0].data());
        ob::ScopedState<> at(space);
        context.from[0] = from.get();
        context.to[0] = to.get();
        context.placed[0] = at.get();
        const auto moveTo = [&](double time)
        {
            space->interpolate(from.get(), to.get(), time, at.get());
            robot->placeBodies(at.get(), context.poses.data());
        };
        const auto expectFree = [&](double first, double last)
        {
            intervals += first < last ? 1 : 0;
            for (int i = 0; first < last && i < 20; ++i)
            {
                moveTo(random.uniform(std::max(first, 0.0), std::min(last, 1.0)));
                ASSERT_FALSE(pairs.findCollision(0, context));
            }
        };
        moveTo(0.0);
        expectFree(0.0, pairs.provenInterval(0, context));
        // What is known of earlier times takes part in the later ones.
        for (int k = 0; k < 5; ++k)
        {
            const double time = random.uniform(0.0, 1.0);
            moveTo(time);
            const SubjectVerdict verdict = pairs.settle(0, context, {true, 0.0, k % 2 == 0 ? 0.0 : 10.0, time});
            ASSERT_EQ(verdict.free, !touchesItself(*robot, at.get()));
            if (verdict.free)
                expectFree(time - verdict.before, time + verdict.after);
        }
    }
    EXPECT_GT(intervals, scaled(200));
}

TEST_P(SelfCollision, NeverOccursInMotionsAcceptedByTheContinuousMode)
{
    unsigned int accepted = 0, refused = 0;
    for (unsigned int seed = 0; seed < scaled(60); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const RobotPtr robot = randomChain(random, GetParam());
        const auto team = teamOf({robot});
        const auto obstacles = noObstacles(GetParam());
        std::vector<TeamSetupPtr> setups;
        const double resolution = random.logUniform(0.01, 0.5);
        for (const Method method : {Method::BASIC, Method::PARTIAL, Method::SHARED_PROJECTION})
        {
            setups.push_back(
                std::make_shared<TeamSetup>(team, obstacles, method, CertificateMotionValidator::CONTINUOUS));
            setups.back()->getSpaceInformation()->setStateValidityCheckingResolution(resolution);
            setups.back()->getSpaceInformation()->setup();
        }
        const auto &si = *setups.front()->getSpaceInformation();
        for (int i = 0; i < 20; ++i)
        {
            const auto from = randomState(random, team),
                       to = randomStateNear(random, from, random.logUniform(0.01, 0.5));
            if (!si.isValid(from.get()))
                continue;
            const bool free = si.checkMotion(from.get(), to.get());
            ++(free ? accepted : refused);
            for (const auto &setup : setups)
            {
                ASSERT_EQ(setup->getSpaceInformation()->checkMotion(from.get(), to.get()), free);
                ASSERT_EQ(setup->getSpaceInformation()->checkMotion(to.get(), from.get()), free);
            }
            const unsigned int samples =
                free ? std::min(20000U, 1000 * std::max(1U, team->validSegmentCount(from.get(), to.get()))) : 0;
            ob::ScopedState<> at(team);
            for (unsigned int k = 0; k < samples; ++k)
            {
                team->interpolate(from.get(), to.get(), static_cast<double>(k) / samples, at.get());
                ASSERT_TRUE(si.isValid(at.get()));
            }
        }
    }
    EXPECT_GT(accepted, scaled(60));
    EXPECT_GT(refused, scaled(20));
}

TEST_P(SelfCollision, IsTheSameAnywhereInTheCellOfAStateThatWasChecked)
{
    Tally tally;
    for (unsigned int seed = 0; seed < scaled(100); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const RobotPtr robot = randomChain(random, GetParam());
        const auto team = teamOf({robot});
        const Checkers checkers(team, noObstacles(GetParam()));
        for (int i = 0; i < 10; ++i)
        {
            const auto middle = randomState(random, team);
            for (int k = 0; k < 12; ++k)
            {
                // Some so near that they are in one of the smallest cells, which are settled at the second question
                const auto state = randomStateNear(random, middle, random.logUniform(1e-4, 0.1));
                expectFclsVerdict(checkers, *robot, state.get(), tally);
                if (HasFatalFailure())
                    return;
            }
        }
    }
    EXPECT_GT(tally.touching, scaled(1000));
    EXPECT_GT(tally.apart, scaled(1000));
}

INSTANTIATE_TEST_SUITE_P(Dimension, SelfCollision, testing::Values(2U, 3U));

TEST(SelfCollisions, BeginWithinACellWhereFclSaysSo)
{
    // A small box at the end of a bar turns towards a wall. Its points move hardly less than their reach: a cell that
    // reaches too far is wrong at once.
    Tally tally;
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double angle = random.uniform(-2.0, 2.0), half = 0.01;
        Pose wall = Pose::Identity();
        wall.rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
        wall.translate(Eigen::Vector3d(1.0, 0.25, 0.0));
        KinematicTree tree("wall", Body({{Shape::box(Eigen::Vector3d(0.5, 0.5, 0.5)), wall}}));
        KinematicTree::Joint joint;
        joint.name = "joint";
        joint.type = KinematicTree::JointType::REVOLUTE;
        joint.lower = random.uniform(-3.0, -2.5);
        joint.upper = random.uniform(2.5, 3.0);
        tree.addLink(
            "wall", joint, "end",
            Body({{Shape::box(Eigen::Vector3d(2.0 * half, 2.0 * half, 2.0 * half)), poseAt({1.0, 0.0, 0.0})}}));
        ArmOptions options;
        options.linkPairs = {{"wall", "end"}};
        const auto arm = std::make_shared<const Arm>("arm", tree, std::vector<std::string>{"joint"}, options);
        ASSERT_TRUE(arm->getJointCells(0));
        const auto team = teamOf({arm});
        const Checkers checkers(team, noObstacles(3));
        for (int i = 0; i < 60; ++i)
        {
            ob::ScopedState<> state(team);
            state[0] = angle - half + random.uniform(-0.01, 0.01);
            expectFclsVerdict(checkers, *arm, state.get(), tally);
            if (HasFatalFailure())
                return;
        }
    }
    EXPECT_GT(tally.touching, scaled(3000));
    EXPECT_GT(tally.apart, scaled(3000));
}

TEST(SelfCollisions, IsSaidWithTheBodies)
{
    const auto team = teamOf({RigidRobot::disc("disc", 0.1, cubeBounds(2, 5.0)), threeLinks()});
    const Checkers checkers(team, noObstacles(2));
    ob::ScopedState<> state(team);
    state = std::vector<double>{4.0, 4.0, 0.0, 2.5, 2.5};
    for (const auto &setup : checkers.setups)
    {
        const TeamValidityChecker &checker = *setup->getTeamChecker();
        EXPECT_EQ(checker.describeCollision(state.get()), "robot 'arm' touches itself: body 0 and body 2");
        EXPECT_FALSE(checker.isRobotFree(1, state->as<ob::CompoundState>()->components[1]));
        EXPECT_TRUE(checker.isRobotFree(0, state->as<ob::CompoundState>()->components[0]));
    }
}

TEST(SelfCollisions, CountsForTheClearance)
{
    const auto team = teamOf({threeLinks()});
    const Checkers checkers(team, noObstacles(2));
    ob::ScopedState<> state(team);
    // A square that is open on one side: the first link and the last are a link's length apart.
    state = std::vector<double>{0.0, M_PI / 2, M_PI / 2};
    for (const auto &setup : checkers.setups)
        EXPECT_NEAR(setup->getTeamChecker()->clearance(state.get()), 0.9, 0.1);
}

TEST(SelfCollisions, OfACarWithItsTrailerCountIfAskedFor)
{
    // The hinge is near the car's rear.
    const Body car({{Shape::box(Eigen::Vector2d(0.9, 0.25)), planarPose(0.35, 0.0)}}), trailer = Body::box(0.3, 0.25);
    for (const bool selfCollision : {false, true})
    {
        const auto team =
            teamOf({std::make_shared<CarWithTrailer>("train", car, trailer, 0.5, cubeBounds(2, HALF), selfCollision)});
        const Checkers checkers(team, noObstacles(2));
        ob::ScopedState<> line(team), folded(team);
        line = std::vector<double>{0.0, 0.0, 1.0, 1.0};
        folded = std::vector<double>{0.0, 0.0, 1.0, -2.5};
        for (const auto &setup : checkers.setups)
        {
            EXPECT_TRUE(setup->getTeamChecker()->isValid(line.get()));
            EXPECT_EQ(setup->getTeamChecker()->isValid(folded.get()), !selfCollision);
            EXPECT_EQ(setup->getSpaceInformation()->checkMotion(line.get(), folded.get()), !selfCollision);
        }
    }
}

TEST(SelfCollisions, IsSeenBetweenSamplesByTheContinuousMode)
{
    // The second link sweeps across the first between two samples.
    const Body bar({{Shape::box(Eigen::Vector2d(1.0, 0.01)), planarPose(0.5, 0.0)}}),
        tip({{Shape::box(Eigen::Vector2d(0.2, 0.01)), planarPose(0.3, 0.0)}});
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    const auto team = teamOf({std::make_shared<Chain>(
        "arm", std::vector<Chain::Link>{{bar, planarPose(0.0, 0.0), z, 0.0}, {tip, planarPose(0.5, 0.0), z, 0.0}},
        std::vector<BodyPair>{{0, 1}})});
    ob::ScopedState<> from(team), to(team);
    from = std::vector<double>{0.0, -0.3};
    to = std::vector<double>{0.0, 0.31};
    const Checkers coarse(team, noObstacles(2), 0.07);
    for (const auto &setup : coarse.setups)
        EXPECT_TRUE(setup->getSpaceInformation()->checkMotion(from.get(), to.get())) << "discrete";
    const TeamSetup setup(team, noObstacles(2), Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS);
    setup.getSpaceInformation()->setStateValidityCheckingResolution(0.07);
    setup.getSpaceInformation()->setup();
    EXPECT_FALSE(setup.getSpaceInformation()->checkMotion(from.get(), to.get()));
    const auto &validator =
        dynamic_cast<const CertificateMotionValidator &>(*setup.getSpaceInformation()->getMotionValidator());
    const auto own = [](const ob::ScopedState<> &whole) { return whole->as<ob::CompoundState>()->components[0]; };
    EXPECT_FALSE(validator.isRobotMotionFree(0, own(from), own(to)));
    from = std::vector<double>{0.0, -1.0};
    to = std::vector<double>{0.0, -1.6};
    EXPECT_TRUE(setup.getSpaceInformation()->checkMotion(from.get(), to.get()));
    EXPECT_TRUE(validator.isRobotMotionFree(0, own(from), own(to)));
}

/** A state beyond its bounds proves nothing: motion bounds and the reaches of cells may not hold there. */
TEST(SelfCollisions, OfStatesBeyondTheirBoundsTeachTheCellsNothing)
{
    using Answer = JointCells::Answer;
    unsigned int beyond = 0, within = 0;
    for (unsigned int seed = 0; seed < 10; ++seed)
    {
        const auto arm = linksOnARail(seed);
        const auto team = teamOf({arm});
        TeamSetup setup(team, noObstacles(3));
        setup.getSpaceInformation()->setup();
        setup.getTeamChecker()->setCertificatesAfter(0);
        setup.getTeamChecker()->setAdaptive(false);
        Random random(seed);
        for (int i = 0; i < 300; ++i)
        {
            auto state = randomState(random, team);
            const auto answer = [&] { return arm->getJointCells(0)->find({state[1], state[2]}).answer; };
            if (answer() != Answer::UNKNOWN)
                continue;
            for (const double slide : {1.5, 0.5})
            {
                state[0] = slide;
                for (int k = 0; k < 3; ++k)
                    setup.getTeamChecker()->isValid(state.get());
                const bool learns = answer() != Answer::UNKNOWN && answer() != Answer::ASKED;
                (slide > 1.0 ? beyond : within) += learns ? 1 : 0;
            }
        }
    }
    EXPECT_EQ(beyond, 0U);
    EXPECT_GT(within, 0U);
}

/** There the relative pose of two bodies is rounded otherwise wherever the rest of the robot is. */
TEST(SelfCollisions, FarFromTheOriginAreWhatFclSays)
{
    unsigned int touching = 0, apart = 0;
    for (unsigned int seed = 0; seed < scaled(20); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double angle = random.uniform(-2.0, 2.0);
        const auto team = teamOf({wallOnARail(1e12, angle, 0.01)});
        const Checkers checkers(team, noObstacles(3));
        for (int i = 0; i < 500; ++i)
        {
            ob::ScopedState<> state(team);
            state =
                std::vector<double>{random.uniform(-1.0, 1.0), angle + random.sign() * random.logUniform(1e-6, 1e-2)};
            const bool isValid = checkers.isValid(state.get());
            ++(isValid ? apart : touching);
            for (const auto &setup : checkers.compared())
                ASSERT_EQ(setup->getTeamChecker()->isValid(state.get()), isValid);
        }
    }
    EXPECT_GT(touching, scaled(1000));
    EXPECT_GT(apart, scaled(1000));
}
