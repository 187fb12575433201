#include "support/Checkers.h"
#include "support/Message.h"
#include "support/RandomClouds.h"

#include "ompl_certificates/control/Integrator.h"
#include "ompl_certificates/control/TeamControlSetup.h"
#include "ompl_certificates/obstacles/MixedObstacles.h"
#include "ompl_certificates/obstacles/ObstacleSet.h"
#include "ompl_certificates/obstacles/PointCloudSet.h"
#include "ompl_certificates/validity/Revalidation.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <ompl/control/PlannerData.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace oc = ompl::control;
namespace og = ompl::geometric;

namespace
{
    class Revalidating : public testing::TestWithParam<unsigned int>
    {
    protected:
        void SetUp() override
        {
            ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        }
    };

    /** A tree of random motions, all valid: each grows from an earlier state */
    void growTree(Random &random, const TeamSetup &setup, ob::PlannerData &data, std::vector<ob::ScopedState<>> &states)
    {
        const auto &si = setup.getSpaceInformation();
        while (states.empty())
        {
            states.push_back(randomState(random, si->getStateSpace()));
            if (!si->isValid(states.back().get()))
                states.clear();
        }
        for (int i = 0; i < 400; ++i)
        {
            const std::size_t from = random.below(states.size());
            ob::ScopedState<> to = randomStateNear(random, states[from], random.uniform(0.0, 0.4));
            if (si->checkMotion(states[from].get(), to.get()))
                states.push_back(to);
        }
        for (const auto &state : states)
            data.addVertex(ob::PlannerDataVertex(state.get()));
        for (unsigned int i = 0; i + 1 < states.size(); ++i)
            for (unsigned int k = 0; k < 3; ++k)
                if (const unsigned int j = random.below(states.size());
                    j != i && si->checkMotion(states[i].get(), states[j].get()))
                    data.addEdge(i, j);
    }

    /** What a new check of everything finds */
    Revalidation::Invalid checkAll(const ob::SpaceInformation &si, const ob::PlannerData &data)
    {
        Revalidation::Invalid invalid;
        std::vector<unsigned int> ends;
        for (unsigned int i = 0; i < data.numVertices(); ++i)
        {
            const bool isValid = si.isValid(data.getVertex(i).getState());
            if (!isValid)
                invalid.vertices.push_back(i);
            data.getEdges(i, ends);
            std::sort(ends.begin(), ends.end());
            for (const unsigned int end : ends)
                if (!isValid || !si.checkMotion(data.getVertex(i).getState(), data.getVertex(end).getState()))
                    invalid.edges.emplace_back(i, end);
        }
        return invalid;
    }
}

TEST_P(Revalidating, FindsWhatANewCheckFinds)
{
    std::size_t invalidVertices = 0, invalidEdges = 0, validEdges = 0;
    for (unsigned int seed = 1; seed <= std::max(scaled(8), 2U); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const TeamStateSpacePtr team = anyTeam(GetParam());
        const unsigned int dimension = team->getWorkspaceDimension();
        ObstacleSet set(dimension, team->getZInterval());
        std::vector<ObstacleSet::Id> there;
        const auto addOne = [&] {
            there.push_back(set.add({randomBody(random, dimension, 0.8), random.pose(dimension, HALF)}));
        };
        for (int i = 0; i < 5; ++i)
            addOne();
        TeamSetup setup(team, set.takeChange().after);
        setup.getSpaceInformation()->setup();
        ob::PlannerData data(setup.getSpaceInformation());
        std::vector<ob::ScopedState<>> states;
        growTree(random, setup, data, states);
        ASSERT_GT(data.numEdges(), 10U);
        for (int round = 0; round < 3; ++round)
        {
            set.remove(there[static_cast<std::size_t>(round)]);
            if (round > 0)
                addOne();
            const ObstacleChange change = set.takeChange();
            const Revalidation revalidation(*setup.getTeamChecker(), change);
            const Revalidation::Invalid found = revalidation.findInvalid(data);
            TeamSetup fresh(team, change.after, Method::FCL);
            fresh.getSpaceInformation()->setup();
            const Revalidation::Invalid expected = checkAll(*fresh.getSpaceInformation(), data);
            ASSERT_EQ(found.vertices, expected.vertices);
            ASSERT_EQ(found.edges, expected.edges);
            invalidVertices += found.vertices.size();
            invalidEdges += found.edges.size();
            validEdges += data.numEdges() - found.edges.size();
            // Later rounds begin with what is still valid.
            for (const auto &[from, to] : found.edges)
                data.removeEdge(from, to);
            for (auto vertex = found.vertices.rbegin(); vertex != found.vertices.rend(); ++vertex)
                data.removeVertex(*vertex);
        }
    }
    EXPECT_GT(invalidVertices, 0U);
    EXPECT_GT(invalidEdges, 10U);
    EXPECT_GT(validEdges, 50U);
}

