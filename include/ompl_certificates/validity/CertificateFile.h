#ifndef OMPL_CERTIFICATES_VALIDITY_CERTIFICATE_FILE_
#define OMPL_CERTIFICATES_VALIDITY_CERTIFICATE_FILE_

#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <string>

namespace ompl_certificates
{
    /** \brief Write what \e checker knows of its obstacles to \e file, for loadCertificates(): all of it or nothing.

        Certificates are clearances of points, so they serve any team of any robots among the same obstacles. The format
        is described in docs/certificate-file.md: 32 bytes for each certificate in space, 24 in the plane.
        \throws ompl::Exception that names the file if it cannot be written, or if obstacles of this kind cannot be
        recognized again */
    void saveCertificates(const TeamValidityChecker &checker, const std::string &file);

    /** \brief Give \e checker the certificates of a file, the first ones where setMaxCertificates() does not allow for all
        \return how many there were
        \throws ompl::Exception that names the file, and gives the reason, if it cannot be read, is damaged, is of another
        version, is of other obstacles, or if the checker's method keeps none; then the checker is as it was */
    std::size_t loadCertificates(TeamValidityChecker &checker, const std::string &file);
}

#endif
