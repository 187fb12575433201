// A robot of an own kind: an arm of two links on a fixed base. It says where its bodies are and how far they can
// travel.

#include <ompl_certificates/obstacles/FclObstacles.h>
#include <ompl_certificates/planning/TeamSetup.h>
#include <ompl_certificates/robots/RigidRobot.h>
#include <ompl_certificates/robots/CheckRobot.h>

#include <cmath>
#include <iostream>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

using namespace ompl_certificates;
using JointState = ompl::base::RealVectorStateSpace::StateType;

/** \brief Two links of equal length; a state has the angle of the shoulder and that of the elbow, relative to the first
    link. The origin of each link's frame is its joint. */
class Arm : public Robot
{
public:
    Arm(const std::string &name, const Eigen::Vector2d &base, double length)
      : Robot(name, makeSpace(), {link(length), link(length)}), base_(base), length_(length)
    {
    }

    void computePoses(const ompl::base::State *state, Pose *poses) const override
    {
        const double *q = state->as<JointState>()->values;
        poses[0] = planarPose(base_.x(), base_.y(), q[0]);
        const Eigen::Vector3d elbow = poses[0] * Eigen::Vector3d(length_, 0.0, 0.0);
        poses[1] = planarPose(elbow.x(), elbow.y(), q[0] + q[1]);
    }

    /** \brief The space interpolates both angles linearly: the links turn at constant rates, the first about a fixed
        point and the second about an elbow that moves on an arc. */
    void computeMotionBounds(const ompl::base::State *from, const ompl::base::State *to,
                             MotionBound *bounds) const override
    {
        const double *a = from->as<JointState>()->values, *b = to->as<JointState>()->values;
        const double shoulder = b[0] - a[0], elbow = b[1] - a[1];
        bounds[0] = {0.0, std::abs(shoulder)};
        bounds[1] = {length_ * std::abs(shoulder), std::abs(shoulder + elbow)};
    }

private:
    static ompl::base::StateSpacePtr makeSpace()
    {
        auto space = std::make_shared<ompl::base::RealVectorStateSpace>(2);
        space->setBounds(-M_PI, M_PI);
        return space;
    }

    static Body link(double length)
    {
        return Body({{Shape::box(Eigen::Vector2d(length, 0.2)), planarPose(0.5 * length, 0.0)}});
    }

    Eigen::Vector2d base_;
    double length_;
};

int main()
{
    ompl::base::RealVectorBounds bounds(2);
    bounds.setLow(-3.0);
    bounds.setHigh(3.0);

    // The arm reaches around a post, while a disc passes beneath it.
    auto team = std::make_shared<TeamStateSpace>();
    const auto arm = std::make_shared<Arm>("arm", Eigen::Vector2d(0.0, 0.0), 1.2);
    // Throws, and says where, if a link moves farther than its motion bound allows: certificates rely on it.
    checkRobot(*arm);
    team->addRobot(arm);
    team->addRobot(RigidRobot::disc("scout", 0.3, bounds));
    const std::vector<PlacedBody> posts{{Body::disc(0.25), planarPose(1.6, 0.9)}};

    TeamSetup setup(team, std::make_shared<FclObstacles>(posts, 2));
    ompl::base::ScopedState<> start(team), goal(team);
    start = std::vector<double>{-0.3, 0.0, -2.0, -2.0};
    goal = std::vector<double>{1.6, 0.0, 2.0, 0.0};
    setup.setStartAndGoalStates(start, goal);
    setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup.getSpaceInformation()));
    if (setup.solve(10.0) != ompl::base::PlannerStatus::EXACT_SOLUTION)
        return 1;

    setup.getSolutionPath().printAsMatrix(std::cout);
    const CheckCounts counts = setup.getStatistics().getCounts();
    std::cout << "The obstacles were asked for " << counts.asked << " of " << counts.robotPoses << " robot poses\n";
    return 0;
}
