#ifndef OMPL_CERTIFICATES_SCENE_COLLADA_TEXT_
#define OMPL_CERTIFICATES_SCENE_COLLADA_TEXT_

#include <string>

namespace ompl_certificates
{
    /** \brief Of a COLLADA file, \e text, the meshes and where they are, in a form that Assimp can be trusted with. Bones,
        movements, materials, cameras, lights and what is extra are left out.

        Assimp believes what a file says of itself. So files are refused that have more or less of something than they say,
        that refer to what is not there or there twice, that would become much larger than they are, or whose nodes are
        instances of each other without end.
        \throws std::runtime_error if it is such a file, or not XML
        Cost: some milliseconds for a megabyte, and a few times the file in memory */
    std::string plainCollada(const std::string &text);
}

#endif
