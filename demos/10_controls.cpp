// Robots that move by controls: a cart that steers and a puck that is pushed pass a wall. OMPL's SyclopRRT leads the cart
// through the squares of a grid.

#include <ompl_certificates/control/Integrator.h>
#include <ompl_certificates/control/TeamControlSetup.h>
#include <ompl_certificates/control/Unicycle.h>
#include <ompl_certificates/obstacles/FclObstacles.h>
#include <ompl_certificates/robots/RigidRobot.h>

#include <iostream>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/control/planners/syclop/GridDecomposition.h>
#include <ompl/control/planners/syclop/SyclopRRT.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
namespace ob = ompl::base;
namespace oc = ompl::control;

/** \brief A grid over the plane in which the first robot of a team is. Syclop first searches a way through its squares,
    then drives along that. The first robot's space must begin with its position. */
class GridOfFirstRobot : public oc::GridDecomposition
{
public:
    GridOfFirstRobot(const ob::StateSpacePtr &team, const ob::RealVectorBounds &bounds, int squaresOfASide)
      : GridDecomposition(squaresOfASide, 2, bounds), team_(team)
    {
    }

    void project(const ob::State *state, std::vector<double> &coord) const override
    {
        coord = {*team_->getValueAddressAtIndex(state, 0), *team_->getValueAddressAtIndex(state, 1)};
    }

    void sampleFullState(const ob::StateSamplerPtr &sampler, const std::vector<double> &coord,
                         ob::State *state) const override
    {
        sampler->sampleUniform(state);
        for (unsigned int axis = 0; axis < 2; ++axis)
            *team_->getValueAddressAtIndex(state, axis) = coord[axis];
    }

private:
    ob::StateSpacePtr team_;
};

namespace
{
    /** The same limits, from -limit to limit, along each of some axes */
    ob::RealVectorBounds within(std::initializer_list<double> limits)
    {
        ob::RealVectorBounds bounds(static_cast<unsigned int>(limits.size()));
        bounds.high = limits;
        for (std::size_t i = 0; i < limits.size(); ++i)
            bounds.low[i] = -bounds.high[i];
        return bounds;
    }
}

int main()
{
    ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
    ompl::RNG::setSeed(1);  // the same plan each time

    // The cart's controls are its speeds, 1 m/s and 1 rad/s; the puck's are its accelerations.
    const ob::RealVectorBounds floor = within({3.0, 2.0});
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(Unicycle::firstOrder(RigidRobot::inSE2("cart", Body::box(0.5, 0.25), floor), within({1.0, 1.0})));
    team->addRobot(
        Integrator::secondOrder(RigidRobot::disc("puck", 0.15, floor), within({0.5, 0.5}), within({2.0, 2.0})));
    // A wall with a door. It is 2 cm thick, and a step is up to 10 cm long: only proofs of whole steps see it.
    const auto obstacles =
        std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(0.02, 1.4), planarPose(0.0, -1.3)},
                                                               {Body::box(0.02, 1.4), planarPose(0.0, 1.3)}},
                                       2);

    TeamControlSetup setup(team, obstacles, Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS);
    ob::ScopedState<> start(team), goal(team);
    start = std::vector<double>{-1.5, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0};  // x, y and angle; x, y and their velocities
    goal = std::vector<double>{1.5, 0.5, 0.0, 1.0, 1.0, 0.0, 0.0};
    setup.setStartAndGoalStates(start, goal, 0.6);
    const auto grid = std::make_shared<GridOfFirstRobot>(team, floor, 12);
    setup.setPlanner(std::make_shared<oc::SyclopRRT>(setup.getSpaceInformation(), grid));
    if (setup.solve(20.0) != ob::PlannerStatus::EXACT_SOLUTION)
        return 1;

    const double found = setup.getSolutionPath().length();
    setup.simplifySolution();
    oc::PathControl path = setup.getSolutionPath();
    path.interpolate();
    path.printAsMatrix(std::cout);
    std::cout << path.length() << " s, " << found << " s before it was shortened; "
              << setup.getStatistics().getCounts().motions << " steps were checked\n";
    return 0;
}
