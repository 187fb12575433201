#ifndef OMPL_CERTIFICATES_SCENE_OMPL_APP_READER_
#define OMPL_CERTIFICATES_SCENE_OMPL_APP_READER_

#include "ompl_certificates/scene/SceneFile.h"

namespace ompl_certificates
{
    /** \brief Read a .cfg file of OMPL.app, and the meshes that it names. */
    SceneFile readOmplApp(const std::string &file);
}

#endif
