#ifndef OMPL_CERTIFICATES_GEOMETRY_WELD_
#define OMPL_CERTIFICATES_GEOMETRY_WELD_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace ompl_certificates
{
    /** \brief For each vertex the first one, in some order, with the same coordinates. Cost: n log n for n vertices. */
    std::vector<std::uint32_t> weld(const std::vector<Eigen::Vector3d> &vertices);
}

#endif
