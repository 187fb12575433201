#ifndef OMPL_CERTIFICATES_ROBOTS_PAIR_PADDING_
#define OMPL_CERTIFICATES_ROBOTS_PAIR_PADDING_

#include "ompl_certificates/robots/Robot.h"

namespace ompl_certificates
{
    /** \brief The distance that two bodies keep from each other: the sum of their paddings. Bodies of one robot, or of
        parts of one mechanism, keep none, but for obstacles and zones of their own. */
    double paddingBetween(const Robot &first, std::size_t body, const Robot &second, std::size_t otherBody);
}

#endif
