#ifndef OMPL_CERTIFICATES_SCENE_COLLADA_CHECK_
#define OMPL_CERTIFICATES_SCENE_COLLADA_CHECK_

#include <cstddef>
#include <pugixml.hpp>

namespace ompl_certificates
{
    /** \brief The most levels in which the elements of a COLLADA file may be nested */
    constexpr std::size_t MOST_COLLADA_LEVELS = 1000;

    /** \brief Check what the meshes and nodes below \e root, the element COLLADA of a file of so many bytes as plainCollada()
        makes it, refer to. Assimp looks no further than at the indices.
        \throws std::runtime_error if something is not there or there twice, if there is more or less of it than is said, or
        if instances of nodes would become too many, or are of each other without end */
    void checkCollada(const pugi::xml_node &root, std::size_t bytes);
}

#endif
