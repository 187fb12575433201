#ifndef OMPL_CERTIFICATES_SCENE_URDF_GEOMETRY_
#define OMPL_CERTIFICATES_SCENE_URDF_GEOMETRY_

#include "ompl_certificates/scene/ArmFile.h"
#include "ompl_certificates/scene/MeshFile.h"

#include <filesystem>
#include <map>
#include <optional>
#include <tuple>
#include <urdf_model/link.h>

namespace ompl_certificates
{
    /** \brief Makes bodies of the links of a URDF file. Each mesh file is read once, and equal meshes are one shape. */
    class UrdfGeometry
    {
    public:
        /** \brief The geometry of links in \e file */
        UrdfGeometry(const std::string &file, const ArmFile::Options &options);

        /** \brief The body of \e link; none if it has no geometry
            \throws ompl::Exception that names the file, the link, the size or the mesh and what is wrong */
        std::optional<Body> bodyOf(const urdf::Link &link);

    private:
        Shape shapeOf(const urdf::Geometry &geometry);
        Shape meshOf(const urdf::Mesh &mesh);
        std::filesystem::path find(const std::string &name) const;

        /** \brief The file package://rest
            \param name what messages call it */
        std::filesystem::path findInPackage(const std::string &name, const std::string &rest) const;

        /** \brief The folder of the URDF file */
        std::filesystem::path folder() const;

        const std::string file_;
        const ArmFile::Options &options_;
        std::map<std::string, MeshFile> meshes_;
        std::map<std::tuple<std::string, double, double, double>, Shape> shapes_;
    };

    /** \brief A pose of urdfdom's */
    Pose poseOf(const urdf::Pose &pose);
}

#endif
