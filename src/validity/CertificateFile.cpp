#include "ompl_certificates/validity/CertificateFile.h"

#include "certificates/CertificateFormat.h"

#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <utility>

namespace ompl_certificates
{
    void saveCertificates(const TeamValidityChecker &checker, const std::string &file)
    {
        const auto [obstacles, certificates] = [&]
        {
            const auto world = checker.holdObstacles();
            return std::pair(identityOf(checker.getObstacles(), file), checker.getCertificates());
        }();
        writeCertificates(file, obstacles, certificates);
    }

    std::size_t loadCertificates(TeamValidityChecker &checker, const std::string &file)
    {
        const std::string bytes = readCertificateBytes(file);
        const auto world = checker.holdObstacles();
        const std::vector<Certificate> certificates =
            parseCertificates(bytes, file, identityOf(checker.getObstacles(), file));
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
