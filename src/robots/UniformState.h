#ifndef OMPL_CERTIFICATES_ROBOTS_UNIFORM_STATE_
#define OMPL_CERTIFICATES_ROBOTS_UNIFORM_STATE_

#include <ompl/base/StateSpace.h>
#include <ompl/util/RandomNumbers.h>

namespace ompl_certificates
{
    /** \brief Write a random state within the bounds to \e state, by the numbers of \e random. OMPL's samplers have
        generators of their own, whose numbers depend on all that were made before. */
    void sampleUniform(const ompl::base::StateSpace &space, ompl::RNG &random, ompl::base::State *state);
}

#endif
