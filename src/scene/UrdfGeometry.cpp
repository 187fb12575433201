#include "UrdfGeometry.h"

#include "FileUri.h"
#include "YamlNode.h"

#include <boost/algorithm/string/trim.hpp>
#include <cstdlib>
#include <ompl/util/Exception.h>
#include <pugixml.hpp>
#include <sstream>

namespace ompl_certificates
{
    namespace fs = std::filesystem;

    namespace
    {
        std::string textOf(double value)
        {
            std::ostringstream text;
            text << value;
            return text.str();
        }

        /** What a size of 0 counts as: some files have it for links that are only frames. */
        constexpr double SIZE_OF_A_POINT = 1e-6;

        double sizeOf(const char *key, double value)
        {
            if (value == 0.0)
                return SIZE_OF_A_POINT;
            if (!(value >= YamlNode::MIN_SIZE && value <= YamlNode::MAX_NUMBER))
                throw ompl::Exception(std::string(key) + " must be 0, or from " + textOf(YamlNode::MIN_SIZE) + " to " +
                                      textOf(YamlNode::MAX_NUMBER) + ", not " + textOf(value));
            return value;
        }

        /** What follows \e prefix in \e text, if it begins so */
        std::optional<std::string> after(const std::string &prefix, const std::string &text)
        {
            if (text.compare(0, prefix.size(), prefix) != 0)
                return {};
            return text.substr(prefix.size());
        }

        bool isFile(const fs::path &path)
        {
            std::error_code error;
            return fs::exists(path, error) && !fs::is_directory(path, error);
        }

        [[noreturn]] void failWithoutMesh(const std::string &name, const std::string &where)
        {
            throw ompl::Exception("mesh '" + name + "' was not found " + where);
        }

        /** Whether \e folder says that it is a package of another name */
        bool isOtherPackage(const fs::path &folder, const std::string &package)
        {
            pugi::xml_document manifest;
            if (!isFile(folder / "package.xml") || !manifest.load_file((folder / "package.xml").c_str()))
                return false;
            const std::string name = manifest.document_element().child_value("name");
            return !name.empty() && boost::algorithm::trim_copy(name) != package;
        }

        /** The folders of a list in the environment, as ROS writes them */
        std::vector<fs::path> foldersOf(const char *variable)
        {
            std::vector<fs::path> folders;
            const char *const value = std::getenv(variable);
            std::istringstream list(value ? value : "");
            for (std::string folder; std::getline(list, folder, ':');)
                if (!folder.empty())
                    folders.emplace_back(folder);
            return folders;
        }

        /** Where ROS 2 and ROS 1 may have a package */
        std::vector<fs::path> packagesOfRos(const std::string &package)
        {
            std::vector<fs::path> packages;
            for (const fs::path &prefix : foldersOf("AMENT_PREFIX_PATH"))
                packages.push_back(prefix / "share" / package);
            for (const fs::path &folder : foldersOf("ROS_PACKAGE_PATH"))
            {
                packages.push_back(folder / package);
                if (folder.filename() == package)
                    packages.push_back(folder);
            }
            return packages;
        }
    }

    Pose poseOf(const urdf::Pose &pose)
    {
        const auto &q = pose.rotation;
        const auto &p = pose.position;
        const Eigen::Quaterniond rotation(q.w, q.x, q.y, q.z);
        const Eigen::Vector3d position(p.x, p.y, p.z);
        // Larger numbers would leave nothing of the others.
        if (!(std::abs(rotation.norm() - 1.0) < 1e-6) || !(position.cwiseAbs().array() <= YamlNode::MAX_NUMBER).all())
            throw ompl::Exception("the origin's numbers must be finite and at most " + textOf(YamlNode::MAX_NUMBER));
        Pose result = poseAt(position);
        result.linear() = rotation.normalized().toRotationMatrix();
        return result;
    }

    UrdfGeometry::UrdfGeometry(const std::string &file, const ArmFile::Options &options)
      : file_(file), options_(options)
    {
    }

    std::optional<Body> UrdfGeometry::bodyOf(const urdf::Link &link)
    {
        std::vector<Body::Part> parts;
        const auto add = [&](const char *element, std::size_t number, const urdf::GeometrySharedPtr &geometry,
                             const urdf::Pose &origin)
        {
            try
            {
                if (!geometry)
                    throw ompl::Exception("has no geometry");
                parts.push_back({shapeOf(*geometry), poseOf(origin)});
            }
            catch (const ompl::Exception &exception)
            {
                throw ompl::Exception(file_, "link '" + link.name + "': " + element + " " + std::to_string(number + 1) +
                                                 ": " + exception.what());
            }
        };
        if (options_.useVisuals)
            for (std::size_t i = 0; i < link.visual_array.size(); ++i)
                add("visual", i, link.visual_array[i]->geometry, link.visual_array[i]->origin);
        else
            for (std::size_t i = 0; i < link.collision_array.size(); ++i)
                add("collision", i, link.collision_array[i]->geometry, link.collision_array[i]->origin);
        if (parts.empty())
            return {};
        return Body(parts);
    }