INSTANTIATE_TEST_SUITE_P(Teams, Revalidating, testing::Range(0U, 3U));

TEST_F(Revalidating, ItsCheckerStillKnowsPairsOfRobots)
{
    const TeamStateSpacePtr team = anyTeam(0);
    ASSERT_GT(team->getRobotCount(), 1U);
    ObstacleSet set(team->getWorkspaceDimension(), team->getZInterval());
    TeamSetup setup(team, set.takeChange().after);
    set.add({team->getWorkspaceDimension() == 2 ? Body::box(0.1, 0.1) : Body::box(0.1, 0.1, 0.1),
             Pose(Eigen::Translation3d(100.0, 0.0, 0.0))});
    const Revalidation revalidation(*setup.getTeamChecker(), set.takeChange());
    const TeamValidityChecker &checker = *revalidation.getChecker();
    Random random(1);
    std::array<unsigned int, 2> verdicts{};
    for (int i = 0; i < 300; ++i)
    {
        const ob::ScopedState<> state = randomState(random, team);
        const auto *const *parts = state.get()->as<ob::CompoundState>()->components;
        const bool free = checker.isPairFree(0, parts[0], 1, parts[1]);
        EXPECT_EQ(free, setup.getTeamChecker()->isPairFree(0, parts[0], 1, parts[1]));
        ++verdicts[free];
        // Of the team's state, only the obstacles matter.
        EXPECT_TRUE(checker.isValid(state.get()));
        EXPECT_GT(checker.clearance(state.get()), 0.0);
        EXPECT_EQ(checker.describeCollision(state.get()), "");
    }
    EXPECT_GT(verdicts[0], 0U);
    EXPECT_GT(verdicts[1], 0U);
}

TEST_F(Revalidating, FindsTheMotionsOfAPathThatMeetNewPoints)
{
    Random random(1);
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::inSE3("drone", Body::box(0.5, 0.5, 0.2), cubeBounds(3, HALF)));
    PointCloudSet set(0.05);
    set.insert(randomPoints(random, 3, 300, HALF));
    TeamSetup setup(team, set.takeChange().after);
    setup.getSpaceInformation()->setup();
    const auto &si = setup.getSpaceInformation();
    og::PathGeometric path(si);
    ob::ScopedState<> at(team);
    do
        at = randomState(random, team);
    while (!si->isValid(at.get()));
    path.append(at.get());
    while (path.getStateCount() < 200)
    {
        const ob::ScopedState<> to = randomStateNear(random, at, 0.2);
        if (!si->checkMotion(at.get(), to.get()))
            continue;
        path.append(to.get());
        at = to;
    }
    const auto reference = [&](std::size_t i)
    { return path.getState(static_cast<unsigned int>(i))->as<TeamStateSpace::StateType>()->getReference(0); };
    std::vector<TeamStateSpace::Reference> references;
    for (std::size_t i = 0; i < path.getStateCount(); ++i)
        references.push_back(reference(i));
    std::size_t invalid = 0;
    for (int round = 0; round < 10; ++round)
    {
        set.insert(randomPoints(random, 3, 4, HALF));
        const ObstacleChange change = set.takeChange();
        const Revalidation revalidation(*setup.getTeamChecker(), change);
        TeamSetup fresh(team, change.added, Method::STANDARD);
        fresh.getSpaceInformation()->setup();
        std::vector<std::size_t> expected;
        for (unsigned int i = 0; i + 1 < path.getStateCount(); ++i)
            if (!fresh.getSpaceInformation()->isValid(path.getState(i)) ||
                !fresh.getSpaceInformation()->checkMotion(path.getState(i), path.getState(i + 1)))
                expected.push_back(i);
        ASSERT_EQ(revalidation.findInvalidEdges(path), expected);
        invalid += expected.size();
        // What is proved free of the new points is not checked otherwise.
        const auto counts = revalidation.getChecker()->getStatistics().getCounts();
        EXPECT_LT(5 * (counts.exactCalls + counts.contactTests), counts.motions);
    }
    EXPECT_GT(invalid, 5U);
    // The certificates of the other checker are still at hand.
    for (std::size_t i = 0; i < path.getStateCount(); ++i)
        EXPECT_EQ(reference(i), references[i]);
}

