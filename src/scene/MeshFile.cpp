#include "ompl_certificates/scene/MeshFile.h"

#include "MeshReaders.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace fs = std::filesystem;

    namespace
    {
        struct Kind
        {
            void (*read)(std::string_view content, MeshCollector &mesh);
            std::uintmax_t mostMegabytes;
        };

        [[noreturn]] void fail(const std::string &file, const std::string &complaint)
        {
            std::string line = complaint;
            for (char &c : line)
                if (static_cast<unsigned char>(c) < ' ')
                    c = ' ';
            throw ompl::Exception(file.empty() ? "''" : file, line);
        }

        /** By the extension of the name of a file that may be a mesh */
        const Kind &kindOf(const std::string &file)
        {
            static const std::map<std::string, Kind> kinds{
                {".dae", {readCollada, 128}}, {".stl", {readStl, 512}}, {".obj", {readObj, 512}}, {".ply", {readPly, 512}}};
            std::error_code error;
            if (fs::is_directory(file, error))
                fail(file, "is a directory, not a mesh");
            std::string extension = fs::path(file).extension().string();
            std::transform(extension.begin(), extension.end(), extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            const auto found = kinds.find(extension);
            if (found == kinds.end())
                fail(file, "must end with .dae, .stl, .obj or .ply to be read as a mesh");
            return found->second;
        }

        std::string readContent(const std::string &file, std::uintmax_t mostMegabytes)
        {
            errno = 0;
            std::error_code error;
            // Opening a pipe would wait for who writes to it.
            if (fs::exists(file, error) && !fs::is_regular_file(file, error))
                fail(file, "is not a regular file");
            std::ifstream stream(file, std::ios::binary);
            if (!stream)
                fail(file,
                     std::string("cannot be read") + (errno != 0 ? std::string(": ") + std::strerror(errno) : ""));
            const std::uintmax_t bytes = fs::file_size(file, error);
            if (error)
                fail(file, "is not a regular file");
            if (bytes > mostMegabytes << 20U)
                fail(file, "is larger than " + std::to_string(mostMegabytes) + " MB");
            if (bytes == 0)
                fail(file, "is empty");
            std::string content(bytes, ' ');
            stream.read(content.data(), static_cast<std::streamsize>(bytes));
            return content;
        }

        Body makeBody(unsigned int dimension, TriangleMeshPtr mesh)
        {
            return dimension == 2 ? Body::planarMesh(std::move(mesh)) : Body::mesh(std::move(mesh));
        }
    }

    MeshFile::MeshFile(const std::string &file) : name_(file)
    {
        const Kind &kind = kindOf(file);
        const std::string content = readContent(file, kind.mostMegabytes);
        try
        {
            MeshCollector mesh;
            kind.read(content, mesh);
            mean_ = mesh.getMean();
            mesh_ = mesh.takeMesh();
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
        return std::make_shared<TriangleMesh>(std::move(vertices), mesh_->getTriangles());
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
