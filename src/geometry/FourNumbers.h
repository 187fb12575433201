#ifndef OMPL_CERTIFICATES_GEOMETRY_FOUR_NUMBERS_
#define OMPL_CERTIFICATES_GEOMETRY_FOUR_NUMBERS_

#include <cstdint>

namespace ompl_certificates
{
    /** \brief Four numbers: an instruction takes all of them. */
    using FourFloats = float __attribute__((vector_size(16)));
    using FourInts = std::int32_t __attribute__((vector_size(16)));

    /** \brief Times this, a sum of three squares in single precision is a lower bound of what it would be without
        rounding. */
    constexpr float SHRINK = 1.0F - 2e-6F;

    /** \brief The squares of larger coordinates do not fit into single precision. */
    constexpr double FARTHEST = 1e18;
}

#endif
