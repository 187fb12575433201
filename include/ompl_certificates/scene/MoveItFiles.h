#ifndef OMPL_CERTIFICATES_SCENE_MOVE_IT_FILES_
#define OMPL_CERTIFICATES_SCENE_MOVE_IT_FILES_

#include "ompl_certificates/scene/ArmFile.h"
#include "ompl_certificates/scene/SceneFile.h"

#include <string>

namespace ompl_certificates
{
    /** \brief Whether \e file is a planning scene of MoveIt in YAML, by its keys. A pipe is not, for it can
        be read but once. Neither is a .cfg file.
        \throws ompl::Exception if the file cannot be read, or is not valid YAML */
    bool isMoveItScene(const std::string &file);

    /** \brief Read what MoveIt calls a planning scene and a motion plan request, from YAML files as MotionBenchMaker
        has them: a scene with one arm.

        Of the scene: the obstacles (boxes, cylinders, cones, spheres, meshes, planes and an octomap), fixed frames,
        the robot's state, the objects that it holds, and the allowed collision matrix. A cone is the pyramid of 128
        sides around it, a plane a square that reaches beyond the arm. The matrix replaces what the SRDF file says of
        pairs of links, as in MoveIt. Of the request: the group, the start, and goals, any of which will do: all
        joints of the group, or the pose of a link. The start has the joints that it does not name as in the scene's
        state. Joints outside of the group keep their values of the start. The request's time is SceneFile::timeLimit.

        Motions are checked as densely as MoveIt does by default: Scene::getResolution() is 0.005. The bounds of the
        scene are those of the request's workspace, enlarged to hold the obstacles and the arm's start and goal.

        Reading is strict, as of other scenes. What would change the plan and is not supported is an error: octomaps
        that links may touch, scales of links, planes of attached bodies, other constraints; see docs/arms.md.
        \param scene the file of the planning scene
        \param request the file of the motion plan request
        \param robot the robot; its name need not be that of the scene
        \throws ompl::Exception with one line that names the file, the line, the key and the value */
    SceneFile readMoveItFiles(const std::string &scene, const std::string &request, const ArmFile &robot);
}

#endif
