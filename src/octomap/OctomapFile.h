#ifndef OMPL_CERTIFICATES_OCTOMAP_OCTOMAP_FILE_
#define OMPL_CERTIFICATES_OCTOMAP_OCTOMAP_FILE_

#include "MapNodes.h"

#include "ompl_certificates/octomap/OctomapMessage.h"

#include <string>

namespace ompl_certificates
{
    /** \brief The map in a .bt or .ot file, as octomap reads it
        \throws ompl::Exception that names the file if it cannot be read, is damaged or holds another kind of map */
    MapNodes readOctomap(const std::string &file);

    /** \brief The map in a message
        \throws ompl::Exception that names the field if it is damaged or holds another kind of map */
    MapNodes readOctomap(const OctomapMessage &message);
}

#endif
