#include "DynamicProblems.h"

#include "support/ForgivenLeaks.h"
#include "support/IterationLimit.h"
#include "support/Message.h"
#include "support/Quiet.h"
#include "support/Random.h"

#include "ompl_certificates/obstacles/ObstacleSet.h"
#include "ompl_certificates/validity/Revalidation.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/control/PlannerData.h>
#include <ompl/control/planners/est/EST.h>
#include <ompl/control/planners/kpiece/KPIECE1.h>
#include <ompl/control/planners/pdst/PDST.h>
#include <ompl/control/planners/rrt/RRT.h>
#include <ompl/control/planners/sst/SST.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace oc = ompl::control;

namespace
{
    using Mode = CertificateMotionValidator::Mode;

    /** Two second-order unicycles and a car with trailer that pass a wall with gaps */
    TeamControlSetupPtr makeSetup(Method method, Mode mode = CertificateMotionValidator::DISCRETE)
    {
        const auto robots = allKinds();
        std::vector<std::array<double, 4>> list{{0.0, 1.6, 0.2, 2.0}, {0.0, -1.6, 0.2, 2.0}, {-1.5, 1.5, 0.4, 0.4}};
        // So many that certificates are kept
        for (int i = 0; i < 60; ++i)
            list.push_back({-2.9 + 0.1 * i, 2.8, 0.05, 0.05});
        const ObstaclesPtr obstacles = boxes(list);
        auto setup =
            std::make_shared<TeamControlSetup>(teamOf({robots[1], robots[3], robots[5]}), obstacles, method, mode);
        setup->getTeamChecker()->setCertificatesAfter(0);
        ob::ScopedState<> start(setup->getStateSpace()), goal(setup->getStateSpace());
        start = std::vector<double>{-1.5, 0.0, 0.0, 0.0, -1.0, -2.0, 0.0, 0.0, 0.0, 1.5, 0.0, 3.0, 3.0};
        goal = std::vector<double>{1.5, 1.0, 0.0, 0.0, -1.0, 0.7, 0.0, 0.0, 0.0, 1.5, -1.5, 3.0, 3.0};
        setup->setStartAndGoalStates(start, goal, 0.5);
        return setup;
    }

    ob::PlannerPtr makePlanner(const std::string &name, const oc::SpaceInformationPtr &si)
    {
        if (name == "SST")
            return std::make_shared<oc::SST>(si);
        if (name == "EST")
            return std::make_shared<oc::EST>(si);
        if (name == "KPIECE1")
            return std::make_shared<oc::KPIECE1>(si);
        if (name == "PDST")
            return std::make_shared<oc::PDST>(si);
        return std::make_shared<oc::RRT>(si);
    }

    /** The states and edges of the tree that a planner grows */
    std::vector<std::vector<double>> treeOf(TeamControlSetup &setup, const std::string &planner, unsigned int seed,
                                            unsigned int iterations)
    {
        const Quiet quiet;
        ompl::RNG::setSeed(seed);
        setup.setPlanner(makePlanner(planner, setup.getSpaceInformation()));
        setup.setup();
        ob::IterationTerminationCondition limit(iterations);
        {
            // OMPL's SST forgets some of its witnesses.
            const ForgivenLeaks forgiven(planner == "SST");
            setup.solve(limit);
        }
        ob::PlannerData data(setup.getSpaceInformation());
        setup.getPlanner()->getPlannerData(data);
        std::vector<std::vector<double>> tree;
        for (unsigned int i = 0; i < data.numVertices(); ++i)
        {
            tree.emplace_back();
            setup.getStateSpace()->copyToReals(tree.back(), data.getVertex(i).getState());
            std::vector<unsigned int> edges;
            data.getEdges(i, edges);
            tree.back().insert(tree.back().end(), edges.begin(), edges.end());
        }
        return tree;
    }
}

