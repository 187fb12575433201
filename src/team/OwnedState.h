#ifndef OMPL_CERTIFICATES_TEAM_OWNED_STATE_
#define OMPL_CERTIFICATES_TEAM_OWNED_STATE_

#include <memory>
#include <ompl/base/StateSpace.h>

namespace ompl_certificates
{
    /** \brief A state that frees itself. Unlike an ompl::base::ScopedState it needs no shared pointer to its space. */
    using OwnedState = std::shared_ptr<ompl::base::State>;

    /** \brief A new state of \e space, which must outlive it */
    inline OwnedState newState(const ompl::base::StateSpace &space)
    {
        return {space.allocState(), [&space](ompl::base::State *state) { space.freeState(state); }};
    }

    /** \brief A copy of \e state, a state of \e space, which must outlive it */
    inline OwnedState cloneState(const ompl::base::StateSpace &space, const ompl::base::State *state)
    {
        OwnedState copy = newState(space);
        space.copyState(copy.get(), state);
        return copy;
    }
}

#endif
