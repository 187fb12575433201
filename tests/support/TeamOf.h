#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_TEAM_OF_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_TEAM_OF_

#include "ompl_certificates/team/TeamStateSpace.h"

#include <vector>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief A team of some robots, in their order */
        inline TeamStateSpacePtr teamOf(const std::vector<RobotPtr> &robots)
        {
            auto team = std::make_shared<TeamStateSpace>();
            for (const RobotPtr &robot : robots)
                team->addRobot(robot);
            return team;
        }
    }
}

#endif
