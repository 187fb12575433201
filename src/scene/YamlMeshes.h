#ifndef OMPL_CERTIFICATES_SCENE_YAML_MESHES_
#define OMPL_CERTIFICATES_SCENE_YAML_MESHES_

#include "YamlNode.h"
#include "ompl_certificates/scene/MeshFile.h"

#include <array>
#include <map>
#include <string>
#include <utility>

namespace ompl_certificates
{
    /** \brief Reads the mesh shapes of a scene. Every file is read once, and equal shapes are one body: robots and
        obstacles then share its triangles, and whatever is made of them. */
    class YamlMeshes
    {
    public:
        /** \brief The body of the mesh shape that \e node describes: file, scale, reference and
            keep_axes, turned by \e rotation */
        Body read(const YamlNode &node, unsigned int dimension, const Eigen::Matrix3d &rotation);

    private:
        /** \brief The file of a mesh shape */
        const MeshFile &fileOf(const YamlNode &node);

        /** \brief What makes a shape: its mesh file, the linear part of its transform, whether it is about its mean */
        using Key = std::tuple<const MeshFile *, std::array<double, 9>, bool>;

        /** \brief By their paths, and whether they keep their axes */
        std::map<std::pair<std::string, bool>, MeshFile> files_;
        std::map<Key, Body> bodies_;
    };
}

#endif
