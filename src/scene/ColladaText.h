#ifndef OMPL_CERTIFICATES_SCENE_COLLADA_TEXT_
#define OMPL_CERTIFICATES_SCENE_COLLADA_TEXT_

#include <string>

namespace ompl_certificates
{
    /** \brief A COLLADA file, \e text, without the bones and movements of its meshes, in the form that Assimp can be trusted with.

        Files are refused that Assimp would never come to an end with, read beyond, or make room for more than they hold
        for: counts and indices have to be numbers, and no larger than the file, and nodes must not be instances of each
        other without end.
        \throws std::runtime_error if it is such a file, or not XML */
    std::string plainCollada(const std::string &text);
}

#endif
