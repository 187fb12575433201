#include "ompl_certificates/pictures/PathFile.h"
#include "ompl_certificates/team/TeamStateSpace.h"
#include "support/Message.h"
#include "support/Teams.h"

#include <gtest/gtest.h>
#include <ompl/base/SpaceInformation.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

TEST(PathFile, HasALineForEachTick)
{
    const auto team = std::make_shared<TeamStateSpace>();
    for (const std::string name : {"fast", "slow"})
        team->addRobot(RigidRobot::disc(name, 0.1, cubeBounds(2, HALF)));
    team->setSpeed(0, 2.0);
    const auto si = std::make_shared<ob::SpaceInformation>(team);
    si->setStateValidityChecker([](const ob::State *) { return true; });
    si->setup();
    ompl::geometric::PathGeometric path(si);
    ob::ScopedState<> state(team);
    for (const std::vector<double> &numbers :
         {std::vector<double>{0, 0, 0, 3}, std::vector<double>{2, 0, 0, 3}, std::vector<double>{2, 0.5, 0, 3}})
    {
        state = numbers;
        path.append(state.get());
    }
    EXPECT_EQ(toCsv(path, 0.5),
              "length,fast.x,fast.y,slow.x,slow.y,time\n"
              "0,0,0,0,3,0\n"
              "1,1,0,0,3,0.5\n"
              "2,2,0,0,3,1\n"
              "2.5,2,0.5,0,3,1.25\n");
    EXPECT_NE(messageOf([&] { toCsv(path, 0.0); }).find("must be positive"), std::string::npos);
    EXPECT_NE(messageOf([&] { toCsv(ompl::geometric::PathGeometric(si), 0.5); }).find("without states"),
              std::string::npos);
}
