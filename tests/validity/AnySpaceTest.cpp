#include "support/ErrorsOnly.h"
#include "support/IterationLimit.h"
#include "support/Teams.h"

#include "ompl_certificates/validity/Basic.h"
#include "ompl_certificates/validity/CertificateMotionValidator.h"
#include "ompl_certificates/validity/Partial.h"
#include "ompl_certificates/validity/SharedProjection.h"

#include <gtest/gtest.h>
#include <ompl/base/ConstrainedSpaceInformation.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/WrapperStateSpace.h>
#include <ompl/base/spaces/constraint/ProjectedStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** A user's own spaces for the robots of a team: of the same classes, but other objects */
    ob::StateSpacePtr ownSpaceOf(const Robot &robot)
    {
        const ob::StateSpacePtr &space = robot.getStateSpace();
        const auto copyBounds = [](auto own, const auto *of)
        {
            own->setBounds(of->getBounds());
            return own;
        };
        if (const auto *se2 = dynamic_cast<const ob::SE2StateSpace *>(space.get()))
            return copyBounds(std::make_shared<ob::SE2StateSpace>(), se2);
        if (const auto *se3 = dynamic_cast<const ob::SE3StateSpace *>(space.get()))
            return copyBounds(std::make_shared<ob::SE3StateSpace>(), se3);
        if (const auto *vector = dynamic_cast<const ob::RealVectorStateSpace *>(space.get()))
            return copyBounds(std::make_shared<ob::RealVectorStateSpace>(vector->getDimension()), vector);
        return space;  // A class of the robot's own
    }

    /** A robot that is not checked against itself */
    class Unpaired : public Robot
    {
    public:
        explicit Unpaired(const RobotPtr &robot)
          : Robot(robot->getName(), robot->getStateSpace(), robot->getBodies()), robot_(robot)
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            robot_->computePoses(state, poses);
        }

        void computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const override
        {
            robot_->computeMotionBounds(from, to, bounds);
        }

    private:
        RobotPtr robot_;
    };

    ob::StateSpacePtr compoundSpaceOf(const std::vector<RobotPtr> &robots)
    {
        auto space = std::make_shared<ob::CompoundStateSpace>();
        for (const RobotPtr &robot : robots)
            space->addSubspace(ownSpaceOf(*robot), 1.0);
        return space;
    }

    /** Any of the spaces that a program may have for these robots */
    std::vector<ob::StateSpacePtr> spacesOf(const std::vector<RobotPtr> &robots)
    {
        std::vector<ob::StateSpacePtr> spaces{compoundSpaceOf(robots)};
        if (robots.size() == 1)
            spaces.push_back(ownSpaceOf(*robots.front()));
        for (std::size_t plain = spaces.size(), i = 0; i < plain; ++i)
            spaces.push_back(std::make_shared<ob::WrapperStateSpace>(spaces[i]));
        return spaces;
    }

    /** Expects the verdicts of FCL at the resolution of a space, in which \e robots are checked by all methods */
    void expectVerdictsOfFcl(const ob::StateSpacePtr &space, const std::vector<RobotPtr> &robots,
                             const ObstaclesPtr &obstacles, Random &random)
    {
        auto si = std::make_shared<ob::SpaceInformation>(space);
        const auto fcl = std::make_shared<TeamValidityChecker>(si, obstacles, robots, Method::FCL);
        si->setStateValidityChecker(fcl);
        si->setup();
        const ob::DiscreteMotionValidator ompl(si);
        const auto plain = compoundSpaceOf(robots);
        const auto stateOf = [&](const ob::ScopedState<> &of)
        {
            ob::ScopedState<> state(space);
            space->copyFromReals(state.get(), of.reals());
            return state;
        };
        for (const Method method : allMethods())
        {
            SCOPED_TRACE(nameOf(method));
            const auto checker = std::make_shared<TeamValidityChecker>(si, obstacles, robots, method);
            checker->setCertificatesAfter(0);
            const CertificateMotionValidator validator(checker);
            unsigned int valid = 0;
            for (unsigned int i = 0; i < scaled(200); ++i)
            {
                const ob::ScopedState<> from = randomState(random, plain);
                const ob::ScopedState<> s1 = stateOf(from), s2 = stateOf(randomStateNear(random, from, 0.3));
                ASSERT_EQ(checker->isValid(s2.get()), fcl->isValid(s2.get()));
                ASSERT_EQ(checker->isValid(s1.get()), fcl->isValid(s1.get()));
                ASSERT_EQ(checker->clearance(s1.get()) > 0.0 && !fcl->isValid(s1.get()), false);
                if (!fcl->isValid(s1.get()))
                    continue;
                std::pair<ob::State *, double> last{nullptr, 1.0}, expected{nullptr, 1.0};
                const bool free = ompl.checkMotion(s1.get(), s2.get(), expected);
                ASSERT_EQ(validator.checkMotion(s1.get(), s2.get()), free);
                ASSERT_EQ(validator.checkMotion(s1.get(), s2.get(), last), free);
                ASSERT_EQ(last.second, expected.second);
                valid += free ? 1 : 0;
            }
            EXPECT_GT(valid, scaled(10));
            if (makesCertificates(method))
            {
                EXPECT_GT(checker->getStatistics().getCounts().certifiedFree, 0U);
            }
        }
    }
}

