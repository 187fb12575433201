#include "support/Complaint.h"
#include "support/Quiet.h"
#include "support/Teams.h"

#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    class AnyTeam : public testing::TestWithParam<unsigned int>
    {
    protected:
        void SetUp() override
        {
            team_ = anyTeam(GetParam());
            team_->setup();
        }

        TeamStateSpacePtr team_;
    };
}

TEST_P(AnyTeam, PassesTheSanityChecksOfOmpl)
{
    EXPECT_NO_THROW(team_->sanityChecks());
}

TEST(TeamStateSpace, PassesTheSanityChecksOfOmplWithCars)
{
    // Not with all seeds: OMPL's samples of curves rarely tell.
    for (unsigned int seed = 0; seed < scaled(20); ++seed)
    {
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(RigidRobot::inReedsShepp("car", Body::box(0.5, 0.25), 0.7, cubeBounds(2, 10.0)));
        team->addRobot(RigidRobot::disc("disc", 0.2, cubeBounds(2, 10.0)));
        team->setup();
        EXPECT_NO_THROW(team->sanityChecks());
    }
}

TEST_P(AnyTeam, MeasuresEuclideanDistancesOverItsWeightedRobots)
{
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto a = randomState(random, team_), b = randomState(random, team_), c = randomState(random, team_);
        double squares = 0.0;
        for (unsigned int i = 0; i < team_->getRobotCount(); ++i)
            squares += std::pow(team_->getSubspaceWeight(i) *
                                    team_->getSubspace(i)->distance(a->as<ob::CompoundState>()->components[i],
                                                                    b->as<ob::CompoundState>()->components[i]),
                                2);
        const double ab = team_->distance(a.get(), b.get());
        EXPECT_NEAR(ab, std::sqrt(squares), 1e-12);
        EXPECT_DOUBLE_EQ(ab, team_->distance(b.get(), a.get()));
        EXPECT_LE(ab, team_->distance(a.get(), c.get()) + team_->distance(c.get(), b.get()) + 1e-12);
        EXPECT_LE(ab, team_->getMaximumExtent());
        EXPECT_EQ(team_->distance(a.get(), a.get()), 0.0);
    }
}

TEST_P(AnyTeam, CountsSegmentsByAResolutionOfItsOwn)
{
    Random random(GetParam());
    const double fraction = std::pow(10.0, random.uniform(-4.0, -1.0));
    // Another team of the same robots, whose spaces it shares
    auto other = std::make_shared<TeamStateSpace>();
    ob::CompoundStateSpace plain;
    for (unsigned int i = 0; i < team_->getRobotCount(); ++i)
    {
        other->addRobot(team_->getRobots()[i]);
        plain.addSubspace(team_->getSubspace(i), 1.0);
    }
    team_->setLongestValidSegmentFraction(fraction);
    other->setLongestValidSegmentFraction(0.5 * fraction);
    team_->setup();
    other->setup();
    EXPECT_EQ(team_->getLongestValidSegmentFraction(), fraction);
    for (unsigned int i = 0; i < team_->getRobotCount(); ++i)
        EXPECT_EQ(team_->getSubspace(i)->getLongestValidSegmentFraction(), 0.01);
    std::vector<std::pair<ob::ScopedState<>, ob::ScopedState<>>> motions;
    std::vector<unsigned int> counts, halves;
    for (unsigned int i = 0; i < scaled(100); ++i)
    {
        motions.emplace_back(randomState(random, team_), randomState(random, team_));
        counts.push_back(team_->validSegmentCount(motions[i].first.get(), motions[i].second.get()));
        halves.push_back(other->validSegmentCount(motions[i].first.get(), motions[i].second.get()));
    }
    // OMPL's own count changes the components.
    const auto expectCounts = [&](double of, const std::vector<unsigned int> &expected)
    {
        plain.setLongestValidSegmentFraction(of);
        plain.setup();
        for (std::size_t i = 0; i < motions.size(); ++i)
            EXPECT_EQ(plain.validSegmentCount(motions[i].first.get(), motions[i].second.get()), expected[i]);
    };
    expectCounts(fraction, counts);
    expectCounts(0.5 * fraction, halves);
    for (std::size_t i = 0; i < motions.size(); ++i)
        EXPECT_EQ(team_->validSegmentCount(motions[i].first.get(), motions[i].second.get()), counts[i]);
    EXPECT_THROW(team_->setLongestValidSegmentFraction(0.0), ompl::Exception);
    EXPECT_THROW(team_->setLongestValidSegmentFraction(1.0), ompl::Exception);
}

// OMPL's spaces draw random projections when they are first set up.
TEST_P(AnyTeam, DrawsNoMoreRandomNumbersForTheFirstTeamOfItsRobots)
{
    const Quiet quiet;
    const std::vector<RobotPtr> robots = anyTeam(GetParam())->getRobots();
    std::vector<double> next;
    for (int i = 0; i < 3; ++i)
    {
        TeamStateSpace team;
        for (const RobotPtr &robot : robots)
            team.addRobot(robot);
        ompl::RNG::setSeed(1);
        team.setup();
        next.push_back(ompl::RNG().uniform01());
    }
    EXPECT_EQ(next[0], next[1]);
    EXPECT_EQ(next[1], next[2]);
}

