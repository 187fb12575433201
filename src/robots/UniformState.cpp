#include "UniformState.h"

#include <cmath>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    void sampleUniform(const ob::StateSpace &space, ompl::RNG &random, ob::State *state)
    {
        if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(&space))
            for (unsigned int i = 0; i < compound->getSubspaceCount(); ++i)
                sampleUniform(*compound->getSubspace(i), random, state->as<ob::CompoundState>()->components[i]);
        else if (const auto *vector = dynamic_cast<const ob::RealVectorStateSpace *>(&space))
            for (unsigned int i = 0; i < vector->getDimension(); ++i)
                state->as<ob::RealVectorStateSpace::StateType>()->values[i] =
                    random.uniformReal(vector->getBounds().low[i], vector->getBounds().high[i]);
        else if (dynamic_cast<const ob::SO2StateSpace *>(&space))
            state->as<ob::SO2StateSpace::StateType>()->value = random.uniformReal(-M_PI, M_PI);
        else if (dynamic_cast<const ob::SO3StateSpace *>(&space))
        {
            double numbers[4];
            random.quaternion(numbers);
            auto *turn = state->as<ob::SO3StateSpace::StateType>();
            turn->x = numbers[0];
            turn->y = numbers[1];
            turn->z = numbers[2];
            turn->w = numbers[3];
        }
        else
            space.allocStateSampler()->sampleUniform(state);
    }
}
