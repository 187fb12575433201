#ifndef OMPL_CERTIFICATES_GENERATORS_MESH_SCENES_
#define OMPL_CERTIFICATES_GENERATORS_MESH_SCENES_

#include "generators/SceneTexts.h"

#include <cstdint>

namespace generators
{
    /** \brief What scenes of meshes to make. The same settings give the same text on every machine. A team can stand at
        its start and at its goal; that there is a way between them is not made sure of, though in most there is. */
    struct MeshSettings
    {
        /** \brief The number of robots, from 1 to 12 */
        unsigned int robots{3};

        /** \brief The seed; another seed makes another scene */
        std::uint64_t seed{1};
    };

    /** \brief In the plane: carts in the shape of an L in a maze of upright walls, about 1000 triangles
        \throws ompl::Exception if a setting makes no sense */
    SceneTexts mazeOfMeshes(const MeshSettings &settings);

    /** \brief In space: quadrotors in a canyon, 115200 triangles
        \throws ompl::Exception if a setting makes no sense, or no place was found for a robot */
    SceneTexts canyonOfMeshes(const MeshSettings &settings);

    /** \brief In space: gears of two sizes among knots, of 2560 triangles each, all of one mesh
        \throws ompl::Exception if a setting makes no sense, or no place was found for a robot */
    SceneTexts knotsOfMeshes(const MeshSettings &settings);
}

#endif
