#ifndef OMPL_CERTIFICATES_SCENE_YAML_ATTACHED_
#define OMPL_CERTIFICATES_SCENE_YAML_ATTACHED_

#include "YamlMeshes.h"
#include "YamlNode.h"
#include "ompl_certificates/scene/ArmFile.h"

#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief Add the bodies that an arm carries to those of the other parts of its mechanism, which may name the same
        ones. */
    void readAttached(const YamlNode &list, YamlMeshes &meshes, std::vector<AttachedBody> &all);

    /** \brief Add the obstacles that some links may touch, in the same way. */
    void readTouchable(const YamlNode &list, YamlMeshes &meshes, std::vector<TouchableObstacle> &all);

    /** \brief The names that \e list has, which are of links */
    std::vector<std::string> readLinkNames(const YamlNode &list);
}

#endif
