#include "support/CrowdProblem.h"
#include "support/Quiet.h"

#include "ompl_certificates/planning/TeamPathSimplifier.h"
#include "ompl_certificates/team/TeamObjective.h"

#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/RandomNumbers.h>
#include <set>
#include <utility>
#include <vector>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    /** Of a shortest curve of a car a part may be another one, where OMPL finds one as short. */
    class SimplifiedCurves : public testing::Test
    {
        const Quiet quiet_;
    };

    using Ends = std::pair<std::vector<double>, std::vector<double>>;

    Ends endsOf(const ob::SpaceInformation &si, const ob::State *from, const ob::State *to)
    {
        Ends ends;
        si.getStateSpace()->copyToReals(ends.first, from);
        si.getStateSpace()->copyToReals(ends.second, to);
        return ends;
    }

    /** Remembers the motions that it accepted. */
    class Recorder : public ob::MotionValidator
    {
    public:
        explicit Recorder(const ob::SpaceInformationPtr &si) : MotionValidator(si), validator_(si->getMotionValidator())
        {
        }

        bool checkMotion(const ob::State *from, const ob::State *to) const override
        {
            if (!validator_->checkMotion(from, to))
                return false;
            accepted.insert(endsOf(*si_, from, to));
            return true;
        }

        bool checkMotion(const ob::State *from, const ob::State *to,
                         std::pair<ob::State *, double> &lastValid) const override
        {
            return checkMotion(from, to) || validator_->checkMotion(from, to, lastValid);
        }

        mutable std::set<Ends> accepted;

    private:
        ob::MotionValidatorPtr validator_;
    };

    /** Two cars and four discs among small boxes */
    TeamSetupPtr cars(std::uint64_t seed)
    {
        Random random(seed);
        const double half = 1.6;
        std::vector<PlacedBody> bodies;
        for (unsigned int i = 0; i < 6; ++i)
            bodies.push_back(
                {Body::box(random.uniform(0.05, 0.3), random.uniform(0.05, 0.3)),
                 planarPose(random.uniform(-half, half), random.uniform(-half, half), random.uniform(-3.0, 3.0))});
        const auto bounds = cubeBounds(2, half);
        const auto team = std::make_shared<TeamStateSpace>();
        for (const char *name : {"car_1", "car_2"})
            team->addRobot(RigidRobot::inReedsShepp(name, Body::box(0.3, 0.15), 1.0, bounds));
        for (const char *name : {"disc_1", "disc_2", "disc_3", "disc_4"})
            team->addRobot(RigidRobot::disc(name, 0.1, bounds));
        auto setup = std::make_shared<TeamSetup>(team, std::make_shared<FclObstacles>(bodies, 2));
        setup->getSpaceInformation()->setup();
        const auto start = randomFreeState(*setup, random, half);
        setup->setStartAndGoalStates(start, randomFreeState(*setup, random, half));
        return setup;
    }
}

TEST_F(SimplifiedCurves, ChecksEachNewMotion)
{
    unsigned int solved = 0;
    for (std::uint64_t seed = 1; seed <= scaled(15); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed));
        const auto setup = cars(seed);
        const auto si = setup->getSpaceInformation();
        setup->setPlanner(std::make_shared<og::RRTConnect>(si));
        if (setup->solve(evaluations(5000)) != ob::PlannerStatus::EXACT_SOLUTION)
            continue;
        ++solved;
        og::PathGeometric path = setup->getSolutionPath();
        const auto recorder = std::make_shared<Recorder>(si);
        ASSERT_TRUE(path.check());
        for (std::size_t i = 1; i < path.getStateCount(); ++i)
            recorder->accepted.insert(endsOf(*si, path.getStates()[i - 1], path.getStates()[i]));
        si->setMotionValidator(recorder);
        ob::ScopedState<> goal(setup->getStateSpace());
        goal = setup->getGoal()->as<ob::GoalState>()->getState();
        TeamPathSimplifier simplifier(si, makeObjective(seed % 2 == 0 ? "makespan" : "sum", si, goal));
        simplifier.simplify(path, 600, ob::plannerNonTerminatingCondition());
        for (std::size_t i = 1; i < path.getStateCount(); ++i)
            EXPECT_EQ(recorder->accepted.count(endsOf(*si, path.getStates()[i - 1], path.getStates()[i])), 1U) << i;
        EXPECT_TRUE(path.check());
    }
    EXPECT_GT(solved, scaled(15) / 2);
}

TEST_F(SimplifiedCurves, TakesNoCurveOnTheOtherSideOfAnObstacle)
{
    // A car that turns to -pi first, which is pi, goes around the obstacle on the left. From there OMPL finds the curve
    // on the right, which is as short.
    const auto bounds = cubeBounds(2, 10.0);
    const auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::inReedsShepp("car", Body::box(0.3, 0.15), 1.0, bounds));
    team->addRobot(RigidRobot::disc("disc", 0.1, bounds));
    const std::vector<PlacedBody> obstacles{{Body::disc(0.1), planarPose(-0.208303, 0.593739, 0.0)}};
    const auto setup = std::make_shared<TeamSetup>(team, std::make_shared<FclObstacles>(obstacles, 2));
    const auto si = setup->getSpaceInformation();
    si->setup();
    og::PathGeometric path(si);
    ob::ScopedState<> state(team);
    for (const std::vector<double> &row :
         std::vector<std::vector<double>>{{0.0, 0.0, -M_PI, -8.0, 8.0},
                                          {0.0, 0.0, std::nextafter(M_PI, 0.0), -8.0, 8.0},
                                          {0.75, 0.0, 0.0, -8.0, 8.0},
                                          {0.75, 0.0, 0.0, -6.0, 9.0},
                                          {0.75, 0.0, 0.0, -4.0, 6.0},
                                          {0.75, 0.0, 0.0, -2.0, 8.0},
                                          {0.75, 0.0, 0.0, 0.0, 9.5},
                                          {0.75, 0.0, 0.0, 2.0, 8.0}})
    {
        state = row;
        path.append(state.get());
    }
    ASSERT_TRUE(path.check());
    for (unsigned int seed = 1; seed <= scaled(100); ++seed)
    {
        ompl::RNG::setSeed(seed);
        og::PathGeometric simplified = path;
        TeamPathSimplifier simplifier(si, makeObjective("sum", si, state));
        simplifier.simplify(simplified, 20, ob::plannerNonTerminatingCondition());
        EXPECT_TRUE(simplified.check()) << "seed " << seed;
    }
}
