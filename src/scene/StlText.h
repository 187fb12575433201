#ifndef OMPL_CERTIFICATES_SCENE_STL_TEXT_
#define OMPL_CERTIFICATES_SCENE_STL_TEXT_

#include <string>

namespace ompl_certificates
{
    /** \brief An STL file, \e text, binary or not, in a form that Assimp can be trusted with.

        Assimp would leave out what follows a line that it does not know, and the fourth corner of a facet.
        \throws std::runtime_error if it is neither, or has too many facets or solids
        Cost: some ten milliseconds for a megabyte of text, and the size of the file in memory */
    std::string plainStl(const std::string &text);
}

#endif
