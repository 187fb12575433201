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

        /** How many of \e certificates are not among \e kept */
        std::size_t countMissing(const std::vector<Certificate> &certificates, const std::vector<Certificate> &kept)
        {
            const std::unordered_set<Certificate, Hash> known(kept.begin(), kept.end());
            return static_cast<std::size_t>(std::count_if(certificates.begin(), certificates.end(),
                                                          [&known](const Certificate &certificate)
                                                          { return known.count(certificate) == 0; }));
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
            if (const std::size_t lost = countMissing(certificates, checker.getCertificates()); lost > 0)
                OMPL_WARN("%s: %zu of its %zu certificates were not kept, since the checker has as many as it may",
                          file.c_str(), lost, certificates.size());
        return certificates.size();
    }
}
