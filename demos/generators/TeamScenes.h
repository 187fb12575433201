#ifndef OMPL_CERTIFICATES_GENERATORS_TEAM_SCENES_
#define OMPL_CERTIFICATES_GENERATORS_TEAM_SCENES_

#include "generators/SceneTexts.h"

#include <cstdint>

namespace generators
{
    /** \brief What scenes for large teams to make. The same settings give the same text on every machine. */
    struct TeamSettings
    {
        /** \brief The number of robots, from 1 to 1000 */
        unsigned int robots;

        /** \brief The number of random obstacles, at most 1000 */
        unsigned int obstacles;

        /** \brief The side of the square that robots are in, at most 1000 */
        double size;

        /** \brief The seed; another seed makes another scene */
        std::uint64_t seed{1};
    };

    /** \brief A kind of scenes for large teams. Starts and goals are random and valid, and each robot alone can go from
        its start to its goal. In nearly all scenes the team can, too. */
    struct TeamKind
    {
        std::string name;

        /** \brief What its scenes are, in one line */
        std::string description;

        TeamSettings defaults;

        /** \brief The smallest size */
        double smallest;

        /** \brief Whether it has random obstacles; if not, their number must be 0 */
        bool hasObstacles;

        /** \brief What make() calls */
        SceneTexts (*sketch)(const TeamSettings &);

        /** \brief The scene of \e settings
            \throws ompl::Exception if a setting makes no sense, or no place was found for a robot */
        SceneTexts make(const TeamSettings &settings) const;
    };

    /** \brief All of them: boxes, discs, warehouse, window, drones and mixed */
    const std::vector<TeamKind> &teamKinds();
}

#endif