namespace
{
    /** The edges of a tree, from state to state, in an order that does not depend on the structure */
    std::vector<std::vector<double>> edgesOf(const std::vector<std::vector<double>> &tree, std::size_t coordinates)
    {
        const auto begin = [&](std::size_t vertex) { return tree[vertex].begin(); };
        std::vector<std::vector<double>> edges;
        for (std::size_t i = 0; i < tree.size(); ++i)
            for (std::size_t k = coordinates; k < tree[i].size(); ++k)
            {
                const auto end = static_cast<std::size_t>(tree[i][k]);
                edges.emplace_back(begin(i), begin(i) + static_cast<std::ptrdiff_t>(coordinates));
                edges.back().insert(edges.back().end(), begin(end),
                                    begin(end) + static_cast<std::ptrdiff_t>(coordinates));
            }
        std::sort(edges.begin(), edges.end());
        return edges;
    }
}

TEST(ControlTreesTest, AreThoseOfGnat)
{
    constexpr std::size_t coordinates = 13;
    for (const char *planner : {"RRT", "SST"})
        for (unsigned int seed = 1; seed <= scaled(3); ++seed)
        {
            const auto byGnat = makeSetup(Method::STANDARD), byDefault = makeSetup(Method::STANDARD);
            byGnat->setNearestStructure(NearestStructure::GNAT);
            const auto expected = edgesOf(treeOf(*byGnat, planner, seed, 1500), coordinates);
            EXPECT_GT(expected.size(), 50U) << planner;
            EXPECT_TRUE(edgesOf(treeOf(*byDefault, planner, seed, 1500), coordinates) == expected)
                << planner << ", seed " << seed;
            EXPECT_TRUE(useKdTree(*byGnat->getPlanner())) << planner << " had no GNAT to replace";
            EXPECT_FALSE(useKdTree(*byDefault->getPlanner())) << planner << " had a GNAT";
            EXPECT_THROW(byDefault->setNearestStructure(NearestStructure::GNAT), ompl::Exception);
        }
}

TEST(ControlTreesTest, EqualUnderAllMethods)
{
    for (const char *planner : {"RRT", "SST", "KPIECE1", "EST", "PDST"})
        for (unsigned int seed = 1; seed <= scaled(2); ++seed)
        {
            const auto expected = treeOf(*makeSetup(Method::FCL), planner, seed, 1500);
            EXPECT_GT(expected.size(), 50u) << planner;
            for (const Method method : allMethods())
            {
                const auto setup = makeSetup(method);
                setup->getTeamChecker()->setAdaptive(seed % 2 == 0);
                EXPECT_EQ(treeOf(*setup, planner, seed, 1500), expected)
                    << planner << ", " << nameOf(method) << ", seed " << seed;
            }
        }
}

TEST(ControlTreesTest, StayWithinLimits)
{
    const auto setup = makeSetup(Method::SHARED_PROJECTION);
    treeOf(*setup, "RRT", 1, 1500);
    ob::PlannerData data(setup->getSpaceInformation());
    setup->getPlanner()->getPlannerData(data);
    for (unsigned int i = 0; i < data.numVertices(); ++i)
        EXPECT_TRUE(setup->getStateSpace()->satisfiesBounds(data.getVertex(i).getState()));
}

