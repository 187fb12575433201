#ifndef OMPL_CERTIFICATES_GENERATORS_MESH_SCENES_
#define OMPL_CERTIFICATES_GENERATORS_MESH_SCENES_

#include <cstdint>
#include <map>
#include <string>

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

    /** \brief A scene whose obstacles and robots are meshes, as the texts of its files */
    struct MeshSceneTexts
    {
        /** \brief The YAML file. @ stands for what the names of its meshes begin with. */
        std::string yaml;

        /** \brief The OBJ files, by the ends of their names */
        std::map<std::string, std::string> meshes;
    };

    /** \brief In the plane: carts in the shape of an L in a maze of upright walls, about 1000 triangles
        \throws ompl::Exception if a setting makes no sense */
    MeshSceneTexts mazeOfMeshes(const MeshSettings &settings);

    /** \brief In space: quadrotors in a canyon, 115200 triangles
        \throws ompl::Exception if a setting makes no sense, or no place was found for a robot */
    MeshSceneTexts canyonOfMeshes(const MeshSettings &settings);

    /** \brief In space: gears of two sizes among knots, of 2560 triangles each, all of one mesh
        \throws ompl::Exception if a setting makes no sense, or no place was found for a robot */
    MeshSceneTexts knotsOfMeshes(const MeshSettings &settings);

    /** \brief Write the scene to \e file, and its meshes next to it
        \throws ompl::Exception that names the file if one cannot be written */
    void writeScene(const MeshSceneTexts &scene, const std::string &file);
}

#endif
