#ifndef OMPL_CERTIFICATES_GENERATORS_RANDOM_POLYGONS_
#define OMPL_CERTIFICATES_GENERATORS_RANDOM_POLYGONS_

#include "ompl_certificates/scene/Scene.h"

#include <cstdint>
#include <string>

namespace generators
{
    /** \brief What scenes like those of the paper to make: discs among random convex polygons in a square. Lengths are
        in the scene's unit. */
    struct PolygonSettings
    {
        /** \brief The number of discs, from 1 to 100 */
        unsigned int robots{5};

        /** \brief The number of polygons, at most 10000 */
        unsigned int obstacles{25};

        /** \brief The side of the square */
        double size{100.0};

        /** \brief The radius of the discs */
        double radius{1.0};

        /** \brief The radii of the circles that the polygons' corners lie on, as fractions of the square's side */
        double smallest{0.02}, largest{0.06};

        /** \brief The seed; another seed makes another scene */
        std::uint64_t seed{1};
    };

    /** \brief The text of a YAML file, the same one for the same settings on every machine. The team can stand at its
        start and at its goal; that there is a way between them is not made sure of.
        \throws ompl::Exception if a setting makes no sense, or no place was found for a robot

        @par External documentation
        J. Bialkowski, M. Otte, E. Frazzoli, Fast Collision Checking: From Single Robots to Multi-Robot Teams, 2013,
        section III: the experiments. */
    std::string randomPolygonsYaml(const PolygonSettings &settings);

    /** \brief The scene of that text
        \throws ompl::Exception as randomPolygonsYaml() does */
    ompl_certificates::Scene randomPolygons(const PolygonSettings &settings);
}

#endif
