#include <ompl_certificates/obstacles/FclObstacles.h>
#include <ompl_certificates/planning/TeamSetup.h>
#include <ompl_certificates/robots/RigidRobot.h>
#include <ompl_certificates/team/TeamStateSpace.h>
#include <ompl_certificates/validity/CertificateMotionValidator.h>
#include <ompl_certificates/validity/SharedProjection.h>

#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>
#include <ompl/base/ScopedState.h>
#include <ompl/geometric/SimpleSetup.h>

#include <iostream>
#include <memory>
#include <vector>

namespace oc = ompl_certificates;

/** \brief Two robots of different shapes pass a wall: set up by hand first, then by TeamSetup. */
int main()
{
    auto wall = std::make_shared<fcl::CollisionObjectd>(std::make_shared<fcl::Boxd>(0.5, 6.0, 1.0));
    wall->setTranslation(fcl::Vector3d(5.0, 5.0, 0.0));
    wall->computeAABB();
    const std::vector<std::shared_ptr<fcl::CollisionObjectd>> collisionObjects{wall};
    auto obstacles = std::make_shared<oc::FclObstacles>(collisionObjects, 2);

    ompl::base::RealVectorBounds bounds(2);
    bounds.setLow(0.0);
    bounds.setHigh(10.0);
    auto team = std::make_shared<oc::TeamStateSpace>();
    team->addRobot(oc::RigidRobot::disc("scout", 0.3, bounds));
    team->addRobot(oc::RigidRobot::inSE2("carrier", oc::Body::box(0.5, 0.25), bounds));

    // x and y of the scout; x, y and the angle of the carrier
    ompl::base::ScopedState<> start(team), goal(team);
    start = std::vector<double>{1.0, 5.0, 9.0, 5.0, 0.0};
    goal = std::vector<double>{9.0, 5.0, 1.0, 5.0, 0.0};

    ompl::geometric::SimpleSetup byHand(team);
    auto checker = std::make_shared<oc::SharedProjection>(byHand.getSpaceInformation(), obstacles);
    byHand.setStateValidityChecker(checker);
    byHand.getSpaceInformation()->setMotionValidator(std::make_shared<oc::CertificateMotionValidator>(checker));

    oc::TeamSetup inOne(team, obstacles);

    for (ompl::geometric::SimpleSetup *setup : {&byHand, static_cast<ompl::geometric::SimpleSetup *>(&inOne)})
    {
        setup->setStartAndGoalStates(start, goal);
        if (!setup->solve(5.0) || !setup->haveExactSolutionPath())
        {
            std::cerr << "The team found no way around the wall.\n";
            return 1;
        }
    }
    std::cout << "The installed package works.\n";
    return 0;
}
