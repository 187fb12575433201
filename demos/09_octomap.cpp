// Drones among the cells of an octomap, as a robot with a depth camera would have it. The map is made of the buildings
// of demos/scenes/drones_3d.yaml, written to a file and read again.
//
//     09_octomap [SCENE [MAP]]        where to write the map; by default drones.bt

#include <ompl_certificates/octomap/OctomapObstacles.h>
#include <ompl_certificates/scene/SceneFile.h>

#include <iostream>
#include <octomap/octomap.h>

using namespace ompl_certificates;

namespace
{
    /** A map of what is in the scene: a cell is occupied if it touches an obstacle, and free if not. */
    octomap::OcTree makeMap(const Scene &scene, double resolution)
    {
        octomap::OcTree map(resolution);
        const auto obstacles = scene.makeObstacles();
        const Body cell = Body::box(resolution, resolution, resolution);
        const auto &bounds = scene.getBounds();
        for (double x = bounds.low[0] + 0.5 * resolution; x < bounds.high[0]; x += resolution)
            for (double y = bounds.low[1] + 0.5 * resolution; y < bounds.high[1]; y += resolution)
                for (double z = bounds.low[2] + 0.5 * resolution; z < bounds.high[2]; z += resolution)
                    map.updateNode(x, y, z, obstacles->collides(cell, poseAt({x, y, z})));
        return map;
    }
}

int main(int argc, char **argv)
try
{
    const Scene scene = loadScene(argc > 1 ? argv[1] : "demos/scenes/drones_3d.yaml");
    const std::string file = argc > 2 ? argv[2] : "drones.bt";
    octomap::OcTree map = makeMap(scene, 0.25);
    if (!map.writeBinary(file))
        return 1;

    const auto obstacles = std::make_shared<OctomapObstacles>(file);
    std::cout << file << ": " << map.size() << " nodes, " << obstacles->getBoxes().size()
              << " boxes of occupied cells\n";

    const TeamStateSpacePtr team = scene.makeTeam();
    TeamSetup setup(team, obstacles);
    setup.setStartAndGoalStates(scene.makeStart(team), scene.makeGoal(team));
    if (setup.solve(5.0) != ompl::base::PlannerStatus::EXACT_SOLUTION)
        return 1;
    setup.getSolutionPath().printAsMatrix(std::cout);
    return 0;
}
catch (const std::exception &error)
{
    std::cerr << error.what() << '\n';
    return 2;
}