TEST(ControlTreesTest, RevalidationPropagatesEdgesAgain)
{
    ObstacleSet set(2);
    for (int i = 0; i < 60; ++i)
        set.add({Body::box(0.05, 0.05), planarPose(-2.9 + 0.1 * i, 2.8)});
    const auto robots = allKinds();
    TeamControlSetup setup(teamOf({robots[1], robots[3], robots[5]}), set.takeChange().after);
    ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
    start = std::vector<double>{-1.5, 0.0, 0.0, 0.0, -1.0, -2.0, 0.0, 0.0, 0.0, 1.5, 0.0, 3.0, 3.0};
    goal = std::vector<double>{1.5, 1.0, 0.0, 0.0, -1.0, 0.7, 0.0, 0.0, 0.0, 1.5, -1.5, 3.0, 3.0};
    setup.setStartAndGoalStates(start, goal, 0.5);
    treeOf(setup, "RRT", 2, 2000);
    oc::PlannerData controls(setup.getSpaceInformation());
    setup.getPlanner()->getPlannerData(controls);
    ASSERT_GT(controls.numVertices(), 100U);

    for (const double y : {-1.5, 0.3, 1.0})
        set.add({Body::box(0.15, 0.3), planarPose(0.0, y)});
    const ObstacleChange change = set.takeChange();
    setup.getTeamChecker()->changeObstacles(change);
    const Revalidation revalidation(*setup.getTeamChecker(), change);
    const auto found = revalidation.findInvalid(controls);

    const auto &si = setup.getSpaceInformation();
    std::vector<unsigned int> vertices, ends;
    std::vector<std::pair<unsigned int, unsigned int>> edges;
    unsigned int between = 0;
    ob::ScopedState<> state(si->getStateSpace());
    for (unsigned int i = 0; i < controls.numVertices(); ++i)
    {
        const ob::State *from = controls.getVertex(i).getState();
        const bool isValid = setup.getTeamChecker()->isValid(from);
        if (!isValid)
            vertices.push_back(i);
        controls.getEdges(i, ends);
        std::sort(ends.begin(), ends.end());
        for (const unsigned int end : ends)
        {
            const auto &edge = static_cast<const oc::PlannerDataEdgeControl &>(controls.getEdge(i, end));
            const auto steps =
                static_cast<unsigned int>(std::lround(edge.getDuration() / si->getPropagationStepSize()));
            const bool isWayFree =
                si->propagateWhileValid(from, edge.getControl(), static_cast<int>(steps), state.get()) == steps;
            between += isValid && !isWayFree && setup.getTeamChecker()->isValid(controls.getVertex(end).getState());
            if (!isValid || !isWayFree)
                edges.emplace_back(i, end);
        }
    }
    EXPECT_EQ(found.vertices, vertices);
    EXPECT_EQ(found.edges, edges);
    EXPECT_FALSE(vertices.empty());
    EXPECT_GT(between, 0U) << "no edge is invalid between valid ends";

    for (const auto &[from, to] : edges)
    {
        const auto &edge = static_cast<const oc::PlannerDataEdgeControl &>(controls.getEdge(from, to));
        oc::PathControl one(si);
        one.append(controls.getVertex(from).getState());
        one.append(controls.getVertex(to).getState(), edge.getControl(), edge.getDuration());
        EXPECT_EQ(revalidation.findInvalidEdges(one), std::vector<std::size_t>{0});
    }
    const auto withoutControls = std::make_shared<ob::SpaceInformation>(setup.getStateSpace());
    const TeamValidityChecker geometric(withoutControls, change.after, Method::SHARED_PROJECTION);
    EXPECT_NE(messageOf([&] { Revalidation(geometric, change).findInvalid(controls); }).find("controls need a checker"),
              std::string::npos);
}

TEST(ControlTreesTest, ProvenTreesAreEqualUnderAllMethodsWithCertificates)
{
    const auto mode = CertificateMotionValidator::CONTINUOUS;
    for (const char *planner : {"RRT", "SST"})
    {
        const auto expected = treeOf(*makeSetup(Method::SHARED_PROJECTION, mode), planner, 1, 500);
        EXPECT_GT(expected.size(), 50u);
        for (const Method method : {Method::BASIC, Method::PARTIAL})
            EXPECT_EQ(treeOf(*makeSetup(method, mode), planner, 1, 500), expected) << planner << nameOf(method);
    }
}

TEST(TeamPropagatorTest, HandsHintsOn)
{
    const auto setup = makeSetup(Method::SHARED_PROJECTION);
    const auto &si = setup->getSpaceInformation();
    setup->setup();
    ob::ScopedState<TeamStateSpace> from(setup->getStateSpace()), to(setup->getStateSpace());
    si->copyState(from.get(), setup->getProblemDefinition()->getStartState(0));
    oc::Control *control = si->allocControl();
    auto *values = control->as<oc::RealVectorControlSpace::ControlType>()->values;
    std::fill_n(values, 6, 0.1);
    for (std::size_t body = 0; body < 4; ++body)
        from.get()->setReference(body, static_cast<TeamStateSpace::Reference>(7 + body));
    setup->getStatePropagator()->propagate(from.get(), control, 0.1, to.get());
    for (std::size_t body = 0; body < 4; ++body)
        EXPECT_EQ(to.get()->getReference(body), 7 + body);

    // One certificate of each body serves several steps: few are made for many.
    Statistics &statistics = setup->getStatistics();
    setup->getTeamChecker()->setAdaptive(false);
    si->copyState(from.get(), setup->getProblemDefinition()->getStartState(0));
    ASSERT_TRUE(si->isValid(from.get()));
    statistics.reset();
    EXPECT_EQ(si->propagateWhileValid(from.get(), control, 10, to.get()), 10u);
    EXPECT_EQ(statistics.getCounts().robotPoses, 30u);
    EXPECT_GE(statistics.getCounts().certifiedFree, 24u);
    si->freeControl(control);
}

