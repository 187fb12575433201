#ifndef OMPL_CERTIFICATES_ROBOTS_SPACE_BOUNDS_
#define OMPL_CERTIFICATES_ROBOTS_SPACE_BOUNDS_

#include <ompl/base/StateSpace.h>

namespace ompl_certificates
{
    /** \brief Whether two spaces made of the same kinds of spaces have equal bounds and weights */
    bool haveEqualBounds(const ompl::base::StateSpace &a, const ompl::base::StateSpace &b);
}

#endif
