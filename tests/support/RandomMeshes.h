#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_RANDOM_MESHES_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_RANDOM_MESHES_

#include "Random.h"

#include "ompl_certificates/geometry/Body.h"

#include <vector>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief A factor that makes a body longer or shorter along an axis */
        inline double extentOf(Random &random)
        {
            return random.chance(0.3) ? 1.0 : random.logUniform(0.05, 1.0);
        }

        /** \brief The triangles of a closed box with the given extents, about \e center */
        inline TriangleMeshPtr boxMesh(const Eigen::Vector3d &size,
                                       const Eigen::Vector3d &center = Eigen::Vector3d::Zero())
        {
            std::vector<Eigen::Vector3d> vertices;
            for (const double z : {-0.5, 0.5})
                for (const double y : {-0.5, 0.5})
                    for (const double x : {-0.5, 0.5})
                        vertices.push_back(center + size.cwiseProduct(Eigen::Vector3d(x, y, z)));
            return std::make_shared<TriangleMesh>(std::move(vertices), std::vector<TriangleMesh::Triangle>{{0, 2, 1},
                                                                                                           {1, 2, 3},
                                                                                                           {4, 5, 6},
                                                                                                           {5, 7, 6},
                                                                                                           {0, 1, 4},
                                                                                                           {1, 5, 4},
                                                                                                           {2, 6, 3},
                                                                                                           {3, 6, 7},
                                                                                                           {0, 4, 2},
                                                                                                           {2, 4, 6},
                                                                                                           {1, 3, 5},
                                                                                                           {3, 7, 5}});
        }

        /** \brief A closed ball, as \e rings times twice as many quadrangles of two triangles each */
        inline TriangleMeshPtr ballMesh(unsigned int rings, double radius = 1.0)
        {
            std::vector<Eigen::Vector3d> vertices;
            const unsigned int columns = 2 * rings;
            for (unsigned int i = 0; i <= rings; ++i)
                for (unsigned int j = 0; j < columns; ++j)
                {
                    const double polar = M_PI * i / rings, around = 2.0 * M_PI * j / columns;
                    const double sine = i == 0 || i == rings ? 0.0 : std::sin(polar);
                    vertices.emplace_back(radius * sine * std::cos(around), radius * sine * std::sin(around),
                                          radius * std::cos(polar));
                }
            std::vector<TriangleMesh::Triangle> triangles;
            for (unsigned int i = 0; i < rings; ++i)
                for (unsigned int j = 0; j < columns; ++j)
                {
                    const unsigned int a = i * columns + j, b = i * columns + (j + 1) % columns;
                    triangles.push_back({a, a + columns, b});
                    triangles.push_back({b, a + columns, b + columns});
                }
            return std::make_shared<TriangleMesh>(std::move(vertices), std::move(triangles));
        }

        /** \brief One mesh of the triangles of all */
        inline TriangleMeshPtr joined(const std::vector<TriangleMeshPtr> &meshes)
        {
            std::vector<Eigen::Vector3d> vertices;
            std::vector<TriangleMesh::Triangle> triangles;
            for (const TriangleMeshPtr &mesh : meshes)
            {
                const auto first = static_cast<std::uint32_t>(vertices.size());
                vertices.insert(vertices.end(), mesh->getVertices().begin(), mesh->getVertices().end());
                for (const auto &[a, b, c] : mesh->getTriangles())
                    triangles.push_back({first + a, first + b, first + c});
            }
            return std::make_shared<TriangleMesh>(std::move(vertices), std::move(triangles));
        }

        /** \brief A soup about \e size wide: large and small triangles, slivers, some without area, some twice */
        inline TriangleMeshPtr randomSoup(Random &random, double size)
        {
            std::vector<Eigen::Vector3d> vertices;
            std::vector<TriangleMesh::Triangle> triangles;
            const auto corner = [&](const Eigen::Vector3d &at, double extent)
            {
                vertices.push_back(at + random.point(3, extent));
                return static_cast<std::uint32_t>(vertices.size() - 1);
            };
            const Eigen::Vector3d interval(extentOf(random), extentOf(random), extentOf(random));
            for (unsigned int count = 1 + random.below(random.chance(0.2) ? 60 : 12); count > 0; --count)
            {
                const Eigen::Vector3d at = interval.cwiseProduct(random.point(3, 0.5 * size));
                const double extent = size * random.logUniform(0.01, 0.5);
                TriangleMesh::Triangle triangle{corner(at, extent), corner(at, extent), corner(at, extent)};
                if (random.chance(0.2))  // a neighbor
                    triangle[0] = static_cast<std::uint32_t>(random.below(vertices.size()));
                if (random.chance(0.1))  // a sliver
                    vertices[triangle[2]] = 0.5 * (vertices[triangle[0]] + vertices[triangle[1]]) +
                                            random.point(3, size * random.logUniform(1e-12, 1e-2));
                if (random.chance(0.1))  // no area
                    triangle[1] = triangle[0];
                triangles.push_back(triangle);
                if (random.chance(0.1))
                    triangles.push_back({triangle[2], triangle[1], triangle[0]});
            }
            // At least one has an area.
            triangles.push_back({corner({0.0, 0.0, 0.0}, 0.0), corner({0.3 * size, 0.0, 0.0}, 0.1 * size),
                                 corner({0.0, 0.3 * size, 0.0}, 0.1 * size)});
            return std::make_shared<TriangleMesh>(std::move(vertices), std::move(triangles));
        }

        /** \brief A mesh of any kind, about \e size wide */
        inline TriangleMeshPtr randomMesh(Random &random, double size)
        {
            switch (random.below(4))
            {
                case 0:
                    return boxMesh(size * Eigen::Vector3d(extentOf(random), extentOf(random), extentOf(random)),
                                   random.point(3, 0.2 * size));
                case 1:
                    return ballMesh(3 + random.below(8), 0.5 * size);
                default:
                    return randomSoup(random, size);
            }
        }

        /** \brief The same mesh, raised by \e height */
        inline TriangleMeshPtr raised(const TriangleMeshPtr &mesh, double height)
        {
            std::vector<Eigen::Vector3d> vertices = mesh->getVertices();
            for (Eigen::Vector3d &vertex : vertices)
                vertex.z() += height;
            return std::make_shared<TriangleMesh>(std::move(vertices), mesh->getTriangles());
        }

        /** \brief A body of a mesh of any kind, about \e size wide; in the plane at a random z */
        inline Body randomMeshBody(Random &random, unsigned int dimension, double size)
        {
            const TriangleMeshPtr mesh = randomMesh(random, size);
            if (dimension == 3)
                return Body::mesh(mesh);
            return Body::planarMesh(raised(mesh, random.chance(0.3) ? 0.0 : size * random.uniform(-0.7, 0.7)));
        }

        /** \brief A body of a mesh, for the plane or for space */
        inline Body meshBody(unsigned int dimension, TriangleMeshPtr mesh)
        {
            return dimension == 2 ? Body::planarMesh(std::move(mesh)) : Body::mesh(std::move(mesh));
        }

        /** \brief A point of a triangle of a mesh: inside, on an edge, or a corner */
        inline Eigen::Vector3d pointOf(Random &random, const TriangleMesh &mesh, std::size_t triangle)
        {
            const auto [a, b, c] = mesh.getCorners(triangle);
            Eigen::Vector3d weights(random.uniform(0.0, 1.0), random.uniform(0.0, 1.0), random.uniform(0.0, 1.0));
            if (random.chance(0.4))
                weights[random.below(3)] = 0.0;
            if (random.chance(0.2))
                weights = Eigen::Vector3d::Unit(random.below(3));
            weights /= weights.sum();
            return weights[0] * a + weights[1] * b + weights[2] * c;
        }
    }
}

#endif
