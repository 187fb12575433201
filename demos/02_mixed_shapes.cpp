// A team of four kinds of robots: a disc, a box that turns, a capsule, and a car with a trailer. TeamSetup puts the
// validity checker and the motion validator in place.

#include <ompl_certificates/obstacles/FclObstacles.h>
#include <ompl_certificates/planning/TeamSetup.h>
#include <ompl_certificates/robots/CarWithTrailer.h>
#include <ompl_certificates/robots/RigidRobot.h>

#include <iostream>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

using namespace ompl_certificates;

int main()
{
    ompl::base::RealVectorBounds bounds(2);
    bounds.setLow(0.0);
    bounds.setHigh(10.0);

    const std::vector<PlacedBody> columns{
        {Body::box(1.0, 1.0), planarPose(3.5, 3.5, 0.4)},
        {Body::disc(0.6), planarPose(6.5, 3.5)},
        {Body::convexPolygon({{0.0, 0.0}, {1.2, 0.0}, {0.6, 1.0}}), planarPose(4.4, 6.0)}};

    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::disc("scout", 0.3, bounds));
    team->addRobot(RigidRobot::inSE2("carrier", Body::box(0.8, 0.5), bounds));
    team->addRobot(RigidRobot::inSE2("welder", Body::planarCapsule(0.2, 0.6), bounds));
    team->addRobot(std::make_shared<CarWithTrailer>("truck", Body::box(0.5, 0.25), Body::box(0.3, 0.25), 0.5, bounds));

    TeamSetup setup(team, std::make_shared<FclObstacles>(columns, 2));

    // The coordinates of the robots, one after the other: x, y; x, y, θ; x, y, θ; x, y, θ and θ of the trailer.
    ompl::base::ScopedState<> start(team), goal(team);
    start = std::vector<double>{1.0, 1.0, 9.0, 1.0, 1.5, 9.0, 9.0, -1.5, 1.0, 9.0, 0.0, 0.0};
    goal = std::vector<double>{9.0, 9.0, 1.0, 9.0, 0.0, 1.0, 1.0, 0.0, 9.0, 1.0, 1.5, 1.5};
    setup.setStartAndGoalStates(start, goal);
    setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup.getSpaceInformation()));
    if (setup.solve(10.0) != ompl::base::PlannerStatus::EXACT_SOLUTION)
        return 1;

    std::cout << "A path of length " << setup.getSolutionPath().length() << " through "
              << setup.getSolutionPath().getStateCount() << " states\n";
    const CheckCounts counts = setup.getStatistics().getCounts();
    std::cout << "FCL was called " << counts.exactCalls << " times for " << counts.robotPoses << " robot poses, and "
              << counts.pairExact << " times for " << counts.pairPoses << " pairs of robots\n";
    return 0;
}
