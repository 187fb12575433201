#ifndef OMPL_CERTIFICATES_TESTS_STRESS_DRAW_
#define OMPL_CERTIFICATES_TESTS_STRESS_DRAW_

#include "World.h"

#include <ompl/base/StateSpace.h>
#include <utility>

namespace ompl_certificates
{
    namespace stress
    {
        /** \brief Puts positions on the grid of the world, and turns about at most one axis, often about none. */
        void alignWithGrid(World &world, const ompl::base::StateSpacePtr &space, ompl::base::State *state);

        /** \brief Sets angles and quaternions to values where they wrap around or change their sign.
            \param anyTurns whether angles may count turns, and quaternions have other lengths than 1 */
        void setAngles(test::Random &random, const ompl::base::StateSpacePtr &space, ompl::base::State *state,
                       bool anyTurns);

        /** \brief The two states of a motion: mostly from a valid one, near or far, or with angles that wrap around */
        std::pair<ompl::base::State *, ompl::base::State *> drawMotion(World &world);
    }
}

#endif
