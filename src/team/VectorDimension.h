#ifndef OMPL_CERTIFICATES_TEAM_VECTOR_DIMENSION_
#define OMPL_CERTIFICATES_TEAM_VECTOR_DIMENSION_

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <typeinfo>

namespace ompl_certificates
{
    /** \brief The dimension of a space that is R^n; 0 for others. Not dynamic_cast: a derived class may have its own
        distance and states. */
    inline unsigned int vectorDimension(const ompl::base::StateSpace &space)
    {
        return typeid(space) == typeid(ompl::base::RealVectorStateSpace) ? space.getDimension() : 0;
    }
}

#endif
