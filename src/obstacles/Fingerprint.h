#ifndef OMPL_CERTIFICATES_OBSTACLES_FINGERPRINT_
#define OMPL_CERTIFICATES_OBSTACLES_FINGERPRINT_

#include "ompl_certificates/geometry/Body.h"

namespace ompl_certificates
{
    /** \brief A checksum of an obstacle's shapes and poses, the same on every machine. Cost: linear in the size of its
        meshes. */
    std::uint64_t fingerprintOf(const PlacedBody &obstacle);

    /** \brief A checksum of numbers */
    std::uint64_t fingerprintOf(std::initializer_list<double> numbers);
}

#endif
