#ifndef OMPL_CERTIFICATES_ROBOTS_SPACE_BOUNDS_
#define OMPL_CERTIFICATES_ROBOTS_SPACE_BOUNDS_

#include <ompl/base/StateSpace.h>
#include <ompl/base/spaces/RealVectorBounds.h>
#include <string>

namespace ompl_certificates
{
    /** \brief Whether two spaces are of one class and dimension, and so are their components */
    bool areAlike(const ompl::base::StateSpace &a, const ompl::base::StateSpace &b);

    /** \brief Whether two spaces made of the same kinds of spaces have equal bounds and weights */
    bool haveEqualBounds(const ompl::base::StateSpace &a, const ompl::base::StateSpace &b);

    /** \brief The bounds of the first coordinates, which are the position; null if they have none */
    const ompl::base::RealVectorBounds *findPositionBounds(const ompl::base::StateSpace &space);

    /** \brief Complain about bounds of a robot's position that a planner cannot sample.
        \throws ompl::Exception that names the robot if they have not \e dimension dimensions, are not finite, or a
        low one is above its high one */
    void requirePositionBounds(const std::string &robot, const ompl::base::RealVectorBounds &bounds,
                               std::size_t dimension);
}

#endif