class AnySpace : public ErrorsOnly<unsigned int>
{
};

TEST_P(AnySpace, OfATeamGivesTheVerdictsOfFcl)
{
    Random random(GetParam());
    const auto obstacles = anyObstacles(random, GetParam(), 5);
    const auto robots = anyTeam(GetParam())->getRobots();
    for (const ob::StateSpacePtr &space : spacesOf(robots))
        ASSERT_NO_FATAL_FAILURE(expectVerdictsOfFcl(space, robots, obstacles, random));
}

TEST_P(AnySpace, OfOneRobotGivesTheVerdictsOfFcl)
{
    Random random(GetParam());
    const auto obstacles = anyObstacles(random, GetParam(), 8);
    const auto team = anyTeam(GetParam());
    for (const RobotPtr &robot : team->getRobots())
        for (const ob::StateSpacePtr &space : spacesOf({robot}))
        {
            SCOPED_TRACE(robot->getName() + " in " + space->getName());
            ASSERT_NO_FATAL_FAILURE(expectVerdictsOfFcl(space, {robot}, obstacles, random));
        }
}

TEST_P(AnySpace, AnswersForOneRobotAndOnePairAsForTheTeamOfThem)
{
    Random random(GetParam());
    const auto team = anyTeam(GetParam());
    const auto obstacles = anyObstacles(random, GetParam(), 5);
    const auto none = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, team->getWorkspaceDimension());
    const auto si = std::make_shared<ob::SpaceInformation>(team);
    std::vector<std::shared_ptr<TeamValidityChecker>> checkers;
    for (const Method method : allMethods())
    {
        checkers.push_back(std::make_shared<TeamValidityChecker>(si, obstacles, method));
        checkers.back()->setCertificatesAfter(0);
    }
    si->setStateValidityChecker(checkers.front());
    si->setup();
    unsigned int free = 0, touching = 0;
    const auto expect = [&](bool expected, const auto &ask)
    {
        for (const auto &checker : checkers)
            EXPECT_EQ(ask(*checker), expected) << nameOf(checker->getMethod());
        ++(expected ? free : touching);
    };
    for (unsigned int i = 0; i < 3 && !HasFailure(); ++i)
    {
        const unsigned int j = (i + 1) % 3;
        const RobotPtr &a = team->getRobots()[i], &b = team->getRobots()[j];
        const auto fclOf = [&](const std::vector<RobotPtr> &robots, const ObstaclesPtr &among)
        {
            auto own = std::make_shared<ob::SpaceInformation>(compoundSpaceOf(robots));
            own->setStateValidityChecker(std::make_shared<TeamValidityChecker>(own, among, robots, Method::FCL));
            own->setup();
            return own;
        };
        const auto one = fclOf({a}, obstacles),
                   both = fclOf({std::make_shared<Unpaired>(a), std::make_shared<Unpaired>(b)}, none);
        for (unsigned int k = 0; k < scaled(100); ++k)
        {
            const auto from = randomState(random, both->getStateSpace());
            const auto to = randomStateNear(random, from, 0.4);
            const ob::State *aFrom = from->as<ob::CompoundState>()->components[0],
                            *bFrom = from->as<ob::CompoundState>()->components[1],
                            *aTo = to->as<ob::CompoundState>()->components[0],
                            *bTo = to->as<ob::CompoundState>()->components[1];
            ob::ScopedState<> alone(one->getStateSpace()), aloneTo(one->getStateSpace());
            a->getStateSpace()->copyState(alone->as<ob::CompoundState>()->components[0], aFrom);
            a->getStateSpace()->copyState(aloneTo->as<ob::CompoundState>()->components[0], aTo);
            expect(one->isValid(alone.get()), [&](const auto &checker) { return checker.isRobotFree(i, aFrom); });
            expect(both->isValid(from.get()),
                   [&](const auto &checker) { return checker.isPairFree(i, aFrom, j, bFrom); });
            if (one->isValid(alone.get()))
                expect(one->checkMotion(alone.get(), aloneTo.get()),
                       [&](const auto &checker) { return checker.isRobotMotionFree(i, aFrom, aTo); });
            if (both->isValid(from.get()))
                expect(both->checkMotion(from.get(), to.get()),
                       [&](const auto &checker) { return checker.isPairMotionFree(i, aFrom, aTo, j, bFrom, bTo); });
        }
        EXPECT_THROW(checkers[0]->isPairFree(i, nullptr, i, nullptr), ompl::Exception);
    }
    EXPECT_GT(free, scaled(200));
    EXPECT_GT(touching, 0U);
}

