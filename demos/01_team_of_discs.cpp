// A team of two discs swaps places around a wall: an ordinary OMPL program, with our state space, validity checker and
// motion validator.

#include <ompl_certificates/obstacles/FclObstacles.h>
#include <ompl_certificates/robots/RigidRobot.h>
#include <ompl_certificates/validity/CertificateMotionValidator.h>
#include <ompl_certificates/validity/SharedProjection.h>

#include <fcl/geometry/shape/box.h>
#include <iostream>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

using namespace ompl_certificates;

int main()
{
    ompl::base::RealVectorBounds bounds(2);
    bounds.setLow(0.0);
    bounds.setHigh(10.0);

    // The obstacles of an FCL program, seen from above: a wall of 1 x 6 in the middle.
    const std::vector<std::shared_ptr<fcl::CollisionObjectd>> collisionObjects{std::make_shared<fcl::CollisionObjectd>(
        std::make_shared<fcl::Boxd>(1.0, 6.0, 1.0), fcl::Matrix3d::Identity(), fcl::Vector3d(5.0, 5.0, 0.0))};
    auto obstacles = std::make_shared<FclObstacles>(collisionObjects, 2);

    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::disc("scout", 0.3, bounds));
    team->addRobot(RigidRobot::disc("carrier", 0.6, bounds));

    ompl::geometric::SimpleSetup setup(team);
    auto checker = std::make_shared<SharedProjection>(setup.getSpaceInformation(), obstacles);
    setup.setStateValidityChecker(checker);
    setup.getSpaceInformation()->setMotionValidator(std::make_shared<CertificateMotionValidator>(checker));

    ompl::base::ScopedState<> start(team), goal(team);
    start = std::vector<double>{1.0, 5.0, 9.0, 5.0};
    goal = std::vector<double>{9.0, 5.0, 1.0, 5.0};
    setup.setStartAndGoalStates(start, goal);
    setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup.getSpaceInformation()));
    if (setup.solve(10.0) != ompl::base::PlannerStatus::EXACT_SOLUTION)
        return 1;

    setup.getSolutionPath().printAsMatrix(std::cout);
    const CheckCounts counts = checker->getStatistics().getCounts();
    std::cout << counts.robotPoses << " robot poses were looked at: " << counts.certifiedFree << " certified free, "
              << counts.certifiedColliding << " certified colliding, " << counts.asked << " asked of the obstacles;\n"
              << "FCL was called " << counts.exactCalls << " times.\n"
              << counts.motionSamplesSkipped << " of " << counts.motionSamples << " samples of motions were skipped.\n";
    return 0;
}
