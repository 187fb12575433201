#include "CheckContext.h"

#include <algorithm>

namespace ompl_certificates
{
    namespace
    {
        std::vector<MotionCurve> curvesOf(const Team &team)
        {
            std::vector<MotionCurve> curves;
            for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
                curves.emplace_back(team.getRobotSpace(robot));
            return curves;
        }

        bool hasAny(const std::vector<MotionCurve> &curves)
        {
            return std::any_of(curves.begin(), curves.end(), [](const MotionCurve &curve) { return curve.isCurve(); });
        }
    }

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
      , curves(curvesOf(team))
      , teamCurve(*team.getStateSpace())
      , hasRobotCurves(team.interpolatesRobots() && !teamCurve.isCurve() && hasAny(curves))
      , hasCurves(teamCurve.isCurve() || hasAny(curves))
      , mayMissEnds(teamCurve.mayMissEnd() || std::any_of(curves.begin(), curves.end(),
                                                          [](const MotionCurve &curve) { return curve.mayMissEnd(); }))
      , placed(team.getRobotCount())
      , sparePoses(team.getBodyCount())
      , knowsMotionBounds(team.getRobotCount())
      , knowsPairMotionBounds(team.getRobotCount())
      , bodyTimes(team.getBodyCount())
      , bodyPairTimes(bodyPairs)
      , bodyPairDirections(bodyPairs, Eigen::Vector3d::Zero())
      , cellUses(bodyPairs)
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

    void CheckContext::interpolate(const ompl::base::State *s1, const ompl::base::State *s2, double t,
                                   ompl::base::State *state)
    {
        if (!hasRobotCurves)
            return teamCurve.interpolate(s1, s2, t, state);
        for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
            curves[robot].interpolate(team.getRobotState(s1, robot), team.getRobotState(s2, robot), t,
                                      const_cast<ompl::base::State *>(team.getRobotState(state, robot)));
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
