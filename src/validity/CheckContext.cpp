#include "CheckContext.h"

namespace ompl_certificates
{
    CheckContext::CheckContext(const Team &theTeam, std::size_t bodyPairs)
      : team(theTeam)
      , poses(team.getBodyCount())
      , hints(team.getBodyCount(), NO_CERTIFICATE)
      , sphereCenters(team.getBodyCount())
      , fresh(team.getBodyCount())
      , from(team.getRobotCount())
      , to(team.getRobotCount())
      , sampledAt(team.getRobotCount())
      , motionBounds(team.getBodyCount())
      , placed(team.getRobotCount())
      , sparePoses(team.getBodyCount())
      , knowsMotionBounds(team.getRobotCount())
      , knowsPairMotionBounds(team.getRobotCount())
      , bodyTimes(team.getBodyCount())
      , bodyPairTimes(bodyPairs)
      , bodyPairDirections(bodyPairs, Eigen::Vector3d::Zero())
      , lastColliding(team.getRobotCount())
      , lastCollidingPair(team.getRobotCount() * (team.getRobotCount() + std::size_t(1)) / 2)
      , batch(team, bodyPairs)
      , robotPolicies(team.getRobotCount())
      , sample(team.getStateSpace()->allocState())
      , last(team.getStateSpace()->allocState())
    {
        for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
        {
            samples.push_back(team.getRobotSpace(robot).allocState());
            spare.push_back(team.getRobotSpace(robot).allocState());
            pairMotionBounds.emplace_back(team.getRobot(robot).getBodyPairs().size());
        }
    }

    CheckContext::~CheckContext()
    {
        for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
        {
            team.getRobotSpace(robot).freeState(samples[robot]);
            team.getRobotSpace(robot).freeState(spare[robot]);
        }
        team.getStateSpace()->freeState(sample);
        team.getStateSpace()->freeState(last);
    }
}
