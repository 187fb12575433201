#ifndef OMPL_CERTIFICATES_SCENE_YAML_ARMS_
#define OMPL_CERTIFICATES_SCENE_YAML_ARMS_

#include "YamlMeshes.h"
#include "YamlNode.h"
#include "ompl_certificates/scene/ArmFile.h"
#include "ompl_certificates/scene/Scene.h"

#include <filesystem>
#include <map>

namespace ompl_certificates
{
    /** \brief Reads the robots of a scene that come from URDF files. Every file is read once: equal arms share their
        meshes, and whatever is made of them. */
    class YamlArms
    {
    public:
        /** \brief Arms for the scene in the file \e source, whose folder their paths are relative to */
        explicit YamlArms(const std::string &source);

        /** \brief Read robot, start and goal of \e member from \e node; notes go to \e scene
            \param bounds of planar and floating joints */
        void read(const YamlNode &node, const std::string &name, const ompl::base::RealVectorBounds &bounds,
                  Scene &scene, YamlMeshes &meshes, Scene::Member &member);

    private:
        const ArmFile &fileOf(const YamlNode &node);
        std::string pathOf(const YamlNode &node) const;

        std::filesystem::path folder_;
        std::map<std::string, ArmFile> files_;
    };
}

#endif
