#include "support/Message.h"
#include "support/Quiet.h"
#include "support/Teams.h"
#include "support/Warnings.h"

#include "ompl_certificates/planning/DRRTstar.h"
#include "ompl_certificates/planning/Planners.h"
#include "ompl_certificates/planning/ProvePath.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/validity/SharedProjection.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/spaces/SE2StateSpace.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    using Mode = CertificateMotionValidator::Mode;
}

/** A robot grasps something: a program sets a checker for its new shape, and leaves the motion validator. */
TEST(FurtherCheckers, AreThoseOfOtherRobotsToo)
{
    const Quiet quiet;
    for (const Mode mode : {CertificateMotionValidator::DISCRETE, CertificateMotionValidator::CONTINUOUS})
    {
        const auto space = std::make_shared<ob::SE2StateSpace>();
        space->setBounds(cubeBounds(2, 4.0));
        const auto gap =
            std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(0.5, 3.0), planarPose(0.0, 2.0)},
                                                                   {Body::box(0.5, 3.0), planarPose(0.0, -2.0)}},
                                           2);
        const auto si = std::make_shared<ob::SpaceInformation>(space);
        const auto checkerFor = [&](double width)
        {
            const RobotPtr robot = RigidRobot::inSE2("held", Body::box(0.5, width), cubeBounds(2, 4.0));
            return std::make_shared<SharedProjection>(si, gap, std::vector<RobotPtr>{robot});
        };
        const auto small = checkerFor(0.5), large = checkerFor(1.5);
        const auto validator = std::make_shared<CertificateMotionValidator>(small, mode);
        si->setStateValidityChecker(small);
        si->setMotionValidator(validator);
        si->setup();
        ob::ScopedState<> from(si), to(si);
        from = std::vector<double>{-2.0, 0.0, 0.0};
        to = std::vector<double>{2.0, 0.0, 0.0};
        EXPECT_TRUE(si->checkMotion(from.get(), to.get()));
        si->setStateValidityChecker(large);
        EXPECT_EQ(validator->getFurtherChecker(), large.get());
        EXPECT_FALSE(si->checkMotion(from.get(), to.get()));
    }
}

/** One checker is kept for many queries, each with a SimpleSetup of its own, which ends before the checker does. */
TEST(FurtherCheckers, AreThoseOfALaterQuery)
{
    const Quiet quiet;
    const auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::disc("disc", 0.2, cubeBounds(2, 4.0)));
    const auto open = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2);
    auto si = std::make_shared<ob::SpaceInformation>(team);
    const auto checker = std::make_shared<SharedProjection>(si, open);
    const auto old = std::make_shared<CertificateMotionValidator>(checker);
    si->setStateValidityChecker(checker);
    si->setup();
    ob::ScopedState<> from(team), to(team);
    from = std::vector<double>{-2.0, 0.0};
    to = std::vector<double>{2.0, 0.0};
    EXPECT_EQ(old->getFurtherChecker(), nullptr);
    si.reset();
    EXPECT_TRUE(checker->watchSpaceInformation().expired());
    {
        const Warnings warnings("is gone");
        for (int i = 0; i < 3; ++i)
            EXPECT_TRUE(old->checkMotion(from.get(), to.get()));
        EXPECT_EQ(old->getFurtherChecker(), nullptr);
        EXPECT_EQ(warnings.count, 1U);
    }
    EXPECT_TRUE(
        CertificateMotionValidator(checker, CertificateMotionValidator::CONTINUOUS).checkMotion(from.get(), to.get()));

    const auto next = std::make_shared<ob::SpaceInformation>(team);
    const auto validator = std::make_shared<CertificateMotionValidator>(next, checker);
    next->setMotionValidator(validator);
    next->setStateValidityChecker(checker);
    next->setup();
    {
        const Warnings warnings("is gone");
        EXPECT_EQ(validator->getFurtherChecker(), nullptr);
        EXPECT_TRUE(next->checkMotion(from.get(), to.get()));
        EXPECT_EQ(warnings.count, 0U);
    }
    next->setStateValidityChecker(
        [](const ob::State *state) {
            return std::abs(state->as<ob::CompoundState>()->as<ob::RealVectorStateSpace::StateType>(0)->values[0]) >
                   0.5;
        });
    EXPECT_NE(validator->getFurtherChecker(), nullptr);
    EXPECT_FALSE(next->checkMotion(from.get(), to.get()));

    const auto otherTeam = std::make_shared<TeamStateSpace>();
    otherTeam->addRobot(RigidRobot::disc("disc", 0.2, cubeBounds(2, 4.0)));
    EXPECT_NE(messageOf([&] { CertificateMotionValidator(std::make_shared<ob::SpaceInformation>(otherTeam), checker); })
                  .find("is not the space of the validity checker"),
              std::string::npos);
    EXPECT_NE(messageOf([&] { CertificateMotionValidator(nullptr, checker); }).find("needs space information"),
              std::string::npos);
}

