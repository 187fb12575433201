#include "planning/RoadmapPathCheck.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/team/TeamPathLength.h"
#include "planning/ProductTree.h"
#include "support/Quiet.h"
#include "support/Teams.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

// Two discs meet head-on, and a third one moves far from them.
TEST(RoadmapPathCheck, RefutesThePairThatCollidesAndNoRobotAlone)
{
    const Quiet quiet;
    const auto team = std::make_shared<TeamStateSpace>();
    for (const char *name : {"left", "right", "far"})
        team->addRobot(RigidRobot::disc(name, 0.5, cubeBounds(2, 10.0)));
    TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2));
    const ob::SpaceInformationPtr &si = setup.getSpaceInformation();
    si->setup();
    const auto *validator = dynamic_cast<const CertificateMotionValidator *>(si->getMotionValidator().get());
    ASSERT_NE(validator, nullptr);
    TeamRoadmaps roadmaps(*validator, false, 1);
    ProductTree tree(si, std::make_shared<TeamPathLength>(si), roadmaps);
    RoadmapPathCheck check(si, *setup.getTeamChecker(), roadmaps, tree);
    ob::ScopedState<> start(team), end(team);
    start = std::vector<double>{0.0, 0.0, 2.0, 0.0, 0.0, 9.0};
    end = std::vector<double>{2.0, 0.0, 0.0, 0.0, 2.0, 9.0};
    TeamRoadmaps::Path path{roadmaps.add(start.get()), roadmaps.add(end.get())};
    const TeamRoadmaps::Path whole = path;

    EXPECT_FALSE(check.confirm(path));
    EXPECT_EQ(path.size(), 1U);
    EXPECT_EQ(roadmaps.getRememberedPairMotions(), 1U);
    EXPECT_EQ(roadmaps.countBlocked(), 0U);
    EXPECT_FALSE(roadmaps.isStepFree(whole[0], whole[1]));
}
