#ifndef OMPL_CERTIFICATES_SCENE_OBJ_TEXT_
#define OMPL_CERTIFICATES_SCENE_OBJ_TEXT_

#include <string>

namespace ompl_certificates
{
    /** \brief Of a Wavefront OBJ file, \e text, the lines that make up its meshes, in a form that Assimp can be trusted with.

        Assimp would open whatever other file such a one names as its materials, and pass over vertices and faces that
        are indented, or that have another number of coordinates than it knows.
        \throws std::runtime_error if there is none, or a vertex has neither 3, 4 nor 6 coordinates
        Cost: some milliseconds for a megabyte, and the size of the file in memory */
    std::string plainObj(const std::string &text);
}

#endif
