#ifndef OMPL_CERTIFICATES_SCENE_SCENE_FILE_
#define OMPL_CERTIFICATES_SCENE_SCENE_FILE_

#include "ompl_certificates/scene/Scene.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    /** \brief What a scene file holds: the scene and, in a .cfg file of OMPL.app, what to benchmark in it */
    struct SceneFile
    {
        /** \brief A planner to be benchmarked. The same one may be given several times, with other parameters. */
        struct Planner
        {
            /** \brief What the file calls it, in lower case: rrt, kpiece, spars2, ... */
            std::string type;

            /** \brief The value of its parameter "name"; empty if it has none */
            std::string title;

            /** \brief Its other parameters and their values, in the order of the file */
            std::vector<std::pair<std::string, std::string>> parameters;
        };

        /** \brief The scene */
        Scene scene;

        /** \brief The planners, in the order of the file; none in YAML */
        std::vector<Planner> planners;

        /** \brief The time for each run, in seconds, if the file gives it */
        std::optional<double> timeLimit;

        /** \brief The memory for each run, in megabytes, if the file gives it */
        std::optional<double> memoryLimit;

        /** \brief The number of runs of each planner, if the file gives it */
        std::optional<unsigned int> runCount;
    };

    /** \brief Read \e file: a .cfg file of OMPL.app if its name ends so, else YAML in the format of
        docs/scene-format.md. Files of db-CBS and dynoplan are read as they are, if their robots are of the types
        that are described there.

        Reading is strict: a key that is not known, or a value that makes no sense, is an error. It is not checked
        whether the team can stand at its start and goal; see Scene::validate().

        A .cfg file has one robot and one environment, both meshes, which are looked for next to it. The problem is
        planar, in SE(2), if neither z nor an axis is given, and else in SE(3). As in OMPL.app, a state gives the
        position of the mean of the robot's vertices; see MeshFile::makeRobot(). Without a volume, the bounds are the
        environment's box. Bounds that leave out the start or the goal are widened to hold both. What is known to
        OMPL.app but makes no difference here, such as an objective, is told in the scene's notes.
        \param dynamics whether robots move by controls: they are DynamicRobots, with the limits of db-CBS, and their
        starts and goals have velocities. Only for YAML whose robots are of db-CBS's types.
        \throws ompl::Exception with a message of one line if a file cannot be read or anything in it is wrong. Such are
        "room.yaml:7: robots[1].shape.radius: must be positive, not -1" and
        "maze.cfg: [problem] start.x: must be a number, not 'here'".

        @par External documentation
        ompl_benchmark(1), and benchmark/example_complex.cfg in https://github.com/ompl/omplapp */
    SceneFile readSceneFile(const std::string &file, bool dynamics = false);

    /** \brief The scene in \e file
        \throws ompl::Exception as readSceneFile() does */
    Scene loadScene(const std::string &file, bool dynamics = false);

    /** \brief The scene in \e text, which is YAML. Messages name \e source in place of a file, and meshes are looked
        for in its folder.
        \throws ompl::Exception as readSceneFile() does */
    Scene sceneFromYaml(const std::string &text, const std::string &source, bool dynamics = false);
}

#endif
