#include "support/CrowdProblem.h"
#include "support/Quiet.h"

#include "ompl_certificates/planning/DRRTstar.h"

#include <gtest/gtest.h>
#include <mutex>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <set>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    /** The threads that ask where a robot's bodies are */
    class Threads
    {
    public:
        void note()
        {
            const std::lock_guard<std::mutex> guard(mutex_);
            threads_.insert(std::this_thread::get_id());
        }

        std::size_t getCount() const
        {
            return threads_.size();
        }

    private:
        std::mutex mutex_;
        std::set<std::thread::id> threads_;
    };

    ob::StateSpacePtr square(double half)
    {
        auto space = std::make_shared<ob::RealVectorStateSpace>(2);
        space->setBounds(-half, half);
        return space;
    }

    /** A disc that is like no other robot */
    class WatchedDisc : public Robot
    {
    public:
        WatchedDisc(const std::string &name, Threads &threads)
          : Robot(name, square(4.0), {Body::disc(0.2)}), threads_(threads)
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            threads_.note();
            const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
            poses[0] = planarPose(values[0], values[1], 0.0);
        }

        void computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const override
        {
            bounds[0] = {getStateSpace()->distance(from, to), 0.0};
        }

    private:
        Threads &threads_;
    };

    /** Four robots cross a square with some boxes. Growing roadmaps of this seed is part of the plan. */
    std::vector<double> planWith(unsigned int count, Threads &threads)
    {
        ompl::RNG::setSeed(7);
        auto team = std::make_shared<TeamStateSpace>();
        for (const char *name : {"a", "b", "c", "d"})
            team->addRobot(std::make_shared<WatchedDisc>(name, threads));
        Random random(7);
        std::vector<PlacedBody> boxes;
        for (unsigned int i = 0; i < 15; ++i)
            boxes.push_back({Body::box(0.8, 0.8), random.pose(2, 3.0)});
        TeamSetup setup(team, std::make_shared<FclObstacles>(boxes, 2));
        setup.getSpaceInformation()->setup();
        const auto start = randomFreeState(setup, random, 3.9);
        setup.setStartAndGoalStates(start, randomFreeState(setup, random, 3.9));
        auto planner = std::make_shared<DRRTstar>(setup.getSpaceInformation());
        planner->params().setParam("threads", std::to_string(count));
        setup.setPlanner(planner);
        EXPECT_EQ(setup.solve(evaluations(5000)), ob::PlannerStatus::EXACT_SOLUTION);
        std::vector<double> all;
        for (const ob::State *state : setup.getSolutionPath().getStates())
        {
            std::vector<double> reals;
            team->copyToReals(reals, state);
            all.insert(all.end(), reals.begin(), reals.end());
        }
        return all;
    }
}

TEST(DRRTstarThreads, ChangeNothingButTheTime)
{
    const Quiet quiet;
    Threads one, two, four;
    const auto path = planWith(1, one);
    EXPECT_EQ(planWith(2, two), path);
    EXPECT_EQ(planWith(4, four), path);
    EXPECT_EQ(one.getCount(), 1U);
    EXPECT_GT(two.getCount(), 1U);
    EXPECT_GT(four.getCount(), 1U);
}
