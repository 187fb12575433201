#ifndef OMPL_CERTIFICATES_SCENE_KNOWN_ROBOT_TYPE_
#define OMPL_CERTIFICATES_SCENE_KNOWN_ROBOT_TYPE_

#include "StateLayout.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief A kind of robot of db-CBS: its body, its states, and how many velocities its states list after the pose */
    struct KnownRobotType
    {
        const char *name;
        StateLayout layout;
        double size[2];  // a disc's radius and 0, or the sides of a box
        std::size_t velocities;
    };

    /** \brief The type of that name, or null. db-CBS writes the version "_0" into most of them, and not into some. */
    const KnownRobotType *findKnownRobotType(std::string name);

    /** \brief The names of all types, without versions */
    std::vector<std::string> namesOfKnownRobotTypes();
}

#endif
