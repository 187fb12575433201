#include "ompl_certificates/planning/PassingOrder.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/team/PathTimes.h"
#include "ompl_certificates/team/TimedPath.h"
#include "ompl_certificates/validity/CertificateMotionValidator.h"
#include "support/Quiet.h"
#include "support/Random.h"
#include "support/RandomStates.h"
#include "support/TeamOf.h"
#include "support/Teams.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>
#include <limits>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/util/Exception.h>
#include <optional>
#include <set>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    /** A team among no obstacles */
    struct Planned
    {
        explicit Planned(const ob::StateSpacePtr &theTeam)
          : space(theTeam), si(std::make_shared<ob::SpaceInformation>(theTeam))
        {
            const Team team(theTeam);
            checker = std::make_shared<TeamValidityChecker>(si,
                                                            std::make_shared<FclObstacles>(std::vector<PlacedBody>{},
                                                                                           team.getWorkspaceDimension(),
                                                                                           team.getZInterval()),
                                                            Method::SHARED_PROJECTION);
            si->setStateValidityChecker(checker);
            si->setMotionValidator(
                std::make_shared<CertificateMotionValidator>(checker, CertificateMotionValidator::CONTINUOUS));
            si->setup();
        }

        og::PathGeometric through(const std::vector<std::vector<double>> &rows) const
        {
            og::PathGeometric path(si);
            ob::ScopedState<> state(space);
            for (const std::vector<double> &row : rows)
            {
                state = row;
                path.append(state.get());
            }
            return path;
        }

        const ob::StateSpacePtr space;
        const ob::SpaceInformationPtr si;
        std::shared_ptr<TeamValidityChecker> checker;
    };

    /** Robots that drive the stages of a path one after the other, now this one and now that one, each as far as it
        likes. Those that must drive a stage together do. */
    class Drive
    {
    public:
        Drive(const Planned &planned, const og::PathGeometric &path, const PassingOrder &order, bool heedsOrder)
          : planned_(planned)
          , order_(order)
          , path_(path)
          , heedsOrder_(heedsOrder)
          , ended_(planned.checker->getTeam().getRobotCount())
          , within_(ended_.size())
          , state_(planned.si)
          , moment_(planned.si)
        {
            for (unsigned int robot = 0; robot < ended_.size(); ++robot)
                place(robot);
        }

        /** Until all have arrived, or two touch, or nobody may go on
            \return what went wrong */
        std::optional<std::string> run(Random &random)
        {
            while (std::any_of(ended_.begin(), ended_.end(),
                               [this](std::size_t ended) { return ended < order_.getStageCount(); }))
            {
                const std::vector<std::vector<unsigned int>> groups = listGroups();
                if (groups.empty())
                    return "nobody may go on";
                move(groups[random.below(groups.size())], random.chance(0.3) ? 1.0 : random.uniform(0.0, 1.0));
                if (!planned_.checker->isValid(state_.get()))
                    return planned_.checker->describeCollision(state_.get());
            }
            return {};
        }

    private:
        /** Robots that have not arrived, together with those that drive the stage with them */
        std::vector<std::vector<unsigned int>> listGroups() const
        {
            std::set<std::vector<unsigned int>> groups;
            for (unsigned int robot = 0; robot < ended_.size(); ++robot)
                if (ended_[robot] < order_.getStageCount() && !(heedsOrder_ && !mayMove(robot)))
                    groups.insert(heedsOrder_ ? order_.getGroup(robot, ended_[robot])
                                              : std::vector<unsigned int>{robot});
            return {groups.begin(), groups.end()};
        }

        bool mayMove(unsigned int robot) const
        {
            return within_[robot] > 0.0 || !heedsOrder_ || order_.mayBegin(robot, ended_);
        }

        /** Moves robots on to \e part of what they have left of their stage */
        void move(const std::vector<unsigned int> &group, double part)
        {
            for (const unsigned int robot : group)
            {
                within_[robot] += part * (1.0 - within_[robot]);
                if (part == 1.0)
                {
                    ++ended_[robot];
                    within_[robot] = 0.0;
                }
                place(robot);
            }
        }

        void place(unsigned int robot)
        {
            const std::vector<double> &times = order_.getTimes();
            const std::size_t stage = ended_[robot], next = std::min(stage + 1, times.size() - 1);
            path_.computeState(times[stage] + within_[robot] * (times[next] - times[stage]), moment_.get());
            planned_.checker->getTeam().getRobotSpace(robot).copyState(
                state_->as<ob::CompoundState>()->components[robot],
                moment_->as<ob::CompoundState>()->components[robot]);
        }

        const Planned &planned_;
        const PassingOrder &order_;
        const TimedPath path_;
        const bool heedsOrder_;
        std::vector<std::size_t> ended_;
        std::vector<double> within_;
        ob::ScopedState<> state_, moment_;
    };

    /** Some motions of a team, one after the other, on each of which no two robots touch */
    og::PathGeometric randomPath(const Planned &planned, Random &random, unsigned int motions)
    {
        og::PathGeometric path(planned.si);
        ob::ScopedState<> state(planned.space);
        for (unsigned int tries = 0; tries < 10000 && path.getStateCount() <= motions; ++tries)
        {
            randomize(random, planned.space, state.get());
            const unsigned int count = static_cast<unsigned int>(path.getStateCount());
            // Some robots rest.
            for (unsigned int i = 0; count > 0 && i < planned.checker->getTeam().getRobotCount(); ++i)
                if (random.chance(0.2))
                    planned.checker->getTeam().getRobotSpace(i).copyState(
                        state->as<ob::CompoundState>()->components[i],
                        path.getState(count - 1)->as<ob::CompoundState>()->components[i]);
            if (planned.checker->isValid(state.get()) &&
                (count == 0 || planned.si->checkMotion(path.getState(count - 1), state.get())))
                path.append(state.get());
        }
        return path;
    }

    TeamStateSpacePtr manyRobots()
    {
        auto team = std::make_shared<TeamStateSpace>();
        for (unsigned int i = 0; i < 6; ++i)
        {
            const std::string name = "robot_" + std::to_string(i);
            team->addRobot(i % 2 == 0 ? RigidRobot::disc(name, 0.3, cubeBounds(2, 3.0))
                                      : RigidRobot::inSE2(name, Body::box(0.9, 0.2), cubeBounds(2, 3.0)));
            team->setSpeed(i, 1.0 + 0.2 * i);
        }
        return team;
    }

    /** Two discs of radius 0.4 that cross each other's way: the first along x at time 1 to 3, the second along y */
    class CrossingDiscs : public testing::Test
    {
    protected:
        const Planned planned_{teamOf(
            {RigidRobot::disc("first", 0.4, cubeBounds(2, 3.0)), RigidRobot::disc("second", 0.4, cubeBounds(2, 3.0))})};
        const std::vector<std::vector<double>> rows_{{-2.0, 0.0, 0.0, -2.0},
                                                     {2.0, 0.0, 0.0, -2.0},
                                                     {2.0, 0.0, 0.0, 2.0}};

    private:
        const Quiet quiet_;
    };

    class PassingOrderTest : public testing::TestWithParam<unsigned int>
    {
        const Quiet quiet_;
    };
}

