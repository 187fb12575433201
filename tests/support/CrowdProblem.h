#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_CROWD_PROBLEM_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_CROWD_PROBLEM_

#include "support/Teams.h"

#include "ompl_certificates/planning/TeamSetup.h"

#include <string>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief A random free state of the team; \e half is half the side of the square that the robots are in */
        inline ompl::base::ScopedState<> randomFreeState(const TeamSetup &setup, Random &random, double half)
        {
            const TeamStateSpace &team = setup.getTeam();
            ompl::base::ScopedState<> state(setup.getStateSpace());
            const auto component = [&](unsigned int robot)
            { return state->as<ompl::base::CompoundState>()->components[robot]; };
            for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
            {
                const auto isFree = [&]
                {
                    bool free = setup.getTeamChecker()->isRobotFree(robot, component(robot));
                    for (unsigned int other = 0; free && other < robot; ++other)
                        free = setup.getTeamChecker()->isPairFree(robot, component(robot), other, component(other));
                    return free;
                };
                const auto &space = team.getRobot(robot).getStateSpace();
                do
                {
                    std::vector<double> reals;
                    for (unsigned int i = 0; i < space->getDimension(); ++i)
                        reals.push_back(i < 2 ? random.uniform(-half, half) : random.uniform(-3.0, 3.0));
                    space->copyFromReals(component(robot), reals);
                } while (!isFree());
            }
            return state;
        }

        /** \brief Discs and boxes, in turn, among random boxes; \e half is half the side of the square */
        inline TeamSetupPtr crowd(std::uint64_t seed, unsigned int robots, double half, unsigned int obstacles,
                                  Method method = Method::SHARED_PROJECTION,
                                  CertificateMotionValidator::Mode mode = CertificateMotionValidator::DISCRETE)
        {
            Random random(seed);
            std::vector<PlacedBody> bodies;
            for (unsigned int i = 0; i < obstacles; ++i)
                bodies.push_back(
                    {Body::box(random.uniform(0.3, 1.2), random.uniform(0.3, 1.2)),
                     planarPose(random.uniform(-half, half), random.uniform(-half, half), random.uniform(-3.0, 3.0))});
            auto team = std::make_shared<TeamStateSpace>();
            for (unsigned int i = 0; i < robots; ++i)
            {
                const std::string name = "robot_" + std::to_string(i);
                team->addRobot(i % 2 == 0 ? RigidRobot::disc(name, 0.25, cubeBounds(2, half))
                                          : RigidRobot::inSE2(name, Body::box(0.5, 0.25), cubeBounds(2, half)));
            }
            auto setup = std::make_shared<TeamSetup>(team, std::make_shared<FclObstacles>(bodies, 2), method, mode);
            setup->getSpaceInformation()->setup();
            const auto start = randomFreeState(*setup, random, half);
            setup->setStartAndGoalStates(start, randomFreeState(*setup, random, half));
            return setup;
        }

        /** \brief A condition that becomes true when it is evaluated for the time \e count + 1 */
        inline ompl::base::PlannerTerminationCondition evaluations(std::uint64_t count)
        {
            const auto left = std::make_shared<std::uint64_t>(count);
            return ompl::base::PlannerTerminationCondition([left] { return *left == 0 || --*left == 0; });
        }

        /** \brief Whether FCL alone finds a path free at a tenth of the resolution */
        inline bool isFreeAtFineResolution(const TeamSetup &setup, const ompl::geometric::PathGeometric &path)
        {
            const auto si = std::make_shared<ompl::base::SpaceInformation>(setup.getStateSpace());
            const auto &own = *setup.getTeamChecker();
            const auto obstacles = std::shared_ptr<const Obstacles>(&own.getObstacles(), [](const Obstacles *) {});
            const TeamValidityChecker checker(si, obstacles, Method::FCL);
            ompl::geometric::PathGeometric fine = path;
            unsigned int count = 1;
            for (unsigned int i = 1; i < path.getStateCount(); ++i)
                count += 10 * setup.getStateSpace()->validSegmentCount(fine.getState(i - 1), fine.getState(i));
            fine.interpolate(count);
            for (const ompl::base::State *state : fine.getStates())
                if (!checker.isValid(state))
                    return false;
            return true;
        }
    }
}

#endif