/** A program sets another checker of this library, as for another world, and leaves the motion validator. */
TEST(FurtherCheckers, AreThoseOfOtherObstaclesToo)
{
    const Quiet quiet;
    for (const Mode mode : {CertificateMotionValidator::DISCRETE, CertificateMotionValidator::CONTINUOUS})
    {
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(RigidRobot::disc("disc", 0.2, cubeBounds(2, 4.0)));
        const auto open = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2);
        const auto wall = std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(0.5, 2.0)}}, 2);
        TeamSetup setup(team, open, Method::SHARED_PROJECTION, mode);
        const ob::SpaceInformationPtr &si = setup.getSpaceInformation();
        si->setup();
        const auto &validator = dynamic_cast<const CertificateMotionValidator &>(*si->getMotionValidator());
        ob::ScopedState<> from(team), to(team);
        from = std::vector<double>{-2.0, 0.0};
        to = std::vector<double>{2.0, 0.0};
        EXPECT_TRUE(si->checkMotion(from.get(), to.get()));
        setup.setStateValidityChecker(std::make_shared<SharedProjection>(si, open));
        EXPECT_EQ(validator.getFurtherChecker(), nullptr);
        EXPECT_TRUE(si->checkMotion(from.get(), to.get()));
        const auto own = setup.getTeamChecker();
        const auto walled = std::make_shared<SharedProjection>(si, wall);
        setup.setStateValidityChecker(walled);
        EXPECT_EQ(setup.getTeamChecker(), walled) << "changes of obstacles go to the checker that is asked";
        EXPECT_EQ(validator.getFurtherChecker(), walled.get());
        EXPECT_FALSE(si->checkMotion(from.get(), to.get()));
        // A proof is about the world of its checker.
        EXPECT_EQ(CertificateMotionValidator(own, mode).getFurtherChecker(), nullptr);
        og::PathGeometric straight(si, from.get(), to.get());
        EXPECT_TRUE(provePath(straight, own).isProved());
        EXPECT_FALSE(provePath(straight, walled).isProved());
        setup.setStartAndGoalStates(from, to);
        setup.setPlanner(std::make_shared<DRRTstar>(si));
        EXPECT_NE(messageOf([&] { setup.solve(1.0); }).find("another validity checker"), std::string::npos);
        setup.setPlanner(nullptr);
        ASSERT_EQ(setup.solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
        og::PathGeometric path = setup.getSolutionPath();
        EXPECT_TRUE(path.check());
        EXPECT_GE(path.getStateCount(), 3U);
        walled->changeObstacles(ObstacleChange::replacing(wall, open));
        EXPECT_EQ(validator.getFurtherChecker(), nullptr);
    }
}

/** An aisle is closed by a rule between two plans, and opened again. */
TEST(FurtherCheckers, LetATeamChooseItsPlannerAnew)
{
    const Quiet quiet;
    auto team = std::make_shared<TeamStateSpace>();
    for (const char *name : {"a", "b"})
        team->addRobot(RigidRobot::disc(name, 0.2, cubeBounds(2, 4.0)));
    TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2));
    ob::ScopedState<> from(team), to(team);
    from = std::vector<double>{-2.0, 0.5, 2.0, -0.5};
    to = std::vector<double>{2.0, 0.5, -2.0, -0.5};
    setup.setStartAndGoalStates(from, to);
    const auto planWith = [&](const CertificateMotionValidator::Rule &rule)
    {
        setup.clear();
        std::static_pointer_cast<CertificateMotionValidator>(setup.getSpaceInformation()->getMotionValidator())
            ->setRule(rule);
        EXPECT_EQ(setup.solve(ob::PlannerTerminationCondition(
                      [&, tries = 0]() mutable { return ++tries > 20000 || setup.haveExactSolutionPath(); })),
                  ob::PlannerStatus::EXACT_SOLUTION);
        return setup.getPlanner()->getName();
    };
    const auto isWestOrNorth = [](const ob::State *state)
    {
        const double *a = state->as<ob::CompoundState>()->as<ob::RealVectorStateSpace::StateType>(0)->values;
        return std::abs(a[0]) > 0.5 || a[1] > 1.0;
    };
    EXPECT_EQ(planWith(nullptr), "DRRTstar");
    EXPECT_EQ(planWith(isWestOrNorth), "RRTConnect");
    const auto &states = setup.getSolutionPath().getStates();
    EXPECT_TRUE(std::any_of(
        states.begin(), states.end(),
        [](const ob::State *state)
        { return state->as<ob::CompoundState>()->as<ob::RealVectorStateSpace::StateType>(0)->values[1] > 1.0; }));
    EXPECT_EQ(planWith(nullptr), "DRRTstar");
    // The user's own planner stays.
    setup.setPlanner(makePlanner("RRT", setup.getSpaceInformation()));
    EXPECT_EQ(planWith(nullptr), "RRT");
}