TEST_F(CrossingDiscs, PassInTheOrderOfThePath)
{
    const PassingOrder order(planned_.through(rows_), planned_.checker, 1.0);
    EXPECT_EQ(order.getTimes(), (std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
    // The second comes near to (0, 0) in stage 5, but within 0.8 of (0.5, 0) already at the end of stage 4.
    ASSERT_EQ(order.getWaits().size(), 1U);
    EXPECT_EQ(order.getWaits()[0].robot, 1U);
    EXPECT_EQ(order.getWaits()[0].stage, 5U);
    EXPECT_EQ(order.getWaits()[0].other, 0U);
    EXPECT_EQ(order.getWaits()[0].otherStage, 2U);
    EXPECT_TRUE(order.getMeetings().empty());
    EXPECT_TRUE(order.mayBegin(1, {0, 4}));
    EXPECT_FALSE(order.mayBegin(1, {2, 5}));
    EXPECT_TRUE(order.mayBegin(1, {3, 5}));
    EXPECT_TRUE(order.mayBegin(0, {2, 0}));
    EXPECT_FALSE(order.mayBegin(0, {8, 5}));
    EXPECT_THROW(order.mayBegin(0, {8}), ompl::Exception);
    EXPECT_THROW(order.mayBegin(2, {8, 5}), ompl::Exception);
}

TEST_F(CrossingDiscs, TakePlacesThatOthersHaveLeft)
{
    const PassingOrder order(planned_.through({{0.0, 0.0, 2.0, 0.0}, {0.0, 2.0, 2.0, 0.0}, {0.0, 2.0, 0.0, 0.0}}),
                             planned_.checker, 0.5);
    ASSERT_EQ(order.getWaits().size(), 1U);
    EXPECT_EQ(order.getWaits()[0].robot, 1U);
    // It comes near (0.8, 0) in its stage 6, between 3 and 3.5, and the first leaves (0, 0.8) only in its stage 1.
    EXPECT_EQ(order.getWaits()[0].stage, 6U);
    EXPECT_EQ(order.getWaits()[0].otherStage, 1U);
}

TEST_F(CrossingDiscs, DriveTogetherWhereTheyPassClosely)
{
    // The second follows the first, with a gap of 0.2 between them.
    const og::PathGeometric path = planned_.through({{-1.0, 0.0, -2.0, 0.0}, {2.0, 0.0, 1.0, 0.0}});
    const PassingOrder order(path, planned_.checker, 1.0);
    ASSERT_EQ(order.getMeetings().size(), 3U);
    EXPECT_EQ(order.getMeetings()[1].first, 0U);
    EXPECT_EQ(order.getMeetings()[1].second, 1U);
    EXPECT_EQ(order.getMeetings()[1].stage, 1U);
    EXPECT_FALSE(order.mayBegin(0, {1, 0}));
    EXPECT_FALSE(order.mayBegin(1, {0, 1}));
    EXPECT_TRUE(order.mayBegin(0, {1, 1}));
    EXPECT_EQ(order.getGroup(1, 1), (std::vector<unsigned int>{0, 1}));
    EXPECT_THROW(order.getGroup(2, 1), ompl::Exception);
    // In smaller stages it is four behind.
    const PassingOrder fine(path, planned_.checker, 0.05);
    EXPECT_TRUE(fine.getMeetings().empty());
    ASSERT_GT(fine.getWaits().size(), 50U);
    for (const PassingOrder::Wait &wait : fine.getWaits())
    {
        EXPECT_EQ(wait.robot, 1U);
        EXPECT_NEAR(static_cast<double>(wait.stage - wait.otherStage), 3.0, 1.0);
    }
}

TEST_F(CrossingDiscs, NeedAPathOfTheirOwn)
{
    const og::PathGeometric path = planned_.through(rows_);
    const auto complain = [&](const og::PathGeometric &each, double step)
    { EXPECT_THROW(PassingOrder(each, planned_.checker, step), ompl::Exception) << step; };
    for (const double step : {0.0, -1.0, 1e-4, std::numeric_limits<double>::quiet_NaN()})
        complain(path, step);
    complain(planned_.through({}), 1.0);
    EXPECT_THROW(PassingOrder(path, nullptr, 1.0), ompl::Exception);
    const Planned others(teamOfDiscs());
    complain(randomPath(others, *std::make_unique<Random>(1), 2), 1.0);

    const PassingOrder one(planned_.through({rows_[0]}), planned_.checker, 1.0);
    EXPECT_EQ(one.getStageCount(), 0U);
    EXPECT_FALSE(one.mayBegin(0, {0, 0}));
}

TEST(PassingOrders, CountMotionsThatTakeNoTime)
{
    // A long box that turns where turns count nothing, and a disc that passes beside it before, and drives on behind.
    const RobotPtr bar = RigidRobot::inSE2("bar", Body::box(10.0, 0.5), cubeBounds(2, 30.0));
    bar->getStateSpace()->as<ob::CompoundStateSpace>()->setSubspaceWeight(1, 0.0);
    const Planned planned(teamOf({bar, RigidRobot::disc("disc", 0.3, cubeBounds(2, 30.0))}));
    const og::PathGeometric path = planned.through({{0.0, 0.0, 0.0, -4.5, 1.0},
                                                    {20.0, 0.0, 0.0, -4.5, 1.0},
                                                    {20.0, 0.0, M_PI / 2.0, -4.5, 1.0},
                                                    {20.0, 0.0, M_PI / 2.0, -4.5, 0.1}});
    for (const double step : {10.0, 5.0, 1.0})
    {
        const PassingOrder order(path, planned.checker, step);
        Random random(1);
        for (unsigned int run = 0; run < 20; ++run)
        {
            const auto fault = Drive(planned, path, order, true).run(random);
            EXPECT_FALSE(fault) << step << ": " << *fault;
        }
        std::vector<std::size_t> ended(2);
        while (order.mayBegin(1, ended))
            ++ended[1];
        EXPECT_LT(ended[1], order.getStageCount()) << "the disc drives into the bar, which has not left";
    }
}

TEST(PassingOrders, LetAllOfAGroupBegin)
{
    // Three discs behind each other with gaps of 0.2: the first and the last meet through the second. One is far off.
    const auto disc = [](const char *name) { return RigidRobot::disc(name, 0.4, cubeBounds(2, 5.0)); };
    const Planned planned(teamOf({disc("lead"), disc("middle"), disc("tail"), disc("other")}));
    const PassingOrder order(planned.through({{1.0, 0.0, 0.0, 0.0, -1.0, 0.0, -1.0, 1.0},
                                              {1.0, 0.0, 0.0, 0.0, -1.0, 0.0, -1.0, 4.0},
                                              {4.0, 0.0, 3.0, 0.0, 2.0, 0.0, -1.0, 4.0}}),
                             planned.checker, 1.0);
    EXPECT_EQ(order.getGroup(0, 4), (std::vector<unsigned int>{0, 1, 2}));
    EXPECT_EQ(order.getGroup(3, 4), std::vector<unsigned int>{3});
    EXPECT_TRUE(order.mayBegin(0, {4, 4, 4, 4}));
    for (const std::vector<std::size_t> &ended : std::vector<std::vector<std::size_t>>{{4, 4, 3, 4}, {4, 3, 4, 4}})
        EXPECT_FALSE(order.mayBegin(0, ended));
}

TEST_P(PassingOrderTest, KeepsLateRobotsApart)
{
    unsigned int waits = 0, meetings = 0, collisions = 0;
    const unsigned int seeds = scaled(20);
    for (unsigned int seed = 0; seed < seeds; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Planned planned(GetParam() < TEAMS ? anyTeam(GetParam()) : manyRobots());
        const og::PathGeometric path = randomPath(planned, random, 6);
        const PassingOrder order(path, planned.checker, random.uniform(0.2, 2.0));
        waits += static_cast<unsigned int>(order.getWaits().size());
        meetings += static_cast<unsigned int>(order.getMeetings().size());
        for (unsigned int run = 0; run < 3; ++run)
        {
            const auto fault = Drive(planned, path, order, true).run(random);
            ASSERT_FALSE(fault) << *fault;
            collisions += Drive(planned, path, order, false).run(random) ? 1 : 0;
        }
    }
    std::cout << waits << " waits, " << meetings << " meetings, " << collisions << " of " << 3 * seeds
              << " collide if nobody waits" << std::endl;
    EXPECT_GT(waits, 0U);
    if (seeds >= 10)
    {
        EXPECT_GT(collisions, 0U);
    }
}

INSTANTIATE_TEST_SUITE_P(Teams, PassingOrderTest, testing::Range(0U, TEAMS + 1));
