// A crate is moved again and again, and the team plans anew: what is known of the other obstacles stays known.

#include <ompl_certificates/obstacles/ObstacleSet.h>
#include <ompl_certificates/planning/TeamSetup.h>
#include <ompl_certificates/robots/RigidRobot.h>

#include <iostream>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;

namespace
{
    /** Plans from the start again, and tells whether there is a plan. */
    bool plan(TeamSetup &setup)
    {
        setup.clear();
        setup.getStatistics().reset();
        return setup.solve(20.0) == ompl::base::PlannerStatus::EXACT_SOLUTION;
    }

    std::unique_ptr<TeamSetup> makeSetup(const TeamStateSpacePtr &team, const ObstaclesPtr &obstacles)
    {
        auto setup = std::make_unique<TeamSetup>(team, obstacles);
        ompl::base::ScopedState<> start(team), goal(team);
        start = std::vector<double>{2.0, 2.0, 38.0, 38.0, 2.0, 38.0};
        goal = std::vector<double>{38.0, 38.0, 2.0, 2.0, 38.0, 2.0};
        setup->setStartAndGoalStates(start, goal);
        // Certificates from the first check on, whatever the clock says
        setup->getTeamChecker()->setAdaptive(false);
        setup->setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup->getSpaceInformation()));
        return setup;
    }
}

int main()
{
    ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
    ompl::RNG::setSeed(1);  // the same figures each time
    ompl::base::RealVectorBounds bounds(2);
    bounds.setLow(0.0);
    bounds.setHigh(40.0);
    auto team = std::make_shared<TeamStateSpace>();
    for (const std::string name : {"first", "second", "third"})
        team->addRobot(RigidRobot::disc(name, 0.5, bounds));

    ObstacleSet obstacles(2);
    for (int i = 0; i < 81; ++i)
        obstacles.add(
            {Body::box(1.0 + 0.1 * (i % 7), 1.4), planarPose(4.0 + 4.0 * (i % 9), 4.0 + 4.0 * (i / 9), 0.3 * i)});
    const ObstacleSet::Id crate = obstacles.add({Body::box(3.0, 3.0), planarPose(10.0, 10.0, 0.0)});

    const auto setup = makeSetup(team, obstacles.takeChange().after);
    bool solved = plan(*setup);
    std::uint64_t asked = 0, askedAnew = 0;
    for (int i = 1; i <= 10; ++i)
    {
        obstacles.move(crate, planarPose(10.0 + 2.0 * i, 10.0 + i, 0.2 * i));
        const ObstacleChange change = obstacles.takeChange();
        setup->getTeamChecker()->changeObstacles(change);
        solved = plan(*setup) && solved;
        const auto fresh = makeSetup(team, change.after);
        solved = plan(*fresh) && solved;
        asked += setup->getStatistics().getCounts().asked;
        askedAnew += fresh->getStatistics().getCounts().asked;
    }
    std::cout << "Ten plans, one obstacle of " << obstacles.size() << " moved before each: " << asked
              << " robot poses had to be checked among the obstacles, by new checkers " << askedAnew << ".\n";
    return solved ? 0 : 1;
}
