#ifndef OMPL_CERTIFICATES_VALIDITY_CERTIFICATE_FILE_
#define OMPL_CERTIFICATES_VALIDITY_CERTIFICATE_FILE_

#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <string>

namespace ompl_certificates
{
    /** \brief Writes the certificates that \e checker keeps of its obstacles to \e file, completely or not at all.

        Certificates are clearances of points. So loadCertificates() can give them to any team among the same obstacles.
        docs/certificate-file.md describes the format: 32 bytes for each certificate in space, 24 in the plane.
        \throws ompl::Exception that names the file if it cannot be written, or if obstacles of this kind have no
        fingerprint */
    void saveCertificates(const TeamValidityChecker &checker, const std::string &file);

    /** \brief Adds the certificates of \e file to \e checker, as many as setMaxCertificates() allows
        \return how many different ones there were in the file
        \throws ompl::Exception that names the file and the reason if it cannot be read, is damaged, or is of another
        version or of other obstacles. Also if the checker's method keeps no certificates. The checker is then
        unchanged. */
    std::size_t loadCertificates(TeamValidityChecker &checker, const std::string &file);
}

#endif
