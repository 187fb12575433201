#ifndef OMPL_CERTIFICATES_SCENE_MESH_SCENE_
#define OMPL_CERTIFICATES_SCENE_MESH_SCENE_

#include <cstdint>
#include <map>
#include <string>

namespace ompl_certificates
{
    /** \brief Makes scenes whose obstacles and robots are meshes: the text of a YAML file and of the OBJ files that it
        names. The same settings give the same text on every machine. That a team can stand at its start and at its goal
        is made sure of; that there is a way between them is not, though in most there is. */
    class MeshScene
    {
    public:
        /** \brief What to make */
        struct Settings
        {
            /** \brief The number of robots, from 1 to 12 */
            unsigned int robots{3};

            /** \brief The seed; another seed makes another scene */
            std::uint64_t seed{1};
        };

        /** \brief In the plane: carts in the shape of an L in a maze of upright walls, about 1000 triangles
            \throws ompl::Exception if a setting makes no sense */
        static MeshScene maze(const Settings &settings);

        /** \brief In space: quadrotors in a canyon, 115200 triangles
            \throws ompl::Exception if a setting makes no sense, or no place was found for a robot */
        static MeshScene canyon(const Settings &settings);

        /** \brief In space: gears of two sizes among knots, of 2560 triangles each, all of one mesh
            \throws ompl::Exception if a setting makes no sense, or no place was found for a robot */
        static MeshScene knots(const Settings &settings);

        /** \brief Write the scene to \e file, and its meshes next to it
            \throws ompl::Exception that names the file if one cannot be written */
        void write(const std::string &file) const;

    private:
        std::string yaml_;
        std::map<std::string, std::string> meshes_;
    };
}

#endif
