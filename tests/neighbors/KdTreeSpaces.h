#ifndef OMPL_CERTIFICATES_TESTS_TEAM_KD_TREE_SPACES_
#define OMPL_CERTIFICATES_TESTS_TEAM_KD_TREE_SPACES_

#include "ompl_certificates/robots/CarWithTrailer.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/team/TeamStateSpace.h"

#include <memory>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <string>

namespace ompl_certificates
{
    namespace test
    {
        inline ompl::base::RealVectorBounds cube(unsigned int dimension, double low, double high)
        {
            ompl::base::RealVectorBounds bounds(dimension);
            bounds.setLow(low);
            bounds.setHigh(high);
            return bounds;
        }

        inline TeamStateSpacePtr discs(unsigned int count, double low = 0.0, double high = 100.0,
                                       TeamStateSpace::Metric metric = TeamStateSpace::EUCLIDEAN)
        {
            auto team = std::make_shared<TeamStateSpace>(metric);
            for (unsigned int i = 0; i < count; ++i)
                team->addRobot(RigidRobot::disc(std::to_string(i), 0.1, cube(2, low, high)));
            return team;
        }

        inline TeamStateSpacePtr boxes(TeamStateSpace::Metric metric = TeamStateSpace::EUCLIDEAN)
        {
            auto team = std::make_shared<TeamStateSpace>(metric);
            for (unsigned int i = 0; i < 2; ++i)
                team->addRobot(RigidRobot::inSE2(std::to_string(i), Body::box(0.5, 0.2), cube(2, -2.0, 2.0)), 1.0 + i);
            return team;
        }

        inline TeamStateSpacePtr drones(TeamStateSpace::Metric metric = TeamStateSpace::EUCLIDEAN)
        {
            auto team = std::make_shared<TeamStateSpace>(metric);
            for (unsigned int i = 0; i < 2; ++i)
                team->addRobot(RigidRobot::inSE3(std::to_string(i), Body::box(0.5, 0.2, 0.1), cube(3, -1.0, 1.0)));
            return team;
        }

        inline TeamStateSpacePtr mixed(TeamStateSpace::Metric metric = TeamStateSpace::EUCLIDEAN)
        {
            auto team = std::make_shared<TeamStateSpace>(metric);
            const auto bounds = cube(2, -3.0, 3.0);
            team->addRobot(RigidRobot::inSE2("box", Body::box(0.5, 0.2), bounds), 2.0);
            team->addRobot(
                std::make_shared<CarWithTrailer>("train", Body::box(0.4, 0.2), Body::box(0.3, 0.2), 0.5, bounds), 0.7);
            team->addRobot(RigidRobot::disc("disc", 0.2, bounds), 0.3);
            team->addRobot(RigidRobot::disc("weightless", 0.2, bounds), 0.0);
            return team;
        }

        inline ompl::base::StateSpacePtr space(unsigned int which)
        {
            switch (which)
            {
                case 0:
                    return discs(1);
                case 1:
                    return discs(3);
                case 2:
                    return discs(5);
                case 3:
                    return boxes();
                case 4:
                    return drones();
                case 5:
                    return mixed();
                case 6:
                    return discs(2, 1e9, 1e9 + 1.0);  // where floats, and nearly doubles, are coarse
                case 7:
                {
                    auto se2 = std::make_shared<ompl::base::SE2StateSpace>();
                    se2->setBounds(cube(2, -1.0, 1.0));
                    return se2;
                }
                case 8:
                    return discs(5, 0.0, 100.0, TeamStateSpace::SUM);
                case 9:
                    return boxes(TeamStateSpace::SUM);
                case 10:
                    return drones(TeamStateSpace::SUM);
                case 11:
                    return mixed(TeamStateSpace::SUM);
                default:
                {
                    auto plain = std::make_shared<ompl::base::RealVectorStateSpace>(7);
                    plain->setBounds(-1.0, 1.0);
                    return plain;
                }
            }
        }

        constexpr unsigned int SPACES = 13;
    }
}

#endif
