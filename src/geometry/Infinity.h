#ifndef OMPL_CERTIFICATES_GEOMETRY_INFINITY_
#define OMPL_CERTIFICATES_GEOMETRY_INFINITY_

#include <limits>

namespace ompl_certificates
{
    constexpr double INF = std::numeric_limits<double>::infinity();
    constexpr float FLOAT_INF = std::numeric_limits<float>::infinity();
}

#endif
