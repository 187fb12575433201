#ifndef OMPL_CERTIFICATES_SCENE_TOUCH_RULES_
#define OMPL_CERTIFICATES_SCENE_TOUCH_RULES_

#include "LinkPairs.h"
#include "ompl_certificates/scene/ArmFile.h"

#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief Whether a pair of links needs no check since one of them is attached. Bodies that one link carries may touch
        each other, as they do for MoveIt: they never move against each other. */
    bool mayTouch(const std::vector<AttachedBody> &attached, const LinkPair &pair);

    /** \brief Whether one of a pair is an obstacle */
    bool isOfAny(const std::vector<TouchableObstacle> &obstacles, const LinkPair &pair);

    /** \brief Add the pairs of each obstacle and the links that must not touch it. Those in \e free may touch all. */
    void addPairs(const std::vector<TouchableObstacle> &obstacles, const KinematicTree &tree,
                  const std::vector<std::string> &free, std::vector<LinkPair> &pairs);

    /** \brief Drop the pairs that never move towards each other.
        \return those of them that collide, in all states; they stay */
    std::vector<LinkPair> dropPairsThatStay(const Arm &arm, std::vector<LinkPair> &pairs);

    /** \brief Drop the pairs that collide in all random states, but none of an obstacle.
        \param staying those that collide without moving
        \return those that were dropped */
    std::vector<LinkPair> dropPairsThatAlwaysCollide(const Arm &arm, const std::vector<LinkPair> &staying,
                                                     const std::vector<TouchableObstacle> &obstacles,
                                                     std::vector<LinkPair> &pairs);
}

#endif
