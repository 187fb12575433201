// OMPL's benchmark, once for each method, and what it measured. certificates benchmark does this for scenes in files.

#include <ompl_certificates/obstacles/FclObstacles.h>
#include <ompl_certificates/planning/TeamSetup.h>
#include <ompl_certificates/robots/RigidRobot.h>

#include <iostream>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/tools/benchmark/Benchmark.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;

/** A benchmark whose runs are alike with each method: run i has seed i, and begins without certificates. */
class MethodBenchmark : public ompl::tools::Benchmark
{
public:
    explicit MethodBenchmark(TeamSetup &setup) : Benchmark(setup, "columns"), setup_(setup)
    {
        addPlanner(std::make_shared<ompl::geometric::RRT>(setup.getSpaceInformation()));
        setPreRunEvent([this](const ompl::base::PlannerPtr & /*planner*/) { prepareRun(); });
        setPostRunEvent(
            [this](const ompl::base::PlannerPtr & /*planner*/, RunProperties &run)
            {
                // OMPL's check of the solution is among these.
                run["fcl_calls INTEGER"] = std::to_string(setup_.getStatistics().getCounts().exactCalls);
                run["time_in_checking REAL"] = std::to_string(setup_.getStatistics().getCheckingSeconds());
            });
    }

private:
    void prepareRun()
    {
        ompl::RNG::setSeed(status_.activeRun + 1);
        // A planner keeps its random numbers from run to run: only a new one obeys the seed.
        planners_.front() = std::make_shared<ompl::geometric::RRT>(setup_.getSpaceInformation());
        // A benchmark's planners are its own: the setup gives them what it gives its own.
        setup_.prepare(*planners_.front());
        setup_.getTeamChecker()->clear();
        setup_.getStatistics().reset();
    }

    TeamSetup &setup_;
};

int main()
{
    ompl::base::RealVectorBounds bounds(2);
    bounds.setLow(0.0);
    bounds.setHigh(10.0);
    std::vector<PlacedBody> columns;
    for (int i = 0; i < 25; ++i)
        columns.push_back({Body::box(0.6, 0.6), planarPose(1.0 + 2.0 * (i % 5), 1.0 + 2.0 * (i / 5), 0.3 * i)});

    bool solved = true;
    for (const Method method : allMethods())
    {
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(RigidRobot::disc("first", 0.3, bounds));
        team->addRobot(RigidRobot::disc("second", 0.3, bounds));
        TeamSetup setup(team, std::make_shared<FclObstacles>(columns, 2), method);
        ompl::base::ScopedState<> start(team), goal(team);
        start = std::vector<double>{2.0, 2.0, 8.0, 8.0};
        goal = std::vector<double>{8.0, 8.0, 2.0, 2.0};
        setup.setStartAndGoalStates(start, goal);

        MethodBenchmark benchmark(setup);
        benchmark.benchmark(ompl::tools::Benchmark::Request(5.0, 1000.0, 3, 0.1, false, false, false));

        // saveResultsToFile() would write the log that ompl_benchmark_statistics reads.
        for (const auto &run : benchmark.getRecordedExperimentData().planners.front().runs)
        {
            std::cout << nameOf(method) << ": solved " << run.at("solved BOOLEAN") << ", states "
                      << run.at("graph states INTEGER") << ", time " << run.at("time REAL")
                      << " s, of which in checking " << run.at("time_in_checking REAL") << " s, FCL calls "
                      << run.at("fcl_calls INTEGER") << '\n';
            solved = solved && run.at("solved BOOLEAN") == "1";
        }
    }
    return solved ? 0 : 1;
}