/** No sample of the motion meets the new box but its start. */
TEST_F(Revalidating, FindsMotionsThatStartInANewObstacle)
{
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::disc("disc", 0.1, cubeBounds(2, HALF)));
    ObstacleSet set(2);
    TeamSetup setup(team, set.takeChange().after);
    setup.getSpaceInformation()->setStateValidityCheckingResolution(0.5);
    setup.getSpaceInformation()->setup();
    ob::ScopedState<> from(team), to(team);
    from = std::vector<double>{0.0, 0.0};
    to = std::vector<double>{0.3, 0.0};
    set.add({Body::box(0.05, 0.05), planarPose(0.0, 0.0)});
    const Revalidation revalidation(*setup.getTeamChecker(), set.takeChange(), CertificateMotionValidator::DISCRETE);
    EXPECT_FALSE(revalidation.staysValid(from.get(), to.get()));
    EXPECT_FALSE(revalidation.staysValid(to.get(), from.get()));
    EXPECT_TRUE(revalidation.staysValid(to.get(), to.get()));
}

TEST_F(Revalidating, KeepsToTheContinuousMode)
{
    // A thin new wall that hides between two samples
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::disc("disc", 0.01, cubeBounds(2, HALF)));
    ObstacleSet set(2);
    TeamSetup setup(team, set.takeChange().after);
    setup.getSpaceInformation()->setStateValidityCheckingResolution(0.1);
    setup.getSpaceInformation()->setup();
    ob::ScopedState<> from(team), to(team);
    from = std::vector<double>{-1.0, 0.0};
    to = std::vector<double>{1.0, 0.0};
    set.add({Body::box(0.01, 5.0), planarPose(0.1, 0.0, 0.0)});
    const ObstacleChange change = set.takeChange();
    EXPECT_TRUE(Revalidation(*setup.getTeamChecker(), change).staysValid(from.get(), to.get()));
    const Revalidation continuous(*setup.getTeamChecker(), change, CertificateMotionValidator::CONTINUOUS);
    EXPECT_FALSE(continuous.staysValid(from.get(), to.get()));
    EXPECT_TRUE(continuous.staysValid(from.get()));
    // The mode of the setup, if none is given
    setup.getSpaceInformation()->setMotionValidator(
        std::make_shared<CertificateMotionValidator>(setup.getTeamChecker(), CertificateMotionValidator::CONTINUOUS));
    EXPECT_FALSE(Revalidation(*setup.getTeamChecker(), change).staysValid(from.get(), to.get()));
    to = std::vector<double>{-1.0, 1.0};
    EXPECT_TRUE(continuous.staysValid(from.get(), to.get()));
}

