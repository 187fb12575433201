#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_RANDOM_STATES_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_RANDOM_STATES_

#include "Random.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <vector>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief Set a rotation */
        inline void setRotation(ompl::base::SO3StateSpace::StateType &state, const Eigen::Quaterniond &rotation)
        {
            state.w = rotation.w();
            state.x = rotation.x();
            state.y = rotation.y();
            state.z = rotation.z();
        }

        /** \brief Set a state of a space made of RealVector, SO(2) and SO(3) spaces to anything within its bounds */
        inline void randomize(Random &random, const ompl::base::StateSpacePtr &space, ompl::base::State *state)
        {
            namespace ob = ompl::base;
            if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(space.get()))
            {
                for (unsigned int i = 0; i < compound->getSubspaceCount(); ++i)
                    randomize(random, compound->getSubspace(i), state->as<ob::CompoundState>()->components[i]);
            }
            else if (const auto *vector = dynamic_cast<const ob::RealVectorStateSpace *>(space.get()))
            {
                for (unsigned int i = 0; i < vector->getDimension(); ++i)
                    state->as<ob::RealVectorStateSpace::StateType>()->values[i] =
                        random.uniform(vector->getBounds().low[i], vector->getBounds().high[i]);
            }
            else if (dynamic_cast<const ob::SO2StateSpace *>(space.get()))
                state->as<ob::SO2StateSpace::StateType>()->value = random.uniform(-M_PI, M_PI);
            else
                setRotation(*state->as<ob::SO3StateSpace::StateType>(), random.rotation());
        }

        /** \brief Anything within the bounds of \e space */
        inline ompl::base::ScopedState<> randomState(Random &random, const ompl::base::StateSpacePtr &space)
        {
            ompl::base::ScopedState<> state(space);
            randomize(random, space, state.get());
            return state;
        }

        /** \brief A state at \e fraction of the way from \e from to a random one */
        inline ompl::base::ScopedState<> randomStateNear(Random &random, const ompl::base::ScopedState<> &from,
                                                         double fraction)
        {
            const auto &space = from.getSpace();
            ompl::base::ScopedState<> state(space);
            space->interpolate(from.get(), randomState(random, space).get(), fraction, state.get());
            return state;
        }

        /** \brief The same bounds along each axis */
        inline ompl::base::RealVectorBounds cubeBounds(unsigned int dimension, double half)
        {
            ompl::base::RealVectorBounds bounds(dimension);
            bounds.setLow(-half);
            bounds.setHigh(half);
            return bounds;
        }

        /** \brief The coordinates of a state */
        inline std::vector<double> realsOf(const ompl::base::StateSpace &space, const ompl::base::State *state)
        {
            std::vector<double> reals;
            space.copyToReals(reals, state);
            return reals;
        }
    }
}

#endif
