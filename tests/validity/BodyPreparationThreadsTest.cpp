#include "support/RandomMeshes.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/robots/RigidRobot.h"

#include <gtest/gtest.h>
#include <thread>
#include <vector>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** Robots of meshes that take milliseconds to prepare, some of which share a mesh */
    std::shared_ptr<TeamStateSpace> teamOfMeshes()
    {
        auto team = std::make_shared<TeamStateSpace>();
        ob::RealVectorBounds bounds(3);
        bounds.setLow(-3.0);
        bounds.setHigh(3.0);
        const TriangleMeshPtr shared = ballMesh(30, 0.5);
        for (unsigned int i = 0; i < 6; ++i)
            team->addRobot(RigidRobot::inSE3("ball" + std::to_string(i),
                                             Body::mesh(i % 2 == 0 ? shared : ballMesh(20 + i, 0.5)), bounds));
        return team;
    }

    TeamSetupPtr setupFor(const std::shared_ptr<TeamStateSpace> &team, Method method)
    {
        const std::vector<PlacedBody> walls{{Body::box(0.5, 0.5, 6.0), Pose::Identity()}};
        return std::make_shared<TeamSetup>(team, std::make_shared<FclObstacles>(walls, 3), method);
    }
}

/** Two checkers of one team are made at once, each by threads of its own. */
TEST(BodyPreparationThreads, ChangeNoVerdict)
{
    const auto team = teamOfMeshes();
    std::vector<TeamSetupPtr> setups(2);
    std::vector<std::thread> threads;
    for (TeamSetupPtr &setup : setups)
        threads.emplace_back([&] { setup = setupFor(team, Method::SHARED_PROJECTION); });
    for (std::thread &thread : threads)
        thread.join();
    const TeamSetupPtr fcl = setupFor(team, Method::FCL);
    ob::ScopedState<> state(team);
    unsigned int free = 0;
    constexpr unsigned int states = 300;
    for (unsigned int i = 0; i < states; ++i)
    {
        state.random();
        const bool expected = fcl->getTeamChecker()->isValid(state.get());
        free += expected ? 1 : 0;
        for (const TeamSetupPtr &setup : setups)
            ASSERT_EQ(setup->getTeamChecker()->isValid(state.get()), expected) << state;
    }
    EXPECT_GT(free, 0U);
    EXPECT_LT(free, states);
}
