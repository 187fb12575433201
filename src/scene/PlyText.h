#ifndef OMPL_CERTIFICATES_SCENE_PLY_TEXT_
#define OMPL_CERTIFICATES_SCENE_PLY_TEXT_

#include <string>

namespace ompl_certificates
{
    /** \brief The vertices and faces of a PLY file, \e text, in the plain form that Assimp reads as it is meant.

        Assimp believes what a file says of the length of its lists, and takes some comments for elements: a few bytes could
        make it ask for all memory there is. So the whole file is followed here first. Comments and what comes after the
        vertices and faces are left out.
        \throws std::runtime_error if the file is not PLY, or does not hold what its header and its lists say */
    std::string plainPly(const std::string &text);
}

#endif
