#ifndef OMPL_CERTIFICATES_SCENE_OBJ_TEXT_
#define OMPL_CERTIFICATES_SCENE_OBJ_TEXT_

#include <string>

namespace ompl_certificates
{
    /** \brief Of a Wavefront OBJ file, \e text, the lines that make up its meshes, in a form that Assimp can be trusted with.

        Assimp would open whatever other file such a one names as its materials, pass over vertices that are indented or
        have numbers such as .5, and misread other faces.
        \throws std::runtime_error if a line cannot be understood, or there are too many
        Cost: some ten milliseconds for a megabyte, and the size of the file in memory */
    std::string plainObj(const std::string &text);
}

#endif
