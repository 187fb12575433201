// Two robots of one mesh in a planar scene that is a mesh: what OMPL.app's SE2MultiRigidBodyPlanning does, with
// certificates. docs/coming-from-omplapp.md shows the two side by side.
//
//     06_mesh_team [FOLDER]        the folder of the meshes, else demos/scenes

#include <ompl_certificates/obstacles/FclObstacles.h>
#include <ompl_certificates/planning/TeamSetup.h>
#include <ompl_certificates/robots/RigidRobot.h>
#include <ompl_certificates/scene/MeshFile.h>

#include <iostream>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

using namespace ompl_certificates;

int main(int argc, char **argv)
try
{
    const std::string folder = argc > 1 ? argv[1] : "demos/scenes";
    const MeshFile cart(folder + "/maze_cart.obj"), walls(folder + "/maze_walls.obj");

    ompl::base::RealVectorBounds bounds(2);
    bounds.setLow(0.0);
    bounds.setHigh(0, 20.0);
    bounds.setHigh(1, 16.0);

    // Both robots share the body, and with it its sphere tree. Its origin is the mean of the mesh's vertices.
    const Body body = cart.makeRobot(2);
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::inSE2("first", body, bounds));
    team->addRobot(RigidRobot::inSE2("second", body, bounds));

    // The last argument leaves out what of the walls is above or below all robots.
    const std::vector<PlacedBody> obstacles{{walls.makeObstacle(2)}};
    TeamSetup setup(team, std::make_shared<FclObstacles>(obstacles, 2, team->getZInterval()));

    // x, y and heading of the first robot, then of the second
    ompl::base::ScopedState<> start(team), goal(team);
    start = std::vector<double>{1.0, 1.0, 0.0, 9.0, 13.0, 0.0};
    goal = std::vector<double>{9.0, 13.0, 0.0, 1.0, 1.0, 0.0};
    setup.setStartAndGoalStates(start, goal);
    setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup.getSpaceInformation()));
    if (setup.solve(60.0) != ompl::base::PlannerStatus::EXACT_SOLUTION)
        return 1;
    setup.simplifySolution();
    setup.getSolutionPath().printAsMatrix(std::cout);
    return 0;
}
catch (const std::exception &error)
{
    std::cerr << error.what() << '\n';
    return 2;
}
