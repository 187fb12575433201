#ifndef OMPL_CERTIFICATES_SCENE_URDF_ELEMENTS_
#define OMPL_CERTIFICATES_SCENE_URDF_ELEMENTS_

#include "XmlFile.h"

#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief Notes on what a URDF file has of links and joints, and urdfdom passes over in silence: elements and
        attributes that URDF does not know, such as misspelled ones, and the second of what may be there once. Names with
        a colon are those of other programs. */
    std::vector<std::string> unknownElements(const XmlFile &urdf);

    /** \brief The links with a \e visual element and no \e collision element, or the other way round
        \param has the element that they have
        \param lacks the one that they do not have */
    std::vector<std::string> linksWithout(const XmlFile &urdf, const char *has, const char *lacks);
}

#endif
