#include "ompl_certificates/neighbors/PlannerKdTree.h"
#include "ompl_certificates/robots/CarWithTrailer.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/team/TeamStateSpace.h"
#include "support/IterationLimit.h"
#include "support/Random.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    /** The results of all queries so far */
    struct Tally
    {
        std::size_t queries{0}, neighbors{0}, ties{0}, different{0};
    } tally;

    /** Asks a kd-tree and a GNAT at once, and compares their answers */
    template <typename T>
    class BothNeighbors : public ompl::NearestNeighbors<T>
    {
    public:
        using typename ompl::NearestNeighbors<T>::DistanceFunction;
        using ompl::NearestNeighbors<T>::add;

        void setDistanceFunction(const DistanceFunction &distance) override
        {
            ompl::NearestNeighbors<T>::setDistanceFunction(distance);
            tree_.setDistanceFunction(distance);
            gnat_.setDistanceFunction(distance);
        }

        bool reportsSortedResults() const override
        {
            return true;
        }

        void clear() override
        {
            tree_.clear();
            gnat_.clear();
        }

        void add(const T &data) override
        {
            tree_.add(data);
            gnat_.add(data);
        }

        bool remove(const T &data) override
        {
            return tree_.remove(data) && gnat_.remove(data);
        }

        T nearest(const T &data) const override
        {
            const T found = tree_.nearest(data);
            compare(data, {found}, {gnat_.nearest(data)});
            return found;
        }

        void nearestK(const T &data, std::size_t k, std::vector<T> &found) const override
        {
            std::vector<T> expected;
            tree_.nearestK(data, k, found);
            gnat_.nearestK(data, k, expected);
            compare(data, found, expected);
        }

        void nearestR(const T &data, double radius, std::vector<T> &found) const override
        {
            std::vector<T> expected;
            tree_.nearestR(data, radius, found);
            gnat_.nearestR(data, radius, expected);
            // New states are exactly the planner's range away, and at the radius itself GNAT's bounds may round either
            // way.
            const auto isInside = [&](const T &near) { return this->distFun_(data, near) < radius * (1.0 - 1e-12); };
            std::vector<T> within;
            std::copy_if(found.begin(), found.end(), std::back_inserter(within), isInside);
            expected.erase(std::stable_partition(expected.begin(), expected.end(), isInside), expected.end());
            compare(data, within, expected);
        }

        std::size_t size() const override
        {
            return tree_.size();
        }

        void list(std::vector<T> &data) const override
        {
            tree_.list(data);
        }

    private:
        void compare(const T &data, const std::vector<T> &found, const std::vector<T> &expected) const
        {
            ++tally.queries;
            tally.neighbors += expected.size();
            bool equal = tree_.usesKdTree() && found.size() == expected.size();
            for (std::size_t i = 0; equal && i < found.size(); ++i)
            {
                if (found[i] == expected[i])
                    continue;
                ++tally.ties;
                equal = this->distFun_(data, found[i]) == this->distFun_(data, expected[i]);
            }
            tally.different += equal ? 0 : 1;
        }

        PlannerKdTree<T> tree_;
        ompl::NearestNeighborsGNAT<T> gnat_;
    };

    TeamStateSpacePtr teamOf(const std::string &kind, unsigned int robots)
    {
        ob::RealVectorBounds bounds(kind == "R3" || kind == "SE3" ? 3 : 2);
        bounds.setLow(-5.0);
        bounds.setHigh(5.0);
        auto team = std::make_shared<TeamStateSpace>();
        for (unsigned int i = 0; i < robots; ++i)
        {
            const std::string name = std::to_string(i);
            RobotPtr robot;
            if (kind == "R2")
                robot = RigidRobot::disc(name, 0.1, bounds);
            else if (kind == "R3")
                robot = RigidRobot::sphere(name, 0.1, bounds);
            else if (kind == "SE2")
                robot = RigidRobot::inSE2(name, Body::box(0.5, 0.2), bounds);
            else if (kind == "SE3")
                robot = RigidRobot::inSE3(name, Body::box(0.5, 0.2, 0.1), bounds);
            else
                robot = std::make_shared<CarWithTrailer>(name, Body::box(0.4, 0.2), Body::box(0.3, 0.2), 0.5, bounds);
            team->addRobot(robot, 1.0 + 0.5 * (i % 2));
        }
        return team;
    }

    template <typename Planner>
    void plan(const TeamStateSpacePtr &team, unsigned int seed, unsigned int iterations, bool byRadius = false)
    {
        ompl::RNG::setSeed(seed + 1);
        auto si = std::make_shared<ob::SpaceInformation>(team);
        // Refuse some states, in no order.
        unsigned int checks = 0;
        si->setStateValidityChecker([&](const ob::State *) { return ++checks % 97 != 96; });
        si->setStateValidityCheckingResolution(0.2);
        si->setup();
        ob::ScopedState<> start(team), goal(team);
        start.random();
        goal.random();
        auto problem = std::make_shared<ob::ProblemDefinition>(si);
        problem->setStartAndGoalStates(start, goal, 1e-9);
        Planner planner(si);
        planner.setRange(2.0);
        if constexpr (std::is_same_v<Planner, og::RRTstar>)
            planner.setKNearest(!byRadius);
        planner.template setNearestNeighbors<BothNeighbors>();
        planner.setProblemDefinition(problem);
        planner.setup();
        ob::IterationTerminationCondition condition(iterations);
        planner.solve(condition);
    }
}

class RecordedQueries : public testing::TestWithParam<const char *>
{
};

/** All that RRT and RRT* ask, of teams of one to five. With OMPL_CERTIFICATES_TEST_SCALE=60 these are more than 10^6
    queries. */
TEST_P(RecordedQueries, AreAnsweredAsByGnat)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    tally = {};
    const unsigned int rounds = scaled(2);
    for (unsigned int seed = 0; seed < rounds; ++seed)
        for (unsigned int robots = 1; robots <= 5; ++robots)
        {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(robots) + " robots");
            const auto team = teamOf(GetParam(), robots);
            plan<og::RRT>(team, seed, seed % 10 == 9 ? 5000 : 400);
            plan<og::RRTstar>(team, seed, seed % 10 == 9 ? 1500 : 150);
            plan<og::RRTstar>(team, seed, seed % 10 == 9 ? 1500 : 150, true);
            ASSERT_EQ(tally.different, 0U);
        }
    EXPECT_GT(tally.queries, 2000U * rounds);
    EXPECT_GT(tally.neighbors, 10 * tally.queries);
    RecordProperty("queries", std::to_string(tally.queries));
    std::cout << GetParam() << ": " << tally.queries << " queries, " << tally.neighbors << " neighbors, " << tally.ties
              << " of them ties\n";
}

INSTANTIATE_TEST_SUITE_P(Space, RecordedQueries, testing::Values("R2", "R3", "SE2", "SE3", "CarWithTrailer"));
