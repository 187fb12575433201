#ifndef OMPL_CERTIFICATES_SCENE_STATE_LAYOUT_
#define OMPL_CERTIFICATES_SCENE_STATE_LAYOUT_

#include "YamlNode.h"

#include <cstddef>
#include <vector>

namespace ompl_certificates
{
    /** \brief What the numbers of a start or a goal are */
    enum class StateLayout
    {
        R2,
        R3,
        SE2,
        SE3,
        TRAILER
    };

    /** \brief The layout of a robot's space: what \e node names, in a workspace of \e dimension */
    StateLayout readLayout(const YamlNode &node, unsigned int dimension);

    /** \brief The pose that \e node lists. The velocities that follow it are left out unless they are to be kept. Angles
        are wrapped and quaternions normalised. */
    std::vector<double> readStateNumbers(const YamlNode &node, StateLayout layout, std::size_t velocities,
                                         bool keepVelocities);
}

#endif