namespace
{
    /** Whether \e action leaves what \e space knows of its states as it is, for others may be reading it: a mark there
        would be gone. */
    bool leavesLocations(const ob::StateSpace &space, const std::function<void()> &action)
    {
        constexpr std::size_t mark = 100;
        auto &first = const_cast<ob::StateSpace::ValueLocation &>(space.getValueLocations().front());
        first.index += mark;
        action();
        const bool isLeft = space.getValueLocations().front().index >= mark;
        if (isLeft)
            first.index -= mark;
        return isLeft;
    }
}

TEST_P(AnyTeam, IsSetUpAgainOnlyWhereSomethingHasChanged)
{
    const auto setup = [this] { team_->setup(); };
    EXPECT_TRUE(leavesLocations(*team_, setup));
    EXPECT_TRUE(leavesLocations(*team_->getSubspace(0), setup));
    team_->setLongestValidSegmentFraction(0.01);
    EXPECT_FALSE(leavesLocations(*team_, setup));
    EXPECT_TRUE(leavesLocations(*team_, setup));
    team_->setSubspaceWeight(0, 3.0);
    EXPECT_FALSE(leavesLocations(*team_, setup));
    EXPECT_TRUE(leavesLocations(*team_->getSubspace(0), [this] { team_->computeLocations(); }));
}

TEST_P(AnyTeam, HasTheProjectionThatWasConfiguredAfterASecondSetup)
{
    const ob::ProjectionEvaluatorPtr inferred = team_->getDefaultProjection();
    team_->setup();
    EXPECT_NE(team_->getDefaultProjection(), inferred) << "the sizes of its cells are inferred anew";
    team_->getDefaultProjection()->setCellSizes(
        std::vector<double>(team_->getDefaultProjection()->getDimension(), 0.5));
    team_->setup();
    EXPECT_EQ(team_->getDefaultProjection()->getCellSizes().front(), 0.5);
    std::string size;
    EXPECT_TRUE(team_->params().getParam("projection.cellsize.0", size));
    EXPECT_EQ(std::stod(size), 0.5);
}

TEST_P(AnyTeam, HasALockableListOfRobots)
{
    EXPECT_EQ(team_->getRobotCount(), 3U);
    EXPECT_EQ(team_->getSubspaceCount(), 3U);
    EXPECT_EQ(team_->getRobots().size(), 3U);
    for (unsigned int i = 0; i < 3; ++i)
    {
        EXPECT_EQ(&team_->getRobot(i), team_->getRobots()[i].get());
        EXPECT_EQ(team_->getSubspace(i), team_->getRobot(i).getStateSpace());
        EXPECT_EQ(team_->getSubspaceIndex(team_->getRobot(i).getName()), i);
    }
    team_->lock();
    EXPECT_THROW(team_->addRobot(RigidRobot::disc("late", 1.0, cubeBounds(2, 1.0))), ompl::Exception);
    EXPECT_EQ(team_->getRobotCount(), 3U);
}

INSTANTIATE_TEST_SUITE_P(Kind, AnyTeam, testing::Values(0U, 1U, 2U));

TEST(TeamStateSpace, HasStatesThatAreReadAsTheDocumentsSay)
{
    const auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::disc("scout", 0.3, cubeBounds(2, HALF)));
    team->addRobot(RigidRobot::inSE2("carrier", Body::box(0.5, 0.25), cubeBounds(2, HALF)));
    team->setup();
    ob::ScopedState<TeamStateSpace> start(team);
    start = std::vector<double>{3.0, 4.0, 0.0, 0.0, 0.5};
    start->as<ob::SE2StateSpace::StateType>(1)->setXY(1.0, 2.0);
    const ob::State *state = start.get();
    const auto *second = state->as<TeamStateSpace::StateType>()->as<ob::SE2StateSpace::StateType>(1);
    EXPECT_EQ(second->getX(), 1.0);
    EXPECT_EQ(second->getYaw(), 0.5);
    EXPECT_EQ(team->getSubspaceIndex("carrier"), 1U);
    EXPECT_EQ(team->as<ob::SE2StateSpace>(1), team->getSubspace("carrier").get());

    ob::ScopedState<ob::SE2StateSpace> carrier(team->getSubspace("carrier"));
    carrier->setXY(-1.0, -2.0);
    carrier->setYaw(0.25);
    start << carrier;
    EXPECT_EQ(start.reals(), (std::vector<double>{3.0, 4.0, -1.0, -2.0, 0.25}));
    carrier->setYaw(0.0);
    start >> carrier;
    EXPECT_EQ(carrier->getYaw(), 0.25);
}

TEST(TeamStateSpace, HasTheExtentOfItsWeightedRobots)
{
    TeamStateSpace team;
    team.addRobot(RigidRobot::disc("a", 1.0, cubeBounds(2, 1.5)), 2.0);
    team.addRobot(RigidRobot::disc("b", 1.0, cubeBounds(2, 2.0)), 0.5);
    team.addRobot(RigidRobot::disc("c", 1.0, cubeBounds(2, 1e9)), 0.0);
    EXPECT_NEAR(team.getMaximumExtent(), std::sqrt(std::pow(2.0 * 3.0, 2) * 2.0 + std::pow(0.5 * 4.0, 2) * 2.0), 1e-9);
}

