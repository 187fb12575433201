// Two arms at one table, from URDF and SRDF files. They are checked against the table, the post on it, each other, and
// themselves. The planner is DRRTstar, as for all teams: two seconds for a short way. In continuous mode all of it is
// proved.
//
//     08_arms [FOLDER]        the folder of the arm's files, else demos/scenes/arms

#include <ompl_certificates/obstacles/FclObstacles.h>
#include <ompl_certificates/planning/TeamSetup.h>
#include <ompl_certificates/scene/ArmFile.h>

#include <iostream>

using namespace ompl_certificates;

int main(int argc, char **argv)
try
{
    const std::string folder = argc > 1 ? argv[1] : "demos/scenes/arms";
    const ArmFile file(folder + "/arm6.urdf", folder + "/arm6.srdf");

    // The bases stand on the table's ends. The second arm is turned towards the first, its gripper is open.
    ArmFile::ArmSettings left, right;
    left.base.translation() = Eigen::Vector3d(-0.55, 0.0, 0.401);
    right.base.translation() = Eigen::Vector3d(0.55, 0.0, 0.401);
    right.base.rotate(Eigen::AngleAxisd(3.1416, Eigen::Vector3d::UnitZ()));
    right.jointValues = file.getState("gripper", "open");

    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(file.makeArm("left", "arm", left));
    team->addRobot(file.makeArm("right", "arm", right));

    const std::vector<PlacedBody> obstacles{
        {Body::box(1.6, 0.9, 0.1), Pose(Eigen::Translation3d(0.0, 0.0, 0.35))},   // the table
        {Body::cylinder(0.04, 0.4), Pose(Eigen::Translation3d(0.0, 0.0, 0.6))}};  // a post on it
    TeamSetup setup(team, std::make_shared<FclObstacles>(obstacles, 3), Method::SHARED_PROJECTION,
                    CertificateMotionValidator::CONTINUOUS);

    // The six joints of the left arm, then those of the right one. Both hands go to the other side of the post.
    ompl::base::ScopedState<> start(team), goal(team);
    start = std::vector<double>{0.514, 0.484, 1.698, 0, 0.96, -2.922, 0.514, 0.417, 1.654, 0, 1.07, 0.25};
    goal = std::vector<double>{-0.705, 0.484, 1.698, 0, 0.96, 1.802, -0.705, 0.417, 1.654, 0, 1.07, 0.214};
    setup.setStartAndGoalStates(start, goal);
    if (setup.solve(2.0) != ompl::base::PlannerStatus::EXACT_SOLUTION)
        return 1;
    setup.getSolutionPath().printAsMatrix(std::cout);
    return 0;
}
catch (const std::exception &error)
{
    std::cerr << error.what() << '\n';
    return 2;
}
