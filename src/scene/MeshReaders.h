#ifndef OMPL_CERTIFICATES_SCENE_MESH_READERS_
#define OMPL_CERTIFICATES_SCENE_MESH_READERS_

#include "MeshPart.h"

#include <string_view>

namespace ompl_certificates
{
    /** \brief Read the content of a Wavefront OBJ file. Of its groups, objects and materials each makes a part; what is
        neither vertices nor faces, lines and points is left out.
        \throws std::runtime_error that names line and value if there is something wrong, as the other readers do */
    void readObj(std::string_view content, MeshCollector &mesh);

    /** \brief Read the content of an STL file. It is binary if its size is what its number of facets needs, else a
        text. */
    void readStl(std::string_view content, MeshCollector &mesh);

    /** \brief Read the content of a PLY file, binary or a text. Elements and properties other than the vertices and
        faces may be there. */
    void readPly(std::string_view content, MeshCollector &mesh);

    /** \brief Read the content of a COLLADA file: all geometries where the nodes of its scene place them, in meters and
        with the y axis up unless MeshCollector::keepsAxes. Skins and morphs are the meshes that they are made of. */
    void readCollada(std::string_view content, MeshCollector &mesh);
}

#endif