TEST(TeamStateSpace, HasThePlannerRangeOfItsWeightedRobots)
{
    for (const auto metric : {TeamStateSpace::EUCLIDEAN, TeamStateSpace::SUM})
    {
        TeamStateSpace team(metric);
        team.addRobot(RigidRobot::disc("a", 1.0, cubeBounds(2, 1.5)), 2.0);
        team.addRobot(RigidRobot::disc("b", 1.0, cubeBounds(2, 2.0)), 0.5);
        team.addRobot(RigidRobot::disc("c", 1.0, cubeBounds(2, 1e9)), 0.0);
        EXPECT_DOUBLE_EQ(team.getPlannerRange(), 0.2 * team.getMaximumExtent());
        if (metric == TeamStateSpace::SUM)
        {
            EXPECT_EQ(team.getMaximumExtent(), team.CompoundStateSpace::getMaximumExtent());
        }
    }
}

TEST(TeamStateSpace, RefusesRobotsThatDoNotFit)
{
    TeamStateSpace team;
    const auto bounds = cubeBounds(2, 1.0);
    EXPECT_EQ(team.getWorkspaceDimension(), 0U);
    EXPECT_THROW(team.addRobot(nullptr), ompl::Exception);
    team.addRobot(RigidRobot::disc("a", 1.0, bounds));
    EXPECT_EQ(team.getWorkspaceDimension(), 2U);
    EXPECT_THROW(team.addRobot(RigidRobot::disc("a", 0.5, bounds)), ompl::Exception);
    EXPECT_THROW(team.addRobot(RigidRobot::sphere("b", 0.5, cubeBounds(3, 1.0))), ompl::Exception);
    EXPECT_THROW(team.addRobot(RigidRobot::disc("b", 0.5, bounds), -1.0), ompl::Exception);
    EXPECT_EQ(team.getRobotCount(), 1U);
    EXPECT_EQ(team.getSubspaceCount(), 1U);
    EXPECT_NO_THROW(team.addRobot(RigidRobot::disc("b", 0.5, bounds), 0.0));
}

TEST(TeamStateSpace, RefusesAWeightThatIsNotANumber)
{
    TeamStateSpace team;
    EXPECT_THROW(team.addRobot(RigidRobot::disc("a", 1.0, cubeBounds(2, 1.0)), std::nan("")), ompl::Exception);
    EXPECT_EQ(team.getRobotCount(), 0U);
}

TEST(TeamStateSpace, RefusesSpeedsAtWhichNobodyArrives)
{
    TeamStateSpace team;
    team.addRobot(RigidRobot::disc("a", 1.0, cubeBounds(2, 1.0)));
    EXPECT_EQ(team.getSpeed(0), 1.0);
    for (const double speed : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        expectWords(messageOf([&] { team.setSpeed(0, speed); }), {"speed", "'a'", std::to_string(speed)});
    expectWords(messageOf([&] { team.setSpeed(1, 2.0); }), {"no robot 1"});
    team.setSpeed(0, 2.0);
    EXPECT_EQ(team.getSpeed(0), 2.0);
}

TEST(TeamStateSpace, NamesTheRobotThatCannotMove)
{
    TeamStateSpace team;
    team.addRobot(RigidRobot::disc("free", 1.0, cubeBounds(2, 1.0)));
    team.addRobot(RigidRobot::disc("parked", 1.0, cubeBounds(2, 0.0)));
    expectWords(messageOf([&] { team.setup(); }), {"robot 'parked' cannot move"});
    TeamStateSpace weightless;
    weightless.addRobot(RigidRobot::disc("a", 1.0, cubeBounds(2, 1.0)), 0.0);
    expectWords(messageOf([&] { weightless.setup(); }), {"weights of all robots are 0"});
}

TEST(TeamStateSpace, IsNotSetUpWithoutRobotsOrWithOtherComponents)
{
    TeamStateSpace empty;
    EXPECT_THROW(empty.setup(), ompl::Exception);
    TeamStateSpace mixed;
    mixed.addRobot(RigidRobot::disc("a", 1.0, cubeBounds(2, 1.0)));
    auto other = std::make_shared<ob::SE2StateSpace>();
    other->setBounds(cubeBounds(2, 1.0));
    mixed.addSubspace(other, 1.0);
    EXPECT_THROW(mixed.setup(), ompl::Exception);
}

// Its states are laid out for the spaces as they were.
TEST(TeamStateSpace, IsNotSetUpIfTheSpaceOfARobotHasGrown)
{
    TeamStateSpace team;
    const RobotPtr disc = RigidRobot::disc("growing", 1.0, cubeBounds(2, 1.0));
    team.addRobot(disc);
    disc->getStateSpace()->as<ob::RealVectorStateSpace>()->addDimension(-1.0, 1.0);
    expectWords(messageOf([&] { team.setup(); }), {"'growing'", "changed its dimension"});
}
