#include "ompl_certificates/scene/MeshFile.h"

#include "MeshReaders.h"
#include "files/WholeFile.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <filesystem>
#include <map>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace fs = std::filesystem;

    namespace
    {
        constexpr std::uintmax_t MOST_MESH_BYTES = 512U << 20U;

        [[noreturn]] void fail(const std::string &file, const std::string &complaint)
        {
            throw ompl::Exception(file.empty() ? "''" : file, complaint);
        }

        using Reader = void (*)(std::string_view content, MeshCollector &mesh);

        /** By the extension of the name of a file that may be a mesh */
        Reader readerOf(const std::string &file)
        {
            static const std::map<std::string, Reader> readers{
                {".dae", readCollada}, {".stl", readStl}, {".obj", readObj}, {".ply", readPly}};
            std::error_code error;
            const auto found = readers.find(boost::algorithm::to_lower_copy(fs::path(file).extension().string()));
            if (found == readers.end() && !fs::is_directory(file, error))
                fail(file, "must end with .dae, .stl, .obj or .ply to be read as a mesh");
            // Opening a pipe would wait for who writes to it.
            if (found == readers.end() || (fs::exists(file, error) && !fs::is_regular_file(file, error)))
                fail(file, "is not a regular file");
            return found->second;
        }

        Body makeBody(unsigned int dimension, TriangleMeshPtr mesh)
        {
            return dimension == 2 ? Body::planarMesh(std::move(mesh)) : Body::mesh(std::move(mesh));
        }
    }

    MeshFile::MeshFile(const std::string &file, bool keepsAxes) : name_(file)
    {
        const Reader read = readerOf(file);
        const std::string content = readWholeFile(file, MOST_MESH_BYTES);
        if (content.empty())
            fail(file, "is empty");
        try
        {
            MeshCollector mesh;
            mesh.keepsAxes = keepsAxes;
            read(content, mesh);
            mean_ = mesh.getMean();
            mesh_ = mesh.takeMesh(file);
        }
        catch (const std::exception &exception)
        {
            fail(file, exception.what());
        }
    }

    TriangleMeshPtr MeshFile::transformed(const Eigen::Affine3d &transform) const
    {
        std::vector<Eigen::Vector3d> vertices = mesh_->getVertices();
        for (Eigen::Vector3d &vertex : vertices)
            vertex = transform * vertex;
        return std::make_shared<TriangleMesh>(std::move(vertices), mesh_->getTriangles(), name_);
    }

    Body MeshFile::makeObstacle(unsigned int dimension) const
    {
        return makeBody(dimension, mesh_);
    }

    Body MeshFile::makeRobot(unsigned int dimension) const
    {
        const Eigen::Vector3d reference(mean_.x(), mean_.y(), dimension == 2 ? 0.0 : mean_.z());
        return makeBody(dimension, transformed(Eigen::Affine3d(Eigen::Translation3d(-reference))));
    }
}
