#ifndef OMPL_CERTIFICATES_SCENE_OMPL_APP_SCENE_
#define OMPL_CERTIFICATES_SCENE_OMPL_APP_SCENE_

#include "ompl_certificates/scene/Scene.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    class CfgFile;

    /** \brief A scene from a .cfg file of OMPL.app: one robot and one environment, both meshes, and what to benchmark.

        The problem is planar, in SE(2), if neither z nor an axis is given, and else in SE(3). Meshes are looked for next
        to the file. As in OMPL.app, a state gives the position of the mean of the robot's vertices (see
        MeshFile::makeRobot()); without a volume, the bounds are the environment's box; and bounds that leave out the
        start or the goal are widened to hold both.

        Reading is strict: all errors are thrown as ompl::Exception with a message of one line, such as
        "maze.cfg: [problem] start.x: must be a number, not 'here'". What is known to OMPL.app but makes no difference
        here, such as an objective, is told in the notes.

        @par External documentation
        ompl_benchmark(1), and benchmark/example_complex.cfg in https://github.com/ompl/omplapp */
    class OmplAppScene : public Scene
    {
    public:
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

        /** \brief Read \e file and the meshes that it names. It is not checked whether the robot can stand at its start
            and goal; see validate().
            \throws ompl::Exception if a file cannot be read or anything in it is wrong */
        explicit OmplAppScene(const std::string &file);

        /** \brief The planners, in the order of the file */
        const std::vector<Planner> &getPlanners() const
        {
            return planners_;
        }

        /** \brief The time for each run, in seconds, if the file gives it */
        std::optional<double> getTimeLimit() const
        {
            return timeLimit_;
        }

        /** \brief The memory for each run, in megabytes, if the file gives it */
        std::optional<double> getMemoryLimit() const
        {
            return memoryLimit_;
        }

        /** \brief The number of runs of each planner, if the file gives it */
        std::optional<unsigned int> getRunCount() const
        {
            return runCount_;
        }

    private:
        explicit OmplAppScene(const CfgFile &file);

        void readPlanners(const CfgFile &file);

        std::vector<Planner> planners_;
        std::optional<double> timeLimit_, memoryLimit_;
        std::optional<unsigned int> runCount_;
    };
}

#endif
