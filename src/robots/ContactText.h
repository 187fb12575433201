#ifndef OMPL_CERTIFICATES_ROBOTS_CONTACT_TEXT_
#define OMPL_CERTIFICATES_ROBOTS_CONTACT_TEXT_

#include "ompl_certificates/robots/Robot.h"

#include <string>

namespace ompl_certificates
{
    /** \brief What messages call a body: that of an arm by its link, others by their number; nothing if a robot moves
        one body alone */
    std::string nameOfBody(const Robot &robot, std::size_t body);

    /** \brief Whether a body is an obstacle or a zone that counts for its robot alone */
    bool isOwnObstacle(const Robot &robot, std::size_t body);

    /** \brief What a robot touches with \e body, such as "touches environment.obstacles[2] with link 'hand'" */
    std::string describeTouch(const Robot &robot, std::size_t body, const std::string &obstacle);

    /** \brief The contact of a pair of a robot's own bodies, such as "touches itself: link 'hand' and link 'foot'" */
    std::string describeOwnContact(const Robot &robot, const BodyPair &pair);

    /** \brief The bodies of two robots that touch each other, as the end of a message, such as ": link 'hand' of 'left'
        and body 0 of 'car'"; nothing if neither moves more than one body */
    std::string describeContact(const Robot &first, std::size_t body, const Robot &second, std::size_t otherBody);
}

#endif
