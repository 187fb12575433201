#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/planning/TeamSetup.h"

#include "support/Chain.h"
#include "support/Random.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** A chain of small boxes, each \e step after the one before, which turn about axes at random */
    std::shared_ptr<const Chain> boxes(unsigned int seed, std::size_t count, double step)
    {
        Random random(seed);
        std::vector<Chain::Link> links;
        for (std::size_t i = 0; i < count; ++i)
            links.push_back({Body::box(0.2, 0.1, 0.1), poseAt({step, 0.0, 0.0}), random.direction(3), 0.0});
        return std::make_shared<Chain>("chain", links, pairsApart(count));
    }

    void makeChecker(const RobotPtr &robot, Method method)
    {
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(robot);
        const TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 3), method);
        EXPECT_TRUE(setup.getTeamChecker());
    }

    /** How many cells of the first two levels are unknown, of all pairs */
    std::size_t countNew(const Robot &robot)
    {
        std::size_t count = 0;
        for (std::size_t pair = 0; pair < robot.getBodyPairs().size(); ++pair)
            if (const auto cells = robot.getJointCells(pair))
                for (const unsigned int level : {0U, 1U})
                    for (const JointCells::Values &values : cells->getMiddles(level))
                    {
                        const JointCells::Cell cell = cells->find(values);
                        count += cell.level <= level && cell.answer == JointCells::Answer::UNKNOWN ? 1 : 0;
                    }
        return count;
    }
}

TEST(LargeJointCells, AreSettledWhenTheFirstCheckerIsMade)
{
    for (unsigned int seed = 1; seed <= 5; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const auto robot = boxes(seed, 5, 0.3);
        const std::size_t all = countNew(*robot);
        EXPECT_GT(all, 3 * 2048U);
        for (const Method method : {Method::FCL, Method::STANDARD})
            makeChecker(robot, method);
        EXPECT_EQ(countNew(*robot), all) << "Methods without certificates have no use for them";
        makeChecker(robot, Method::PARTIAL);
        EXPECT_EQ(countNew(*robot), 0U);
    }
}

TEST(LargeJointCells, OfManyPairsAreSettledByOneCheckerAfterTheOther)
{
    // So near each other that few larger cells settle their parts
    const auto robot = boxes(1, 25, 0.05);
    std::size_t left = countNew(*robot), checkers = 0;
    EXPECT_GT(left, 3 * 16384U);
    while (left > 0 && checkers < 10)
    {
        makeChecker(robot, Method::SHARED_PROJECTION);
        ++checkers;
        const std::size_t now = countNew(*robot);
        EXPECT_LT(now, left);
        if (checkers == 1)
        {
            EXPECT_GT(now, 16384U);
        }
        left = now;
    }
    EXPECT_EQ(left, 0U);
    EXPECT_GT(checkers, 2U);
}
