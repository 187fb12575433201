#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_EXPERIMENT_GRID_
#define OMPL_CERTIFICATES_DEMOS_COMMON_EXPERIMENT_GRID_

#include "ompl_certificates/scene/Scene.h"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace demos
{
    /** \brief What an experiment is made of: scenes with team sizes, planners, methods, and a number of trials, each
        combined with each. Read from a YAML file; docs/experiments.md describes it. */
    class ExperimentGrid
    {
    public:
        /** \brief A scene, and the sizes of the teams to plan for in it */
        struct Workspace
        {
            std::string name;

            /** \brief The scene with as many robots as the largest team has */
            std::shared_ptr<const ompl_certificates::Scene> scene;

            std::vector<unsigned int> robots;
        };

        /** \brief One of OMPL's planners with parameters */
        struct Planner
        {
            /** \brief What it is called here; the name of its class if nothing else was said */
            std::string name;

            std::string plannerClass;
            std::vector<std::pair<std::string, std::string>> parameters;
        };

        /** \brief Read \e file, and try every scene and every planner once
            \throws ompl::Exception that names the file, the line, the key and the value if anything in it is wrong */
        explicit ExperimentGrid(const std::string &file);

        std::string name;
        std::vector<Workspace> workspaces;
        std::vector<Planner> planners;

        /** \brief The methods; the standard one first if it is there */
        std::vector<ompl_certificates::Method> methods;

        unsigned int trials{1};

        /** \brief Trial i, counted from 1, is seeded with seed + i - 1 */
        std::uint32_t seed{1};

        /** \brief How often the planner's termination condition is evaluated; 0 to plan for some time instead */
        std::uint64_t iterations{0};
        double seconds{0.0};

        /** \brief How often per tenfold number of iterations a record is made */
        unsigned int recordsPerDecade{10};

        /** \brief Whether the time in the planner's nearest-neighbor structure is recorded */
        bool timeNearest{true};

        /** \brief Whether there is a goal to reach; without one, trees grow until the iterations are used up */
        bool goal{true};

        /** \brief Whether methods step aside where certificates have not paid lately. That is judged by the clock, so
            that counts need not repeat themselves. */
        bool adaptive{false};

        /** \brief The longest valid segment as a fraction of a component's extent; 0 for the scenes' */
        double resolution{0.0};

        ompl_certificates::NearestStructure nearest{ompl_certificates::NearestStructure::KD_TREE};

        /** \brief The text of the file */
        std::string text;

        /** \brief A hash of all that results depend on: the text, those of the scenes' files, and the version of this
            program; 16 hexadecimal digits */
        std::string hash;

        /** \brief A planner, set up for a team
            \throws ompl::Exception if it refuses a parameter */
        void givePlanner(const Planner &planner, ompl_certificates::TeamSetup &setup) const;
    };
}

#endif
