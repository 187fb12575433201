// Syclop among the control planners: it is given a grid over the plane of the first robot.

#include "DynamicProblems.h"

#include "support/IterationLimit.h"
#include "support/Quiet.h"
#include "support/Random.h"

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/control/planners/syclop/GridDecomposition.h>
#include <ompl/control/planners/syclop/SyclopEST.h>
#include <ompl/control/planners/syclop/SyclopRRT.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace oc = ompl::control;

namespace
{
    class Grid : public oc::GridDecomposition
    {
    public:
        explicit Grid(ob::StateSpacePtr space) : GridDecomposition(8, 2, within({3.0, 3.0})), space_(std::move(space))
        {
        }

        void project(const ob::State *state, std::vector<double> &coord) const override
        {
            coord = {*space_->getValueAddressAtIndex(state, 0), *space_->getValueAddressAtIndex(state, 1)};
        }

        void sampleFullState(const ob::StateSamplerPtr &sampler, const std::vector<double> &coord,
                             ob::State *state) const override
        {
            sampler->sampleUniform(state);
            *space_->getValueAddressAtIndex(state, 0) = coord[0];
            *space_->getValueAddressAtIndex(state, 1) = coord[1];
        }

    private:
        ob::StateSpacePtr space_;
    };

    struct Plan
    {
        bool isSolved{false};
        std::vector<std::vector<double>> tree;
    };

    /** A unicycle and a disc pass a wall with a gap. */
    template <typename Planner>
    Plan planWith(Method method, CertificateMotionValidator::Mode mode, unsigned int seed, double tolerance)
    {
        const Quiet quiet;
        ompl::RNG::setSeed(seed);
        const auto robots = allKinds();
        TeamControlSetup setup(teamOf({robots[2], robots[1]}), boxes({{{0.0, 1.9, 0.2, 2.2}, {0.0, -1.9, 0.2, 2.2}}}),
                               method, mode);
        setup.getTeamChecker()->setCertificatesAfter(0);
        ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
        start = std::vector<double>{-1.5, 0.0, 0.0, -1.0, -2.0, 0.0, 0.0};
        goal = std::vector<double>{1.5, 0.5, 0.0, -1.0, 1.0, 0.0, 0.0};
        setup.setStartAndGoalStates(start, goal, tolerance);
        const auto &si = setup.getSpaceInformation();
        setup.setPlanner(std::make_shared<Planner>(si, std::make_shared<Grid>(setup.getStateSpace())));
        setup.setup();
        // Syclop asks whether to end for each selection of a region, not only for each round.
        ob::IterationTerminationCondition limit(10000);
        Plan plan{setup.solve(limit) == ob::PlannerStatus::EXACT_SOLUTION, {}};
        ob::PlannerData data(si);
        setup.getPlanner()->getPlannerData(data);
        for (unsigned int i = 0; i < data.numVertices(); ++i)
        {
            plan.tree.emplace_back();
            setup.getStateSpace()->copyToReals(plan.tree.back(), data.getVertex(i).getState());
        }
        return plan;
    }

    template <typename Planner>
    void expectEqualTrees(double tolerance)
    {
        unsigned int solved = 0;
        for (unsigned int seed = 1; seed <= scaled(2); ++seed)
        {
            SCOPED_TRACE("seed " + std::to_string(seed));
            const Plan expected = planWith<Planner>(Method::FCL, CertificateMotionValidator::DISCRETE, seed, tolerance);
            EXPECT_GT(expected.tree.size(), 20u);
            solved += expected.isSolved ? 1 : 0;
            for (const Method method : allMethods())
                EXPECT_EQ(planWith<Planner>(method, CertificateMotionValidator::DISCRETE, seed, tolerance).tree,
                          expected.tree)
                    << nameOf(method);
            const Plan proven =
                planWith<Planner>(Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS, seed, tolerance);
            EXPECT_GT(proven.tree.size(), 20u);
            EXPECT_EQ(planWith<Planner>(Method::BASIC, CertificateMotionValidator::CONTINUOUS, seed, tolerance).tree,
                      proven.tree);
        }
        EXPECT_GT(solved, 0u);
    }
}

TEST(SyclopTest, RRTGrowsEqualTreesUnderAllMethods)
{
    expectEqualTrees<oc::SyclopRRT>(1.0);
}

TEST(SyclopTest, ESTGrowsEqualTreesUnderAllMethods)
{
    expectEqualTrees<oc::SyclopEST>(3.0);
}

/** OMPL's Syclop planners call any solution exact. */
TEST(SyclopTest, SaysThatASolutionIsApproximate)
{
    const Quiet quiet;
    ompl::RNG::setSeed(1);
    TeamControlSetup setup(teamOf({allKinds()[1]}), boxes({{{0.0, 1.9, 0.2, 2.2}}}));
    ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
    start = std::vector<double>{-1.5, 0.0, 0.0, 0.0};
    goal = std::vector<double>{1.5, 0.0, 0.0, 0.0};
    setup.setStartAndGoalStates(start, goal, 1e-9);
    setup.setPlanner(
        std::make_shared<oc::SyclopRRT>(setup.getSpaceInformation(), std::make_shared<Grid>(setup.getStateSpace())));
    ob::IterationTerminationCondition limit(2000);
    EXPECT_EQ(setup.solve(limit), ob::PlannerStatus::APPROXIMATE_SOLUTION);
    EXPECT_EQ(setup.getLastPlannerStatus(), ob::PlannerStatus::APPROXIMATE_SOLUTION);
    EXPECT_TRUE(setup.haveSolutionPath());
    EXPECT_FALSE(setup.haveExactSolutionPath());
}
