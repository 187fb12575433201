#ifndef OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_
#define OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_

#include <Eigen/Core>
#include <cstdint>
#include <limits>

namespace ompl_certificates
{
    /** \brief A safety certificate: the clearance that was found at one point of the workspace.

        Since clearance is 1-Lipschitz, a ball (c, r) is free if |c - point| + r < clearance, and a ball that is part of a
        solid body collides if |c - point| + clearance < r.

        @par External documentation
        J. Bialkowski, M. Otte, E. Frazzoli, Fast Collision Checking: From Single Robots to Multi-Robot Teams, 2013, section
        I: D_min of a point p is the clearance here. */
    struct Certificate
    {
        /** \brief Where the clearance was found; in the plane z = 0 */
        Eigen::Vector3d point{Eigen::Vector3d::Zero()};

        /** \brief The distance from the point to the nearest obstacle point; negative inside a solid */
        double clearance{0.0};

        /** \brief Whether the two say the same about the same point */
        bool operator==(const Certificate &other) const
        {
            return point == other.point && clearance == other.clearance;
        }
    };

    /** \brief Which certificate of a store: its place in the order in which they were added. A hint: whoever follows it must
        test what it leads to. */
    using CertificateIndex = std::uint32_t;

    /** \brief The index of no certificate */
    constexpr CertificateIndex NO_CERTIFICATE = std::numeric_limits<CertificateIndex>::max();
}

#endif
