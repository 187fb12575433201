#include "ompl_certificates/scene/MeshFile.h"

#include "ColladaText.h"
#include "MeshWords.h"
#include "ObjText.h"
#include "PlyText.h"
#include "StlText.h"

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <cctype>
#include <cerrno>
#include <cmath>
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
        constexpr std::uintmax_t MAX_BYTES = 512u << 20u, MAX_COLLADA_BYTES = 128u << 20u;
        constexpr std::size_t MAX_NODES = 1000000, MAX_SIZE = 5 * MOST_TRIANGLES;
        /** Assimp's time grows with the square of these, and is some seconds here. */
        constexpr double MOST_SQUARES = 3e8;
        constexpr double MAX_COORDINATE = 1e9;

        [[noreturn]] void fail(const std::string &file, const std::string &complaint)
        {
            std::string line = complaint;
            for (char &c : line)
                if (static_cast<unsigned char>(c) < ' ')
                    c = ' ';
            throw ompl::Exception(file.empty() ? "''" : file, line);
        }

        std::string lowerCase(std::string text)
        {
            std::transform(text.begin(), text.end(), text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            return text;
        }

        /** The extension of the name of a file that may be a mesh */
        std::string kindOf(const std::string &file)
        {
            std::error_code error;
            if (fs::is_directory(file, error))
                fail(file, "is a directory, not a mesh");
            std::string kind = lowerCase(fs::path(file).extension().string());
            const std::array<std::string, 4> known{".dae", ".stl", ".obj", ".ply"};
            if (std::find(known.begin(), known.end(), kind) == known.end())
                fail(file, "must end with .dae, .stl, .obj or .ply to be read as a mesh");
            return kind;
        }

        std::string readText(const std::string &file, std::uintmax_t most)
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
            if (bytes > most)
                fail(file, "is larger than " + std::to_string(most >> 20u) + " MB");
            if (bytes == 0)
                fail(file, "is empty");
            std::string text(bytes, ' ');
            stream.read(text.data(), static_cast<std::streamsize>(bytes));
            return text;
        }

        /** What Assimp is given of a file */
        std::string plainText(const std::string &kind, const std::string &text)
        {
            if (kind == ".ply")
                return plainPly(text);
            if (kind == ".dae")
                return plainCollada(text);
            return kind == ".obj" ? plainObj(text) : plainStl(text);
        }

        const aiScene *importFile(Assimp::Importer &importer, const std::string &file)
        {
            const std::string kind = kindOf(file),
                              text = readText(file, kind == ".dae" ? MAX_COLLADA_BYTES : MAX_BYTES),
                              plain = plainText(kind, text);
            return importer.ReadFileFromMemory(plain.data(), plain.size(), 0, kind.c_str() + 1);
        }

        /** Assimp's further steps take the faces as they are, and end the program where they make no sense. */
        void checkFaces(const std::string &file, const aiScene &scene)
        {
            double squares = 0.0;
            for (unsigned int i = 0; i < scene.mNumMeshes; ++i)
            {
                const aiMesh &mesh = *scene.mMeshes[i];
                for (unsigned int k = 0; k < mesh.mNumFaces; ++k)
                {
                    const aiFace &face = mesh.mFaces[k];
                    const auto isKnown = [&mesh](unsigned int vertex) { return vertex < mesh.mNumVertices; };
                    if (face.mNumIndices == 0 || !std::all_of(face.mIndices, face.mIndices + face.mNumIndices, isKnown))
                        fail(file,
                             "is not a mesh that can be read: a face has no vertices, or vertices that are not there");
                    if (face.mNumIndices > 4 && (squares += std::pow(face.mNumIndices, 2)) > MOST_SQUARES)
                        fail(file, "has polygons with too many corners");
                }
            }
        }

        /** Vertices at one place Assimp compares with each other. */
        void checkVertices(const std::string &file, const aiScene &scene)
        {
            double squares = 0.0;
            for (unsigned int i = 0; i < scene.mNumMeshes; ++i)
            {
                std::map<std::array<float, 3>, unsigned int> counts;
                for (const aiVector3D *vertex = scene.mMeshes[i]->mVertices,
                                      *end = vertex + scene.mMeshes[i]->mNumVertices;
                     vertex != end; ++vertex)
                    // Of n², the n-th adds 2n - 1.
                    squares += 2.0 * ++counts[{vertex->x, vertex->y, vertex->z}] - 1.0;
                if (squares > MOST_SQUARES + 100.0 * scene.mMeshes[i]->mNumVertices)
                    fail(file, "has too many triangles around one vertex");
            }
        }

        Eigen::Affine3d toEigen(const aiMatrix4x4 &matrix)
        {
            Eigen::Affine3d transform = Eigen::Affine3d::Identity();
            for (unsigned int row = 0; row < 3; ++row)
                for (unsigned int column = 0; column < 4; ++column)
                    transform(row, column) = static_cast<double>(matrix[row][column]);
            return transform;
        }

        /** Call \e visit with each mesh of \e scene and where a node places it. */
        template <typename Visit>
        void forEachMesh(const std::string &file, const aiScene &scene, const Visit &visit)
        {
            std::vector<std::pair<const aiNode *, Eigen::Affine3d>> open{
                {scene.mRootNode, Eigen::Affine3d::Identity()}};
            std::size_t size = 0;
            for (std::size_t count = 0; !open.empty(); ++count)
            {
                if (count > MAX_NODES)
                    fail(file, "has more than " + std::to_string(MAX_NODES) + " nodes");
                const auto [node, parent] = open.back();
                open.pop_back();
                const Eigen::Affine3d transform = parent * toEigen(node->mTransformation);
                for (unsigned int i = 0; i < node->mNumMeshes; ++i)
                {
                    const aiMesh &mesh = *scene.mMeshes[node->mMeshes[i]];
                    size += mesh.mNumVertices + mesh.mNumFaces;
                    if (size > MAX_SIZE)
                        fail(file, "has more than " + std::to_string(MAX_SIZE) + " vertices and faces");
                    visit(mesh, transform);
                }
                for (unsigned int i = 0; i < node->mNumChildren; ++i)
                    open.emplace_back(node->mChildren[i], transform);
            }
        }

        Eigen::Vector3d pointOf(const aiVector3D &vertex)
        {
            return {static_cast<double>(vertex.x), static_cast<double>(vertex.y), static_cast<double>(vertex.z)};
        }

        /** The triangles of \e scene; equal vertices become one */
        TriangleMeshPtr extract(const std::string &file, const aiScene &scene)
        {
            std::vector<Eigen::Vector3d> vertices;
            std::vector<TriangleMesh::Triangle> triangles;
            std::map<std::array<double, 3>, std::uint32_t> numbers;
            const auto numberOf = [&](const Eigen::Vector3d &point)
            {
                if (!point.allFinite() || point.cwiseAbs().maxCoeff() > MAX_COORDINATE)
                    fail(file, "has a vertex whose coordinates are not finite numbers of at most 1e9");
                const auto [entry, added] =
                    numbers.try_emplace({point.x(), point.y(), point.z()}, static_cast<std::uint32_t>(vertices.size()));
                if (added)
                    vertices.push_back(point);
                return entry->second;
            };
            forEachMesh(file, scene,
                        [&](const aiMesh &mesh, const Eigen::Affine3d &transform)
                        {
                            for (unsigned int i = 0; i < mesh.mNumFaces; ++i)
                            {
                                const aiFace &face = mesh.mFaces[i];
                                if (face.mNumIndices != 3)
                                    continue;
                                TriangleMesh::Triangle triangle;
                                for (unsigned int k = 0; k < 3; ++k)
                                    triangle[k] = numberOf(transform * pointOf(mesh.mVertices[face.mIndices[k]]));
                                triangles.push_back(triangle);
                                if (triangles.size() > MOST_TRIANGLES)
                                    fail(file, "has more than " + std::to_string(MOST_TRIANGLES) + " triangles");
                            }
                        });
            if (triangles.empty())
                fail(file, "has no triangles");
            try
            {
                return std::make_shared<TriangleMesh>(std::move(vertices), std::move(triangles));
            }
            catch (const ompl::Exception &exception)
            {
                fail(file, exception.what());
            }
        }

        Eigen::Vector3d meanOf(const std::string &file, const aiScene &scene)
        {
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            std::size_t count = 0;
            forEachMesh(file, scene,
                        [&](const aiMesh &mesh, const Eigen::Affine3d &transform)
                        {
                            for (unsigned int i = 0; i < mesh.mNumVertices; ++i)
                                sum += transform * pointOf(mesh.mVertices[i]);
                            count += mesh.mNumVertices;
                        });
            Eigen::Vector3d mean = sum / static_cast<double>(count);
            if (!mean.allFinite())
                fail(file, "has a vertex whose coordinates are not finite");
            return mean;
        }

        Body makeBody(unsigned int dimension, TriangleMeshPtr mesh)
        {
            return dimension == 2 ? Body::planarMesh(std::move(mesh)) : Body::mesh(std::move(mesh));
        }
    }

    MeshFile::MeshFile(const std::string &file) : name_(file)
    {
        const auto require = [&file](const Assimp::Importer &importer, const aiScene *scene)
        {
            if (!scene || !scene->mRootNode)
                fail(file, std::string("is not a mesh that can be read: ") + importer.GetErrorString());
        };
        try
        {
            Assimp::Importer importer;
            // Else bones of a file without meshes would be given bodies.
            importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
            const aiScene *scene = importFile(importer, file);
            require(importer, scene);
            checkFaces(file, *scene);
            scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_SortByPType);
            require(importer, scene);
            mesh_ = extract(file, *scene);
            checkVertices(file, *scene);
            // The same steps as OMPL.app's, which move vertices a little: for the mean alone.
            scene = importer.ApplyPostProcessing(aiProcess_GenNormals | aiProcess_JoinIdenticalVertices |
                                                 aiProcess_OptimizeGraph);
            require(importer, scene);
            mean_ = meanOf(file, *scene);
        }
        catch (const ompl::Exception &)
        {
            throw;
        }
        catch (const std::exception &exception)
        {
            fail(file, std::string("is not a mesh that can be read: ") + exception.what());
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
