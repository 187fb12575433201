#ifndef OMPL_CERTIFICATES_GENERATORS_TEAM_PLACES_
#define OMPL_CERTIFICATES_GENERATORS_TEAM_PLACES_

#include "generators/SeededRandom.h"
#include "ompl_certificates/obstacles/Obstacles.h"
#include "ompl_certificates/team/TeamStateSpace.h"

#include <Eigen/Geometry>
#include <vector>

namespace generators
{
    /** \brief Positions between two corners; planar if both have z = 0 */
    using Zone = Eigen::AlignedBox3d;

    /** \brief Where a robot may start and end: positions in zones when they are looked for, then states */
    template <typename Place>
    struct Ends
    {
        Place start, goal;
    };

    /** \brief The coordinates of a state, as in scene files */
    using Coordinates = std::vector<double>;

    /** \brief Random starts and goals for all robots of a team.

        Starts are valid together, and so are goals, as the library's checker says. A ball around each robot can go from
        its start to its goal through the largest connected part of free space, if the other robots make room.
        \param zones for each robot; robots stay inside \e workspace whatever the zones
        \throws ompl::Exception if no place was found for a robot */
    std::vector<Ends<Coordinates>> placeTeam(const ompl_certificates::TeamStateSpacePtr &team,
                                             const ompl_certificates::ObstaclesPtr &obstacles, const Zone &workspace,
                                             const std::vector<Ends<Zone>> &zones, SeededRandom &random);
}

#endif
