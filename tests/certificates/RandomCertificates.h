#ifndef OMPL_CERTIFICATES_TESTS_CERTIFICATES_RANDOM_CERTIFICATES_
#define OMPL_CERTIFICATES_TESTS_CERTIFICATES_RANDOM_CERTIFICATES_

#include "support/Random.h"

#include "ompl_certificates/certificates/CertificateTree.h"

#include <limits>
#include <vector>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief Certificates in an order that is hard on a tree: scattered, sorted, on a line, in shrinking clusters,
            or many at the same points. Their clearances have any size and sign. */
        inline std::vector<Certificate> randomCertificates(Random &random, unsigned int dimension, unsigned int count)
        {
            const unsigned int kind = random.below(6);
            const double unit = random.logUniform(1e-3, 1e4);
            const Eigen::Vector3d origin = random.point(dimension, 3.0 * unit), along = random.direction(dimension);
            std::vector<Certificate> certificates;
            for (unsigned int i = 0; i < count; ++i)
            {
                const double part = static_cast<double>(i) / count;
                Certificate certificate;
                if (kind == 0)
                    certificate.point = random.point(dimension, unit);
                else if (kind == 1)
                    certificate.point = origin + part * unit * along;
                else if (kind == 2)
                    certificate.point = Eigen::Vector3d(std::floor(part * 7.0), 2.0, 0.0) * unit;
                else if (kind == 3)
                    certificate.point = origin + random.point(dimension, unit * std::pow(0.5, 40.0 * part));
                else if (kind == 4)
                    certificate.point = random.point(dimension, unit * std::pow(2.0, 20.0 * part));
                else
                    certificate.point = Eigen::Vector3d(part * unit, 0.0, 0.0);
                certificate.clearance = unit * random.logUniform(1e-4, 0.3) * (random.chance(0.3) ? -1.0 : 1.0);
                if (random.chance(0.01))
                    certificate.clearance = 0.0;
                certificates.push_back(certificate);
            }
            return certificates;
        }

        /** \brief A ball about as large as the clearances, near one of the certificates */
        inline BallQuery randomQuery(Random &random, unsigned int dimension,
                                     const std::vector<Certificate> &certificates)
        {
            const Certificate &near = certificates[random.below(certificates.size())];
            const double scale = std::max(std::abs(near.clearance), 1e-12);
            BallQuery query;
            query.center = near.point + random.point(dimension, scale * random.logUniform(1e-2, 30.0));
            const double radius = scale * random.uniform(0.0, 1.5);
            query.freeRadius = 1.01 * radius;
            query.collidingRadius = random.chance(0.3) ? -std::numeric_limits<double>::infinity() : 0.99 * radius;
            if (random.chance(0.1))
                query.freeRadius = std::numeric_limits<double>::infinity();
            return query;
        }
    }
}

#endif
