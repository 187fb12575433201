#include "CheckContext.h"

namespace ompl_certificates
{
    CheckContext::CheckContext(const Team &theTeam)
      : team(theTeam)
      , poses(team.getBodyCount())
      , hints(team.getBodyCount(), NO_CERTIFICATE)
      , fresh(team.getBodyCount())
      , from(team.getRobotCount())
      , to(team.getRobotCount())
      , sampledAt(team.getRobotCount())
      , motionBounds(team.getBodyCount())
      , knowsPairMotionBounds(team.getRobotCount())
      , sample(team.getStateSpace()->allocState())
      , last(team.getStateSpace()->allocState())
    {
        for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
        {
            samples.push_back(team.getRobotSpace(robot).allocState());
            pairMotionBounds.emplace_back(team.getRobot(robot).getBodyPairs().size());
        }
    }

    CheckContext::~CheckContext()
    {
        for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
            team.getRobotSpace(robot).freeState(samples[robot]);
        team.getStateSpace()->freeState(sample);
        team.getStateSpace()->freeState(last);
    }
}
