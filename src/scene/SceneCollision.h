#ifndef OMPL_CERTIFICATES_SCENE_SCENE_COLLISION_
#define OMPL_CERTIFICATES_SCENE_SCENE_COLLISION_

#include "ompl_certificates/scene/Scene.h"

#include <optional>
#include <string>

namespace ompl_certificates
{
    /** \brief One of the collisions of a state of a scene's team, in the words of messages */
    struct SceneCollision
    {
        /** \brief The places of the robots in the team; both are the same one unless two robots touch */
        unsigned int robot, other;

        /** \brief What a robot does alone, such as "touches environment.obstacles[0] with link 'hand'" */
        std::string touch;

        /** \brief Of two robots ": link 'hand' of 'left' and body 1 of 'cart'", as the end of a message. Empty if
            neither moves more than one body. */
        std::string bodies;

        /** \brief ": both have link 'base' there; …", as the end of a message, if two arms seem to be one mechanism */
        std::string hint;
    };

    /** \brief Look for a collision of \e state: first with obstacles, then of robots with themselves, then of two
        robots. It takes longer than a check, once there is one.
        \param team what scene.makeTeam() made */
    std::optional<SceneCollision> findCollision(const Scene &scene, const TeamStateSpacePtr &team,
                                                const ompl::base::State *state);
}

#endif
