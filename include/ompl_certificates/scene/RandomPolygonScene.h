#ifndef OMPL_CERTIFICATES_SCENE_RANDOM_POLYGON_SCENE_
#define OMPL_CERTIFICATES_SCENE_RANDOM_POLYGON_SCENE_

#include "ompl_certificates/scene/YamlScene.h"

#include <cstdint>
#include <string>

namespace ompl_certificates
{
    /** \brief Makes scenes like those of the paper: discs among random convex polygons in a square.

        The same settings give the same text on every machine. That a team can stand at its start and at its goal is
        made sure of, that there is a way between them is not.

        @par External documentation
        J. Bialkowski, M. Otte, E. Frazzoli, Fast Collision Checking: From Single Robots to Multi-Robot Teams, 2013,
        section III: the experiments. */
    class RandomPolygonScene
    {
    public:
        /** \brief What to make; lengths are in the scene's unit */
        struct Settings
        {
            /** \brief The number of discs, from 1 to 100 */
            unsigned int robots{5};

            /** \brief The number of polygons, at most 10000 */
            unsigned int obstacles{25};

            /** \brief The side of the square */
            double size{100.0};

            /** \brief The radius of the discs */
            double radius{1.0};

            /** \brief The least radius of the circles that the polygons' corners lie on, as a fraction of the square's side */
            double smallest{0.02};

            /** \brief The largest radius of those circles */
            double largest{0.06};

            /** \brief The seed; another seed makes another scene */
            std::uint64_t seed{1};
        };

        /** \brief A generator
            \throws ompl::Exception if a setting makes no sense */
        explicit RandomPolygonScene(const Settings &settings);

        /** \brief The scene as the text of a YAML file
            \throws ompl::Exception if no place was found for a robot */
        std::string toYaml() const;

        /** \brief The scene itself
            \throws ompl::Exception if no place was found for a robot */
        YamlScene make() const;

    private:
        Settings settings_;
    };
}

#endif