TEST(TeamPropagatorTest, AStepThatIsNotProvedEndsNowhere)
{
    // A wall of 2 mm, and a disc that jumps 1 m in a step
    const auto space = within({3.0, 3.0});
    for (const auto mode : {CertificateMotionValidator::DISCRETE, CertificateMotionValidator::CONTINUOUS})
    {
        TeamControlSetup setup(
            teamOf({Integrator::firstOrder(RigidRobot::disc("disc", 0.1, space), within({10.0, 10.0}))}),
            boxes({{{0.0, 0.0, 0.002, 6.0}}}), Method::SHARED_PROJECTION, mode);
        const auto &si = setup.getSpaceInformation();
        ob::ScopedState<> from(setup.getStateSpace()), to(setup.getStateSpace());
        si->setup();
        from = std::vector<double>{-0.5, 0.0};
        oc::Control *control = si->allocControl();
        auto *values = control->as<oc::RealVectorControlSpace::ControlType>()->values;
        const auto isAccepted = [&](double x, double y)
        {
            values[0] = x;
            values[1] = y;
            return si->propagateWhileValid(from.get(), control, 1, to.get()) == 1;
        };
        EXPECT_EQ(isAccepted(10.0, 0.0), mode == CertificateMotionValidator::DISCRETE);
        EXPECT_TRUE(isAccepted(0.0, 10.0)) << "along the wall";
        EXPECT_TRUE(isAccepted(3.0, 0.0)) << "up to 0.1 m from it";
        EXPECT_TRUE(isAccepted(0.0, 0.0)) << "standing";
        EXPECT_FALSE(isAccepted(4.0, 0.0)) << "into it";
        si->freeControl(control);
    }
}

TEST(TeamPropagatorTest, ProvenPathsNeverCrossThinWalls)
{
    // Steps of 0.1 s at 10 m/s; the walls are thinner than any step, and have one gap each.
    const auto space = within({3.0, 3.0});
    unsigned int solved = 0;
    for (unsigned int seed = 1; seed <= scaled(4); ++seed)
    {
        TeamControlSetup setup(
            teamOf({Integrator::firstOrder(RigidRobot::disc("disc", 0.1, space), within({10.0, 10.0})),
                    Unicycle::firstOrder(RigidRobot::inSE2("box", Body::box(0.5, 0.25), space), within({10.0, 5.0}))}),
            boxes({{{-0.8, -1.0, 0.002, 4.0}, {0.8, 1.0, 0.002, 4.0}}}), Method::SHARED_PROJECTION,
            CertificateMotionValidator::CONTINUOUS);
        const Quiet quiet;
        ompl::RNG::setSeed(seed);
        const auto &si = setup.getSpaceInformation();
        si->setMinMaxControlDuration(1, 3);
        ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
        start = std::vector<double>{-2.0, -2.0, -2.0, 1.0, 0.0};
        goal = std::vector<double>{2.0, 2.0, 2.0, -1.0, 0.0};
        setup.setStartAndGoalStates(start, goal, 1.5);
        setup.setPlanner(std::make_shared<oc::RRT>(si));
        setup.setup();
        ob::IterationTerminationCondition limit(20000);
        if (setup.solve(limit) != ob::PlannerStatus::EXACT_SOLUTION)
            continue;
        ++solved;
        // Any state of the path at any time, by FCL alone
        const TeamValidityChecker fcl(si, boxes({{{-0.8, -1.0, 0.002, 4.0}, {0.8, 1.0, 0.002, 4.0}}}), Method::FCL);
        oc::PathControl path = setup.getSolutionPath();
        path.interpolate();
        const TeamPropagator propagator(si);
        ob::ScopedState<> between(setup.getStateSpace());
        for (unsigned int i = 0; i + 1 < path.getStateCount(); ++i)
            for (int k = 0; k <= 1000; ++k)
            {
                propagator.propagate(path.getState(i), path.getControl(i), path.getControlDuration(i) * k / 1000.0,
                                     between.get());
                ASSERT_TRUE(fcl.isValid(between.get())) << "seed " << seed << " motion " << i << " at " << k;
            }
    }
    EXPECT_GT(solved, 0u);
}

