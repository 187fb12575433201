#ifndef OMPL_CERTIFICATES_SCENE_SCENE_FILE_
#define OMPL_CERTIFICATES_SCENE_SCENE_FILE_

#include "ompl_certificates/scene/Scene.h"

#include <memory>
#include <string>

namespace ompl_certificates
{
    /** \brief The scene in \e file: an OmplAppScene if its name ends with .cfg, else a YamlScene. It is not checked
        whether the team can stand at its start and goal; see Scene::validate().
        \throws ompl::Exception if the file cannot be read or anything in it is wrong */
    std::unique_ptr<Scene> loadScene(const std::string &file);
}

#endif