TEST_F(Revalidating, ProvesStepsOfControlsInContinuousMode)
{
    // A fast disc jumps over a thin new wall in one step, and then moves on beside it.
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(Integrator::firstOrder(RigidRobot::disc("disc", 0.05, cubeBounds(2, HALF)), cubeBounds(2, HALF)));
    const auto continuous = CertificateMotionValidator::CONTINUOUS;
    for (const auto mode : {CertificateMotionValidator::DISCRETE, continuous})
    {
        ObstacleSet set(2);
        TeamControlSetup setup(team, set.takeChange().after, Method::SHARED_PROJECTION, mode);
        const auto &si = setup.getSpaceInformation();
        si->setup();
        oc::PathControl path(si);
        ob::ScopedState<> at(team);
        oc::Control *control = si->allocControl();
        at = std::vector<double>{-0.25, 0.0};
        path.append(at.get());
        for (const double y : {0.0, 2.0})
        {
            auto *values = control->as<oc::RealVectorControlSpace::ControlType>()->values;
            values[0] = y > 0.0 ? 0.0 : 5.0;
            values[1] = y;
            at = std::vector<double>{0.25, 0.1 * y};
            path.append(at.get(), control, si->getPropagationStepSize());
        }
        si->freeControl(control);
        ASSERT_TRUE(path.check());

        set.add({Body::box(0.02, 2.0), planarPose(0.0, 0.0)});
        const ObstacleChange change = set.takeChange();
        const auto &propagator = static_cast<const TeamPropagator &>(*si->getStatePropagator());
        const auto isStepFree =
            [&](const TeamValidityChecker &added, const ob::State *from, const oc::Control *held, double duration)
        { return propagator.isStepFree(added, from, held, duration, from); };
        const auto findInvalid = [&]
        { return Revalidation(*setup.getTeamChecker(), change, continuous, isStepFree).findInvalidEdges(path); };
        EXPECT_EQ(findInvalid(), std::vector<std::size_t>{0});
        if (mode != continuous)
        {
            EXPECT_TRUE(Revalidation(*setup.getTeamChecker(), change).findInvalidEdges(path).empty());
        }
        EXPECT_NE(messageOf([&] { Revalidation(*setup.getTeamChecker(), change, continuous).findInvalidEdges(path); })
                      .find("need a proof"),
                  std::string::npos);
        setup.getTeamChecker()->changeObstacles(change);
        EXPECT_EQ(findInvalid(), std::vector<std::size_t>{0});
        // A control that is held for less than a step is one.
        si->setPropagationStepSize(0.25);
        EXPECT_EQ(findInvalid(), std::vector<std::size_t>{0});
    }
}

TEST_F(Revalidating, RefusesObstaclesThatDoNotFit)
{
    TeamSetup setup(teamOfDiscs(), std::make_shared<FclObstacles>(std::vector<PlacedBody>(), 2U));
    const auto inSpace = std::make_shared<FclObstacles>(std::vector<PlacedBody>(), 3U);
    EXPECT_THROW(Revalidation(*setup.getTeamChecker(), {inSpace, inSpace, {}}), ompl::Exception);
}

/** A checker that is kept for many queries outlives their space information. */
TEST_F(Revalidating, NeedsAModeWhereTheSpaceInformationIsGone)
{
    ObstacleSet set(2);
    auto setup = std::make_unique<TeamSetup>(teamOfDiscs(), set.takeChange().after);
    setup->getSpaceInformation()->setup();
    const auto checker = setup->getTeamChecker();
    ob::ScopedState<> state(checker->getTeam().getStateSpace());
    state = std::vector<double>(state.reals().size(), 1.0);
    setup.reset();
    ASSERT_TRUE(checker->watchSpaceInformation().expired());
    set.add({Body::box(1.0, 1.0), planarPose(1.0, 1.0)});
    const ObstacleChange change = set.takeChange();
    checker->changeObstacles(change);
    EXPECT_EQ(messageOf([&] { Revalidation(*checker, change); }),
              "Revalidation: the checker's space information is gone; give the mode to the constructor");
    const Revalidation revalidation(*checker, change, CertificateMotionValidator::DISCRETE);
    EXPECT_FALSE(revalidation.staysValid(state.get()));
}

