#ifndef OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_
#define OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_

#include <Eigen/Core>
#include <cstdint>
#include <limits>

namespace ompl_certificates
{
    /** \brief A safety certificate: the clearance found at one point of the workspace, in the scene's length unit.

        Clearance is 1-Lipschitz. So a ball (c, r) is free if |c - point| + r < clearance. A ball that is part of a
        solid body collides if |c - point| + clearance < r.

        @par External documentation
        J. Bialkowski, M. Otte, E. Frazzoli, Fast Collision Checking: From Single Robots to Multi-Robot Teams, 2013,
        section I: D_min of a point p is the clearance here. */
    struct Certificate
    {
        /** \brief The point of the workspace; z = 0 in the plane */
        Eigen::Vector3d point{Eigen::Vector3d::Zero()};

        /** \brief The distance from the point to the nearest obstacle; negative inside a solid */
        double clearance{0.0};

        /** \brief Whether point and clearance are equal */
        bool operator==(const Certificate &other) const
        {
            return point == other.point && clearance == other.clearance;
        }
    };

    /** \brief The index of a certificate in its store. It is only a hint: test the certificate that it names. */
    using CertificateIndex = std::uint32_t;

    /** \brief The index of no certificate */
    constexpr CertificateIndex NO_CERTIFICATE = std::numeric_limits<CertificateIndex>::max();
}

#endif
