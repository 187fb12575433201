#ifndef OMPL_CERTIFICATES_GENERATORS_CLOUD_SCENES_
#define OMPL_CERTIFICATES_GENERATORS_CLOUD_SCENES_

#include "generators/SceneTexts.h"
#include "ompl_certificates/geometry/Body.h"

#include <Eigen/Core>
#include <vector>

namespace generators
{
    /** \brief Points of the surfaces of \e bodies, as a sensor might see them; not those inside another one
        \param count how many
        \param noise the largest error along each axis */
    std::vector<Eigen::Vector3d> sampleSurfaces(const std::vector<ompl_certificates::PlacedBody> &bodies,
                                                std::size_t count, double noise, SeededRandom &random);

    /** \brief The settings of a scene with a cloud */
    struct CloudSettings
    {
        /** \brief The number of robots, from 1 to 6 */
        unsigned int robots{4};

        /** \brief The number of points, from 100 to 1000000 */
        unsigned int points{6000};

        /** \brief The seed; another seed makes another scene */
        std::uint64_t seed{1};
    };

    /** \brief In space: drones that cross a building of which only a point cloud is known
        \throws ompl::Exception if a setting makes no sense */
    SceneTexts droneCloud(const CloudSettings &settings);
}

#endif