TEST_F(Revalidating, NeedsAChangeThatNamesWhatWasAdded)
{
    ObstacleSet set(2);
    const ObstaclesPtr before = set.takeChange().after;
    TeamSetup setup(teamOfDiscs(), before);
    EXPECT_EQ(Revalidation(*setup.getTeamChecker(), set.takeChange()).getChecker(), nullptr) << "nothing has changed";
    EXPECT_EQ(Revalidation(*setup.getTeamChecker(), mixedChange({set.takeChange()})).getChecker(), nullptr);
    const ObstaclesPtr after =
        std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(1.0, 1.0), Pose::Identity()}}, 2U);
    for (const ObstacleChange &change : {ObstacleChange{}, ObstacleChange{after, nullptr, nullptr}})
        EXPECT_NE(messageOf([&] { Revalidation(*setup.getTeamChecker(), change); }).find("must name what was added"),
                  std::string::npos);
    EXPECT_NE(Revalidation(*setup.getTeamChecker(), ObstacleChange::replacing(before, after)).getChecker(), nullptr);
}

TEST_F(Revalidating, SeesObstaclesThatAreOthersThoughNobodyNamesThem)
{
    const auto boxesAt = [](const std::vector<double> &places) -> ObstaclesPtr
    {
        std::vector<PlacedBody> bodies;
        for (const double x : places)
            bodies.push_back({Body::box(1.0, 1.0), planarPose(x, 0.0)});
        return std::make_shared<FclObstacles>(bodies, 2U);
    };
    const ObstaclesPtr box = boxesAt({3.0}), moved = boxesAt({0.0}), other = boxesAt({-3.0}),
                       more = boxesAt({-3.0, -2.0});
    const ObstaclesPtr mixed = std::make_shared<MixedObstacles>(std::vector<ObstaclesPtr>{box, other});
    const ObstacleChange unnamed{moved, nullptr, nullptr}, withBefore{moved, nullptr, nullptr, {}, box},
        same{other, nullptr, nullptr}, added{more, boxesAt({-2.0}), nullptr};
    const std::pair<ObstaclesPtr, ObstacleChange> changes[] = {{box, withBefore},
                                                               {mixed, mixedChange({unnamed, same})},
                                                               {mixed, mixedChange({withBefore, same})},
                                                               {mixed, mixedChange({unnamed, added})}};
    for (const auto &[before, change] : changes)
    {
        const auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(RigidRobot::disc("disc", 0.3, cubeBounds(2, HALF)));
        TeamSetup setup(team, before);
        setup.getSpaceInformation()->setup();
        ob::ScopedState<> onto(team), beside(team);
        onto = std::vector<double>{0.0, 0.0};
        beside = std::vector<double>{0.0, 2.0};
        ASSERT_TRUE(setup.getTeamChecker()->isValid(onto.get()));
        setup.getTeamChecker()->changeObstacles(change);
        ASSERT_FALSE(setup.getTeamChecker()->isValid(onto.get()));
        const Revalidation revalidation(*setup.getTeamChecker(), change);
        EXPECT_FALSE(revalidation.staysValid(onto.get()));
        EXPECT_TRUE(revalidation.staysValid(beside.get()));
    }
}

TEST_F(Revalidating, NeedsTheControlsOfAPlannerThatHasThem)
{
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(Integrator::firstOrder(RigidRobot::disc("disc", 0.05, cubeBounds(2, HALF)), cubeBounds(2, HALF)));
    ObstacleSet set(2);
    TeamControlSetup setup(team, set.takeChange().after);
    set.add({Body::box(0.02, 2.0), planarPose(0.0, 0.0)});
    const Revalidation revalidation(*setup.getTeamChecker(), set.takeChange());
    const ob::PlannerData without(setup.getSpaceInformation());
    EXPECT_NE(messageOf([&] { revalidation.findInvalid(without); }).find("ompl::control::PlannerData"),
              std::string::npos);
    EXPECT_NO_THROW(revalidation.findInvalid(oc::PlannerData(setup.getSpaceInformation())));
}
