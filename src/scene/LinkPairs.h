#ifndef OMPL_CERTIFICATES_SCENE_LINK_PAIRS_
#define OMPL_CERTIFICATES_SCENE_LINK_PAIRS_

#include "ompl_certificates/robots/Arm.h"

#include <set>

namespace ompl_certificates
{
    /** \brief The names of two links */
    using LinkPair = std::pair<std::string, std::string>;

    /** \brief All pairs of links with bodies */
    std::vector<LinkPair> pairsOf(const KinematicTree &tree);

    /** \brief All pairs of links with bodies but those that a joint connects, also through fixed joints and links
        without bodies */
    std::vector<LinkPair> pairsNotAdjacent(const KinematicTree &tree);

    /** \brief Of the pairs of \e arm those that collide in all of 1000 random states. The states are the same in each
        call.
        \param known pairs that are known to do so, and are not tried */
    std::vector<LinkPair> pairsThatAlwaysCollide(const Arm &arm, const std::set<LinkPair> &known);

    /** \brief Of the pairs of \e arm those that never move towards each other, and whether each of them collides */
    std::vector<std::pair<LinkPair, bool>> pairsThatStay(const Arm &arm);
}

#endif
