#include "ompl_certificates/validity/CertificateFile.h"

#include "certificates/CertificateFormat.h"

#include <algorithm>
#include <boost/functional/hash.hpp>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <unordered_set>
#include <utility>

namespace ompl_certificates
{
    namespace
    {
        struct Hash
        {
            std::size_t operator()(const Certificate &certificate) const
            {
                std::size_t hash = boost::hash<double>()(certificate.clearance);
                for (const double coordinate : certificate.point)
                    boost::hash_combine(hash, coordinate);
                return hash;
            }
        };

        /** Each certificate once. With Partial Projection all robots have those that were read from a file. */
        std::vector<Certificate> withoutRepetitions(std::vector<Certificate> certificates)
        {
            std::unordered_set<Certificate, Hash> known(2 * certificates.size());
            certificates.erase(std::remove_if(certificates.begin(), certificates.end(),
                                              [&known](const Certificate &certificate)
                                              { return !known.insert(certificate).second; }),
                               certificates.end());
            return certificates;
        }
    }

    void saveCertificates(const TeamValidityChecker &checker, const std::string &file)
    {
        const auto [obstacles, certificates] = [&]
        {
            const auto world = checker.holdObstacles();
            return std::pair(identityOf(checker.getObstacles(), file), checker.getCertificates());
        }();
        writeCertificates(file, obstacles, withoutRepetitions(certificates));
    }

    std::size_t loadCertificates(TeamValidityChecker &checker, const std::string &file)
    {
        const std::string bytes = readCertificateBytes(file);
        const auto world = checker.holdObstacles();
        const std::vector<Certificate> certificates =
            withoutRepetitions(parseCertificates(bytes, file, identityOf(checker.getObstacles(), file)));
        try
        {
            checker.addCertificates(certificates);
        }
        catch (const ompl::Exception &exception)
        {
            throw ompl::Exception(file, exception.what());
        }
        if (checker.getKeptCertificates() >= checker.getMaxCertificates())
            OMPL_WARN("%s: some of its %zu certificates may not be kept, since the checker has %zu, as many as it may",
                      file.c_str(), certificates.size(), checker.getKeptCertificates());
        return certificates.size();
    }
}
