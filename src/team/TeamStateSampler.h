#ifndef OMPL_CERTIFICATES_TEAM_TEAM_STATE_SAMPLER_
#define OMPL_CERTIFICATES_TEAM_TEAM_STATE_SAMPLER_

#include "ompl_certificates/team/TeamStateSpace.h"

#include <ompl/base/StateSampler.h>

namespace ompl_certificates
{
    /** \brief Samples the components, and clears the references. */
    class TeamStateSampler : public ompl::base::CompoundStateSampler
    {
    public:
        explicit TeamStateSampler(const TeamStateSpace *team) : CompoundStateSampler(team), team_(team)
        {
        }

        void sampleUniform(ompl::base::State *state) override
        {
            CompoundStateSampler::sampleUniform(state);
            team_->clearReferences(state);
        }

        /** \brief Near \e near, or the state within the bounds that is next to it: ways that are curves, such as cars',
            may leave the bounds, where OMPL's samplers end the program. */
        void sampleUniformNear(ompl::base::State *state, const ompl::base::State *near, double distance) override
        {
            if (team_->satisfiesBounds(near))
                CompoundStateSampler::sampleUniformNear(state, near, distance);
            else
            {
                ompl::base::State *const center = team_->cloneState(near);
                team_->enforceBounds(center);
                CompoundStateSampler::sampleUniformNear(state, center, distance);
                team_->freeState(center);
            }
            team_->clearReferences(state);
        }

        void sampleGaussian(ompl::base::State *state, const ompl::base::State *mean, double stdDev) override
        {
            CompoundStateSampler::sampleGaussian(state, mean, stdDev);
            team_->clearReferences(state);
        }

    private:
        const TeamStateSpace *team_;
    };
}

#endif