namespace
{
    /** A space that does not tell where its numbers are, as OMPL's own base class does not */
    class Addressless : public ob::SE2StateSpace
    {
    public:
        double *getValueAddressAtIndex(ob::State * /*state*/, unsigned int /*index*/) const override
        {
            return nullptr;
        }
    };

    /** A unicycle's steps in such a space */
    class Wanderer : public DynamicRobot
    {
    public:
        Wanderer(const RobotPtr &shape, const std::shared_ptr<const DynamicRobot> &model)
          : DynamicRobot(shape, {}, ob::RealVectorBounds(0), model->getControlNames(), model->getControlBounds())
          , model_(model)
        {
        }

        void propagate(const ob::State *from, const double *control, double duration, ob::State *to) const override
        {
            model_->propagate(from, control, duration, to);
        }

        void computeStepBounds(const ob::State *from, const double *control, double duration,
                               MotionBound *bounds) const override
        {
            model_->computeStepBounds(from, control, duration, bounds);
        }

    private:
        const std::shared_ptr<const DynamicRobot> model_;
    };

    /** A disc in such a space */
    class AddresslessDisc : public Robot
    {
    public:
        AddresslessDisc() : Robot("wanderer", makeSpace(), {Body::disc(0.2)})
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            const auto *place = state->as<ob::SE2StateSpace::StateType>();
            poses[0] = planarPose(place->getX(), place->getY(), place->getYaw());
        }

        void computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const override
        {
            bounds[0] = {getStateSpace()->distance(from, to), 3.2};
        }

    private:
        static ob::StateSpacePtr makeSpace()
        {
            auto space = std::make_shared<Addressless>();
            space->setBounds(within({3.0, 3.0}));
            return space;
        }
    };
}

TEST(TeamPropagatorTest, RefusesProofsWhereItCannotRefuseSteps)
{
    const auto team = teamOf({std::make_shared<Wanderer>(std::make_shared<AddresslessDisc>(), allKinds()[2])});
    EXPECT_EQ(messageOf([&] { TeamControlSetup(team, boxes({}), Method::SHARED_PROJECTION); }), "");
    EXPECT_NE(
        messageOf(
            [&]
            { TeamControlSetup(team, boxes({}), Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS); })
            .find("getValueAddressAtIndex()"),
        std::string::npos);
}

TEST(TeamPropagatorTest, RefusesBadParts)
{
    const auto space = within({3.0, 3.0});
    auto team = std::make_shared<TeamStateSpace>();
    const ObstaclesPtr obstacles = boxes({});
    EXPECT_NE(messageOf([&] { TeamControlSetup(team, obstacles); }).find("at least one robot"), std::string::npos);
    team->addRobot(RigidRobot::disc("disc", 0.1, space));
    EXPECT_EQ(messageOf([&] { TeamControlSetup(team, obstacles); }), "disc: is no DynamicRobot, so it has no controls");
    const auto controlled = teamOf({allKinds()[0]});
    EXPECT_EQ(
        messageOf(
            [&] { TeamControlSetup(controlled, obstacles, Method::STANDARD, CertificateMotionValidator::CONTINUOUS); }),
        "Steps are proved free by certificates, which the method standard does not have");
}

TEST(TeamControlSetup, SaysThatItNeedsAGoalOrAPlanner)
{
    TeamControlSetup setup(teamOf({allKinds()[2]}), boxes({{0.0, 1.6, 0.2, 2.0}}));
    EXPECT_THROW(setup.setup(), ompl::Exception);
    EXPECT_THROW(setup.solve(0.1), ompl::Exception);
    setup.setPlanner(std::make_shared<oc::RRT>(setup.getSpaceInformation()));
    EXPECT_NO_THROW(setup.setup());
}

TEST(TeamControlSetup, RefusesAStepThatIsNoNumber)
{
    const TeamControlSetupPtr setup = makeSetup(Method::STANDARD);
    setup->getSpaceInformation()->setPropagationStepSize(std::nan(""));
    EXPECT_THROW(setup->setup(), ompl::Exception);
    setup->getSpaceInformation()->setPropagationStepSize(0.1);
    EXPECT_NO_THROW(setup->setup());
}
