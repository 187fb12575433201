#ifndef OMPL_CERTIFICATES_TESTS_CONTROL_DYNAMIC_PROBLEMS_
#define OMPL_CERTIFICATES_TESTS_CONTROL_DYNAMIC_PROBLEMS_

#include "ompl_certificates/control/Car.h"
#include "ompl_certificates/control/Integrator.h"
#include "ompl_certificates/control/PrioritizedRRT.h"
#include "ompl_certificates/control/TeamControlSetup.h"
#include "ompl_certificates/control/Unicycle.h"
#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/robots/RigidRobot.h"

#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <ompl/util/RandomNumbers.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief Bounds from -limits to limits */
        inline ompl::base::RealVectorBounds within(const std::vector<double> &limits)
        {
            ompl::base::RealVectorBounds bounds(0);
            for (const double limit : limits)
            {
                bounds.low.push_back(-limit);
                bounds.high.push_back(limit);
            }
            return bounds;
        }

        /** \brief One robot of each kind, in a square of half width \e half */
        inline std::vector<std::shared_ptr<const DynamicRobot>> allKinds(double half = 3.0)
        {
            const auto space = within({half, half});
            const Body box = Body::box(0.5, 0.25);
            return {
                Integrator::firstOrder(RigidRobot::disc("single", 0.1, space), within({0.5, 0.5})),
                Integrator::secondOrder(RigidRobot::disc("double", 0.15, space), within({0.5, 0.5}),
                                        within({2.0, 2.0})),
                Unicycle::firstOrder(RigidRobot::inSE2("unicycle", box, space), within({0.5, 0.5})),
                Unicycle::secondOrder(RigidRobot::inSE2("unicycle2", box, space), within({0.5, 0.5}),
                                      within({0.25, 0.25})),
                Car::alone(RigidRobot::inSE2("car", box, space), within({0.5, 1.0}), 0.25),
                Car::withTrailer(std::make_shared<CarWithTrailer>("train", box, Body::box(0.3, 0.25), 0.5, space),
                                 within({0.5, 1.0}), 0.25, 0.8),
            };
        }

        /** \brief A team of some robots */
        inline TeamStateSpacePtr teamOf(const std::vector<std::shared_ptr<const DynamicRobot>> &robots)
        {
            auto team = std::make_shared<TeamStateSpace>();
            for (const auto &robot : robots)
                team->addRobot(robot);
            return team;
        }

        /** \brief Boxes in the plane: center and size of each */
        inline ObstaclesPtr boxes(const std::vector<std::array<double, 4>> &list)
        {
            std::vector<PlacedBody> placed;
            for (const auto &[x, y, width, height] : list)
                placed.push_back({Body::box(width, height), planarPose(x, y)});
            return std::make_shared<FclObstacles>(placed, 2);
        }

        /** \brief Two second-order unicycles and a car with trailer that pass a wall with gaps */
        inline TeamControlSetupPtr
        makeSetup(Method method, CertificateMotionValidator::Mode mode = CertificateMotionValidator::DISCRETE)
        {
            const auto robots = allKinds();
            std::vector<std::array<double, 4>> list{{0.0, 1.6, 0.2, 2.0}, {0.0, -1.6, 0.2, 2.0}, {-1.5, 1.5, 0.4, 0.4}};
            // So many that certificates are kept
            for (int i = 0; i < 60; ++i)
                list.push_back({-2.9 + 0.1 * i, 2.8, 0.05, 0.05});
            const ObstaclesPtr obstacles = boxes(list);
            auto setup =
                std::make_shared<TeamControlSetup>(teamOf({robots[1], robots[3], robots[5]}), obstacles, method, mode);
            setup->getTeamChecker()->setCertificatesAfter(0);
            ompl::base::ScopedState<> start(setup->getStateSpace()), goal(setup->getStateSpace());
            start = std::vector<double>{-1.5, 0.0, 0.0, 0.0, -1.0, -2.0, 0.0, 0.0, 0.0, 1.5, 0.0, 3.0, 3.0};
            goal = std::vector<double>{1.5, 1.0, 0.0, 0.0, -1.0, 0.7, 0.0, 0.0, 0.0, 1.5, -1.5, 3.0, 3.0};
            setup->setStartAndGoalStates(start, goal, 0.5);
            return setup;
        }

        /** \brief Four robots with velocities in a square, each of which takes the place of the one opposite. In the middle there
            is a box. */
        inline TeamControlSetupPtr swapping(Method method, CertificateMotionValidator::Mode mode)
        {
            const auto space = within({2.0, 2.0});
            std::vector<std::shared_ptr<const DynamicRobot>> robots;
            for (int i = 0; i < 4; ++i)
                robots.push_back(Integrator::secondOrder(RigidRobot::disc("puck" + std::to_string(i), 0.15, space),
                                                         within({0.5, 0.5}), within({2.0, 2.0})));
            auto setup =
                std::make_shared<TeamControlSetup>(teamOf(robots), boxes({{{0.0, 0.0, 0.4, 0.4}}}), method, mode);
            ompl::base::ScopedState<> start(setup->getStateSpace()), goal(setup->getStateSpace());
            start = std::vector<double>{-1.0, 0, 0, 0, 1.0, 0, 0, 0, 0, -1.0, 0, 0, 0, 1.0, 0, 0};
            goal = std::vector<double>{1.0, 0, 0, 0, -1.0, 0, 0, 0, 0, 1.0, 0, 0, 0, -1.0, 0, 0};
            setup->setStartAndGoalStates(start, goal, 0.4);
            setup->setPlanner(std::make_shared<PrioritizedRRT>(setup->getSpaceInformation()));
            return setup;
        }

        /** \brief The numbers of all states of a path */
        inline std::vector<double> numbersOf(ompl::control::PathControl &path)
        {
            std::vector<double> all, some;
            for (const ompl::base::State *state : path.getStates())
            {
                path.getSpaceInformation()->getStateSpace()->copyToReals(some, state);
                all.insert(all.end(), some.begin(), some.end());
            }
            return all;
        }

        /** \brief A setup for one robot that moves from x = -1.5 to x = 1.5 */
        inline std::unique_ptr<TeamControlSetup> crossing(const std::shared_ptr<const DynamicRobot> &robot,
                                                          const std::vector<std::array<double, 4>> &obstacles)
        {
            auto setup = std::make_unique<TeamControlSetup>(teamOf({robot}), boxes(obstacles));
            setup->getSpaceInformation()->setup();
            ompl::base::ScopedState<> start(setup->getStateSpace()), goal(setup->getStateSpace());
            std::vector<double> numbers(setup->getStateSpace()->getValueLocations().size(), 0.0);
            numbers[0] = -1.5;
            start = numbers;
            numbers[0] = 1.5;
            goal = numbers;
            setup->setStartAndGoalStates(start, goal, 0.5);
            setup->setPlanner(std::make_shared<PrioritizedRRT>(setup->getSpaceInformation()));
            return setup;
        }

        /** \brief Expect that the robots of swapping() are led along the same path whatever the method is: the planner's,
            after \e change */
        inline void expectSamePathUnderAllMethods(const std::function<void(TeamControlSetup &)> &change)
        {
            std::vector<double> first;
            for (const Method method :
                 {Method::FCL, Method::STANDARD, Method::BASIC, Method::PARTIAL, Method::SHARED_PROJECTION})
            {
                ompl::RNG::setSeed(2);
                const auto setup = swapping(method, CertificateMotionValidator::DISCRETE);
                ASSERT_EQ(setup->solve(60.0), ompl::base::PlannerStatus::EXACT_SOLUTION);
                change(*setup);
                const std::vector<double> path = numbersOf(setup->getSolutionPath());
                if (first.empty())
                    first = path;
                EXPECT_EQ(path, first) << nameOf(method);
            }
        }
    }
}

#endif
