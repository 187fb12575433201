// OMPL's benchmark, once for each method, and what it measured. benchmark_team does this for scenes in files.

#include <ompl_certificates/obstacles/FclObstacles.h>
#include <ompl_certificates/planning/TeamSetup.h>
#include <ompl_certificates/robots/RigidRobot.h>

#include <iostream>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/tools/benchmark/Benchmark.h>

using namespace ompl_certificates;

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

        ompl::tools::Benchmark benchmark(setup, "columns " + nameOf(method));
        benchmark.addPlanner(std::make_shared<ompl::geometric::RRT>(setup.getSpaceInformation()));
        benchmark.setPreRunEvent([&setup](const ompl::base::PlannerPtr & /*planner*/)
                                 { setup.getStatistics().reset(); });
        benchmark.setPostRunEvent(
            [&setup](const ompl::base::PlannerPtr & /*planner*/, ompl::tools::Benchmark::RunProperties &run)
            {
                run["fcl_calls INTEGER"] = std::to_string(setup.getStatistics().getCounts().exactCalls);
                run["time_in_checking REAL"] = std::to_string(setup.getStatistics().getCheckingSeconds());
            });
        benchmark.benchmark(ompl::tools::Benchmark::Request(5.0, 1000.0, 3, 0.1, false, false, false));

        // saveResultsToFile() would write the log that ompl_benchmark_statistics reads.
        for (const auto &run : benchmark.getRecordedExperimentData().planners.front().runs)
        {
            std::cout << nameOf(method) << ": solved " << run.at("solved BOOLEAN") << ", time " << run.at("time REAL")
                      << " s, of which in checking " << run.at("time_in_checking REAL") << " s, FCL calls "
                      << run.at("fcl_calls INTEGER") << '\n';
            solved = solved && run.at("solved BOOLEAN") == "1";
        }
    }
    return solved ? 0 : 1;
}