INSTANTIATE_TEST_SUITE_P(Kind, AnySpace, testing::Range(0U, TEAMS));

TEST(AnySpaceOfOneRobot, GrowsTheTreeOfAUsersProgram)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    const auto bounds = cubeBounds(3, HALF);
    const auto robot = RigidRobot::inSE3("drone", Body::box(0.8, 0.3, 0.2), bounds);
    std::size_t states = 0;
    for (unsigned int seed = 0; seed < scaled(5); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto obstacles = scatteredObstacles(random, 3, 20);
        const auto grow = [&](Method method)
        {
            ompl::RNG::setSeed(seed + 1);
            auto space = std::make_shared<ob::SE3StateSpace>();
            space->setBounds(bounds);
            ompl::geometric::SimpleSetup setup(space);
            const auto si = setup.getSpaceInformation();
            const auto checker =
                std::make_shared<TeamValidityChecker>(si, obstacles, std::vector<RobotPtr>{robot}, method);
            checker->setCertificatesAfter(0);
            setup.setStateValidityChecker(checker);
            if (makesCertificates(method))
                si->setMotionValidator(std::make_shared<CertificateMotionValidator>(checker));
            Random own(seed);
            const auto valid = [&]
            {
                for (;;)
                    if (const auto state = randomState(own, space); checker->isValid(state.get()))
                        return state;
            };
            setup.setStartAndGoalStates(valid(), valid());
            setup.setPlanner(std::make_shared<ompl::geometric::RRT>(si));
            setup.setup();
            ob::IterationTerminationCondition condition(500);
            setup.solve(condition);
            ob::PlannerData data(si);
            setup.getPlanner()->getPlannerData(data);
            std::vector<std::vector<double>> tree(data.numVertices());
            for (unsigned int i = 0; i < data.numVertices(); ++i)
                space->copyToReals(tree[i], data.getVertex(i).getState());
            std::sort(tree.begin(), tree.end());
            return tree;
        };
        const auto expected = grow(Method::FCL);
        states += expected.size();
        for (const Method method : {Method::BASIC, Method::PARTIAL, Method::SHARED_PROJECTION})
            ASSERT_EQ(grow(method), expected) << nameOf(method);
    }
    EXPECT_GT(states, scaled(50));
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
}

