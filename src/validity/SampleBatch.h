#ifndef OMPL_CERTIFICATES_VALIDITY_SAMPLE_BATCH_
#define OMPL_CERTIFICATES_VALIDITY_SAMPLE_BATCH_

#include "geometry/BatchOverlap.h"

#include "ompl_certificates/team/Team.h"

#include <vector>

namespace ompl_certificates
{
    /** \brief Some samples of a motion that are checked at once: the working memory of a BatchCheck. Empty if a robot of
        the team has no pose batches. */
    struct SampleBatch
    {
        /** \param bodyPairs how many pairs of bodies are checked against each other */
        SampleBatch(const Team &team, std::size_t bodyPairs);
        ~SampleBatch();

        SampleBatch(const SampleBatch &) = delete;
        SampleBatch &operator=(const SampleBatch &) = delete;

        const Team &team;

        /** \brief For each robot its states at all samples */
        std::vector<const ompl::base::State *> robotStates;

        /** \brief Memory for states at the samples: of the team, and of each robot */
        std::vector<ompl::base::State *> teamSamples, robotSamples;

        /** \brief For each body: its poses, and where the center of its bounding sphere is */
        std::vector<PoseBatch> poses;
        std::vector<PointBatch> centers;

        /** \brief For each robot: how far off its poses and centers may be */
        std::vector<PoseError> errors;

        /** \brief For each body: at which samples it may touch an obstacle. For each pair of bodies: at which samples
            they may touch each other. */
        std::vector<BatchMask> nearObstacles, nearEachOther;

        /** \brief Whether batches can be checked */
        bool isPossible() const
        {
            return !poses.empty();
        }

        /** \brief The state of a robot at a sample */
        const ompl::base::State *&robotState(unsigned int robot, std::size_t sample)
        {
            return robotStates[robot * PoseBatch::SIZE + sample];
        }

        /** \brief Takes \e state, of the team, as the state at a sample */
        void setState(std::size_t sample, const ompl::base::State *state)
        {
            for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
                robotState(robot, sample) = team.getRobotState(state, robot);
        }
    };
}

#endif