    Shape UrdfGeometry::shapeOf(const urdf::Geometry &geometry)
    {
        if (const auto *box = dynamic_cast<const urdf::Box *>(&geometry))
            return Shape::box(Eigen::Vector3d(sizeOf("box size x", box->dim.x), sizeOf("box size y", box->dim.y),
                                              sizeOf("box size z", box->dim.z)));
        if (const auto *sphere = dynamic_cast<const urdf::Sphere *>(&geometry))
            return Shape::ball(3, sizeOf("sphere radius", sphere->radius));
        if (const auto *cylinder = dynamic_cast<const urdf::Cylinder *>(&geometry))
            return Shape::cylinder(sizeOf("cylinder radius", cylinder->radius),
                                   sizeOf("cylinder length", cylinder->length));
        if (const auto *mesh = dynamic_cast<const urdf::Mesh *>(&geometry))
            return meshOf(*mesh);
        throw ompl::Exception("its geometry is of a kind that is not known");
    }

    Shape UrdfGeometry::meshOf(const urdf::Mesh &mesh)
    {
        const fs::path path = find(mesh.filename);
        const Eigen::Vector3d scale(mesh.scale.x, mesh.scale.y, mesh.scale.z);
        std::ostringstream scaleText;
        scaleText << scale.transpose();
        for (const double factor : {scale.x(), scale.y(), scale.z()})
            if (!(std::abs(factor) >= YamlNode::MIN_SIZE && std::abs(factor) <= YamlNode::MAX_NUMBER))
                throw ompl::Exception("mesh '" + mesh.filename + "': scale must be finite and not zero, not " +
                                      scaleText.str());
        const auto key = std::make_tuple(path.string(), scale.x(), scale.y(), scale.z());
        if (const auto known = shapes_.find(key); known != shapes_.end())
            return known->second;
        auto file = meshes_.find(path.string());
        if (file == meshes_.end())
            file = meshes_.emplace(path.string(), MeshFile(path.string(), true)).first;
        Eigen::Affine3d transform = Eigen::Affine3d::Identity();
        transform.linear() = scale.asDiagonal();
        const TriangleMeshPtr triangles =
            scale == Eigen::Vector3d::Ones() ? file->second.getMesh() : file->second.transformed(transform);
        return shapes_.emplace(key, Shape::mesh(3, triangles)).first->second;
    }

    fs::path UrdfGeometry::folder() const
    {
        std::error_code error;
        return fs::absolute(fs::path(file_), error).parent_path().lexically_normal();
    }

    fs::path UrdfGeometry::find(const std::string &name) const
    {
        if (const auto path = pathOfFileUri(name))
        {
            if (!isFile(*path))
                failWithoutMesh(name, "there");
            return *path;
        }
        if (const auto rest = after("package://", name))
            return findInPackage(name, *rest);
        if (name.find("://") != std::string::npos)
            failWithoutMesh(name, "(only package:// and file:// can be read)");
        if (!isFile(folder() / name))
            failWithoutMesh(name, "in '" + folder().string() + "'");
        return (folder() / name).lexically_normal();
    }

    fs::path UrdfGeometry::findInPackage(const std::string &name, const std::string &rest) const
    {
        const std::size_t slash = rest.find('/');
        // Two slashes are as good as one.
        const std::size_t begin = rest.find_first_not_of('/', slash);
        const std::string package = rest.substr(0, slash),
                          path = begin == std::string::npos || slash == std::string::npos ? "" : rest.substr(begin);
        if (const auto known = options_.packages.find(package); known != options_.packages.end())
        {
            if (!isFile(fs::path(known->second) / path))
                failWithoutMesh(name, "in '" + known->second + "'");
            return (fs::path(known->second) / path).lexically_normal();
        }
        // The package is the folder of the URDF file or above it, or stands beside one of these. Packages often
        // have files of the same names, so a folder of another name counts last, and not if it says what it is.
        std::vector<fs::path> packages, candidates, others;
        for (fs::path above = folder(); !above.empty(); above = above.parent_path())
        {
            packages.push_back(above / package);
            candidates.push_back(above / package / path);
            if (above.filename() == package)
            {
                packages.push_back(above);
                candidates.push_back(above / path);
            }
            else if (!isOtherPackage(above, package))
                others.push_back(above / path);
            if (above == above.parent_path())
                break;
        }
        for (const fs::path &known : packagesOfRos(package))
            candidates.push_back(known / path);
        candidates.insert(candidates.end(), others.begin(), others.end());
        for (const fs::path &candidate : candidates)
            if (isFile(candidate))
                return candidate.lexically_normal();
        std::error_code error;
        for (const fs::path &found : packages)
            if (fs::is_directory(found, error))
                failWithoutMesh(name, "in '" + found.string() + "'");
        failWithoutMesh(name, "from '" + folder().string() + "' upwards; tell where package '" + package + "' is");
    }
}
