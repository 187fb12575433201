#include "SampleBatch.h"

#include <algorithm>

namespace ompl_certificates
{
    SampleBatch::SampleBatch(const Team &theTeam, std::size_t bodyPairs) : team(theTeam)
    {
        const auto &robots = team.getRobots();
        if (!std::all_of(robots.begin(), robots.end(), [](const RobotPtr &robot) { return robot->hasPoseBatches(); }))
            return;
        robotStates.resize(robots.size() * PoseBatch::SIZE);
        for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
            teamSamples.push_back(team.getStateSpace()->allocState());
        for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
            for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
                robotSamples.push_back(team.getRobotSpace(robot).allocState());
        poses.resize(team.getBodyCount());
        centers.resize(team.getBodyCount());
        errors.resize(robots.size());
        nearObstacles.resize(team.getBodyCount());
        nearEachOther.resize(bodyPairs);
    }

    SampleBatch::~SampleBatch()
    {
        for (ompl::base::State *state : teamSamples)
            team.getStateSpace()->freeState(state);
        for (std::size_t i = 0; i < robotSamples.size(); ++i)
            team.getRobotSpace(static_cast<unsigned int>(i / PoseBatch::SIZE)).freeState(robotSamples[i]);
    }
}
