#ifndef OMPL_CERTIFICATES_SCENE_COLLADA_CHECK_
#define OMPL_CERTIFICATES_SCENE_COLLADA_CHECK_

#include <string>

namespace ompl_certificates
{
    /** \brief Refuse a COLLADA file, \e text, that Assimp would never come to an end with, read beyond, or make room for more
        than it holds for: its counts and indices have to be numbers, and no larger than the file.
        \throws std::runtime_error if it is such a file, or not XML */
    void checkCollada(const std::string &text);
}

#endif
