#ifndef OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_FORMAT_
#define OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_FORMAT_

#include "ompl_certificates/certificates/Certificate.h"
#include "ompl_certificates/obstacles/Obstacles.h"

#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief Identifies the obstacles that a certificate file belongs to */
    struct ObstacleIdentity
    {
        unsigned int dimension;
        std::uint64_t fingerprint;
    };

    /** \brief The identity of \e obstacles
        \throws ompl::Exception that names \e file if they have no fingerprint */
    ObstacleIdentity identityOf(const Obstacles &obstacles, const std::string &file);

    /** \brief Writes certificates of \e obstacles to \e file, completely or not at all, in the format of
        docs/certificate-file.md.
        \throws ompl::Exception that names the file if it cannot be written */
    void writeCertificates(const std::string &file, const ObstacleIdentity &obstacles,
                           const std::vector<Certificate> &certificates);

    /** \brief The bytes of a certificate file
        \throws ompl::Exception that names the file if it cannot be read */
    std::string readCertificateBytes(const std::string &file);

    /** \brief The certificates in \e bytes
        \throws ompl::Exception that names \e file and the reason if they are damaged, of another version or of other
        obstacles */
    std::vector<Certificate> parseCertificates(const std::string &bytes, const std::string &file,
                                               const ObstacleIdentity &obstacles);
}

#endif
