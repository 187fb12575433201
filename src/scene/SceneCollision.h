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
        /** \brief With what a robot collides */
        enum With
        {
            OBSTACLES,
            ITSELF,
            ROBOT
        };

        With with;

        /** \brief The places of the robots in the team. Both are the same one unless it is with a ROBOT. */
        unsigned int robot, other;

        /** \brief "touches environment.obstacles[0] with link 'hand'", with OBSTACLES alone */
        std::string touch;

        /** \brief ": link 'hand' of 'left' and body 1 of 'cart'", as the end of a message. Empty with OBSTACLES, or if
            no robot has more than one body. */
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
