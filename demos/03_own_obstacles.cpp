// Obstacles of an own kind: a field of round columns, given by a formula. Nothing but collides() and clearance() is
// needed.

#include <ompl_certificates/obstacles/Obstacles.h>
#include <ompl_certificates/planning/TeamSetup.h>
#include <ompl_certificates/robots/RigidRobot.h>
#include <ompl_certificates/obstacles/CheckObstacles.h>

#include <cmath>
#include <iostream>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

using namespace ompl_certificates;

/** \brief Columns of the given radius, at all points whose coordinates are multiples of the spacing */
class Columns : public Obstacles
{
public:
    Columns(double spacing, double radius) : spacing_(spacing), radius_(radius)
    {
    }

    unsigned int getDimension() const override
    {
        return 2;
    }

    /** \brief The distance to the nearest column: exact, so it is 1-Lipschitz, and negative inside */
    double clearance(const Eigen::Vector3d &point) const override
    {
        const Eigen::Vector2d nearest = spacing_ * (point.head<2>() / spacing_).array().round().matrix();
        return (point.head<2>() - nearest).norm() - radius_;
    }

    /** \brief The body touches a column if the column's center is closer to it than the radius. */
    bool collides(const Body &body, const Pose &pose) const override
    {
        const Pose toBody = pose.inverse();
        const Eigen::Vector3d center = pose.translation();
        const double reach = body.getBoundingRadius() + radius_;
        for (double x = std::ceil((center.x() - reach) / spacing_); x <= (center.x() + reach) / spacing_; ++x)
            for (double y = std::ceil((center.y() - reach) / spacing_); y <= (center.y() + reach) / spacing_; ++y)
                if (body.signedDistance(toBody * Eigen::Vector3d(spacing_ * x, spacing_ * y, 0.0)) <= radius_)
                    return true;
        return false;
    }

    /** \brief Rounding is all that the two can differ by. */
    double getTolerance() const override
    {
        return 1e-9;
    }

private:
    double spacing_;
    double radius_;
};

int main()
{
    ompl::base::RealVectorBounds bounds(2);
    bounds.setLow(0.0);
    bounds.setHigh(20.0);

    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(RigidRobot::disc("scout", 0.4, bounds));
    team->addRobot(RigidRobot::inSE2("carrier", Body::box(1.5, 0.6), bounds));

    const auto columns = std::make_shared<Columns>(4.0, 0.8);
    // Throws, and says where, if clearances are no distances or not those of collides(): certificates rely on both.
    checkObstacles(*columns, {Body::disc(0.4), Body::box(1.5, 0.6)}, bounds);

    TeamSetup setup(team, columns);
    ompl::base::ScopedState<> start(team), goal(team);
    start = std::vector<double>{2.0, 2.0, 18.0, 18.0, 0.0};
    goal = std::vector<double>{18.0, 18.0, 2.0, 2.0, 1.0};
    setup.setStartAndGoalStates(start, goal);
    setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup.getSpaceInformation()));
    if (setup.solve(10.0) != ompl::base::PlannerStatus::EXACT_SOLUTION)
        return 1;

    const CheckCounts counts = setup.getStatistics().getCounts();
    std::cout << "A path of length " << setup.getSolutionPath().length() << "; collides() was called "
              << counts.exactCalls << " times for " << counts.robotPoses << " robot poses\n";
    return 0;
}