TEST(AnySpaceConstrained, IsAskedByTheValidatorOfOmpl)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    /** The surface of a sphere */
    class OnASphere : public ob::Constraint
    {
    public:
        OnASphere() : Constraint(3, 1)
        {
        }

        void function(const Eigen::Ref<const Eigen::VectorXd> &x, Eigen::Ref<Eigen::VectorXd> out) const override
        {
            out[0] = x.norm() - 3.0;
        }
    };
    const auto bounds = cubeBounds(3, HALF);
    auto ambient = std::make_shared<ob::RealVectorStateSpace>(3);
    ambient->setBounds(bounds);
    const auto space = std::make_shared<ob::ProjectedStateSpace>(ambient, std::make_shared<OnASphere>());
    auto si = std::make_shared<ob::ConstrainedSpaceInformation>(space);
    const auto robot = RigidRobot::sphere("ball", 0.2, bounds);
    // A belt about the sphere with a gap
    std::vector<PlacedBody> belt;
    for (int i = 1; i < 24; ++i)
        belt.push_back(
            {Body::sphere(0.5), poseAt({3.0 * std::cos(M_PI * i / 12), 3.0 * std::sin(M_PI * i / 12), 0.0})});
    const auto obstacles = std::make_shared<FclObstacles>(belt, 3);
    const auto checker = std::make_shared<SharedProjection>(si, obstacles, robot);
    checker->setCertificatesAfter(0);
    EXPECT_THROW(CertificateMotionValidator{checker}, ompl::Exception);
    EXPECT_FALSE(checker->getTeam().interpolatesRobots());

    ompl::geometric::SimpleSetup setup(si);
    setup.setStateValidityChecker(checker);
    const auto at = [&](double z)
    {
        ob::ScopedState<> state(space);
        state->as<ob::ConstrainedStateSpace::StateType>()->copy(Eigen::Vector3d(0.0, std::sqrt(9.0 - z * z), z));
        return state;
    };
    setup.setStartAndGoalStates(at(2.0), at(-2.0));
    setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(si));
    ASSERT_EQ(setup.solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
    const TeamValidityChecker fcl(si, obstacles, {robot}, Method::FCL);
    // In one of a hundred plans OMPL's projected space adds a state that collides, with FCL's checks as with these: it
    // was not asked about, or refused.
    for (const ob::State *state : setup.getSolutionPath().getStates())
        EXPECT_EQ(checker->isValid(state), fcl.isValid(state));
    const CheckCounts counts = checker->getStatistics().getCounts();
    // However the clock goes, some trials are counted.
    EXPECT_GT(counts.certifiedFree, 0U);
}

TEST(AnySpaceThatDoesNotFit, IsRefused)
{
    const auto bounds = cubeBounds(2, HALF);
    const auto disc = RigidRobot::disc("disc", 0.2, bounds);
    const auto box = RigidRobot::inSE2("box", Body::box(0.6, 0.3), bounds);
    const auto ball = RigidRobot::sphere("ball", 0.2, cubeBounds(3, HALF));
    const auto none = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2);
    const auto refuses = [&](const ob::StateSpacePtr &space, const std::vector<RobotPtr> &robots)
    { EXPECT_THROW(SharedProjection(std::make_shared<ob::SpaceInformation>(space), none, robots), ompl::Exception); };
    const auto plane = ownSpaceOf(*disc);
    refuses(plane, {});
    refuses(plane, {nullptr});
    refuses(plane, {box});
    refuses(plane, {ball});
    refuses(plane, {disc, disc});
    refuses(compoundSpaceOf({disc, box}), {disc});
    refuses(compoundSpaceOf({disc, box}), {box, disc});
    refuses(compoundSpaceOf({disc, ball}), {disc, ball});
    refuses(std::make_shared<ob::RealVectorStateSpace>(3), {disc});
    EXPECT_THROW(SharedProjection(std::make_shared<ob::SpaceInformation>(plane), none), ompl::Exception);
    EXPECT_THROW(SharedProjection(nullptr, none, disc), ompl::Exception);
    EXPECT_THROW(SharedProjection(std::make_shared<ob::SpaceInformation>(plane), nullptr, disc), ompl::Exception);
}
