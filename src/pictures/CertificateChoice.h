#ifndef OMPL_CERTIFICATES_SRC_PICTURES_CERTIFICATE_CHOICE_
#define OMPL_CERTIFICATES_SRC_PICTURES_CERTIFICATE_CHOICE_

#include "ompl_certificates/certificates/Certificate.h"

#include <vector>

namespace ompl_certificates
{
    /** \brief The certificates that prove a ball free, and one that can be drawn: clearance is infinite without
        obstacles, and negative inside one. */
    std::vector<Certificate> freeBalls(const std::vector<Certificate> &certificates);

    /** \brief The largest of freeBalls(), but none whose point is too near to that of a larger one that is chosen. The
        largest come first.
        \param most how many are chosen
        \param apart the least distance from the point of the larger one, in radii of its ball
        Cost: n log n, and \e most comparisons for each. */
    std::vector<Certificate> largestApart(const std::vector<Certificate> &certificates, std::size_t most, double apart);
}

#endif
