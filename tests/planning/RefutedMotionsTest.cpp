#include "planning/TeamRoadmaps.h"
#include "support/RandomStates.h"
#include "support/TeamOf.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/robots/RigidRobot.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

/** Cars drive back along other curves, which may leave the balls around the way there. So what these say of two motions
    counts no more once the check of a path has found that the cars touch. */
TEST(RefutedMotions, AreNoLongerApartByTheBallsAroundThem)
{
    const auto car = [](const std::string &name)
    { return RigidRobot::inReedsShepp(name, Body::box(0.4, 0.2), 0.5, cubeBounds(2, 10.0)); };
    const auto team = teamOf({car("left"), car("right")});
    const TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2));
    setup.getSpaceInformation()->setup();
    const auto *validator =
        dynamic_cast<CertificateMotionValidator *>(setup.getSpaceInformation()->getMotionValidator().get());
    ASSERT_NE(validator, nullptr);
    TeamRoadmaps roadmaps(*validator, false, 1);
    ob::ScopedState<> start(team), end(team), there(team), back(team);
    start = std::vector<double>{-5.0, 0.0, 0.0, 5.0, 0.0, 0.0};
    end = std::vector<double>{-5.0, 1.0, 0.0, 5.0, 1.0, 0.0};
    team->interpolate(start.get(), end.get(), 0.5, there.get());
    team->interpolate(end.get(), start.get(), 0.5, back.get());
    EXPECT_GT(team->distance(there.get(), back.get()), 0.1);
    const auto from = roadmaps.add(start.get()), to = roadmaps.add(end.get());
    const auto areApart = [&](const TeamRoadmaps::Configuration &first, const TeamRoadmaps::Configuration &last)
    {
        const Roadmap::Edge *edges[2];
        for (const unsigned int robot : {0U, 1U})
        {
            edges[robot] = roadmaps.getRoadmap(robot).findEdge(first[robot], last[robot]);
            EXPECT_TRUE(roadmaps.getRoadmap(robot).isFree(first[robot], *edges[robot]));
        }
        return roadmaps.areApart(0, first[0], *edges[0], 1, first[1], *edges[1]);
    };
    EXPECT_TRUE(areApart(from, to));
    EXPECT_TRUE(areApart(to, from));
    roadmaps.refute(0, from[0], to[0], 1, from[1], to[1]);
    EXPECT_FALSE(areApart(from, to));
    EXPECT_FALSE(areApart(to, from));
}
