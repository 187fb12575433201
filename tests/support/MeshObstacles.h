#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_MESH_OBSTACLES_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_MESH_OBSTACLES_

#include "RandomBodies.h"
#include "RandomMeshes.h"

#include "ompl_certificates/obstacles/FclObstacles.h"

namespace ompl_certificates
{
    namespace test
    {
        /** \brief Some meshes, and by chance some primitives, within about four times \e unit of the origin */
        inline std::vector<PlacedBody> randomMeshObstacles(Random &random, unsigned int dimension, double unit,
                                                           double primitiveChance)
        {
            std::vector<PlacedBody> bodies;
            for (unsigned int count = 1 + random.below(6); count > 0; --count)
            {
                const double size = unit * random.logUniform(0.3, 3.0);
                bodies.push_back({random.chance(primitiveChance) ? randomBody(random, dimension, size)
                                                                 : meshBody(dimension, randomMesh(random, size)),
                                  random.pose(dimension, 3.0 * unit)});
            }
            return bodies;
        }

        /** \brief A point of the surface of a body, or inside a primitive */
        inline Eigen::Vector3d surfacePointOf(Random &random, const Body &body)
        {
            const auto &part = body.getParts()[random.below(body.getParts().size())];
            const TriangleMesh *mesh = part.shape.getMesh();
            if (!mesh)
                return part.pose * pointOf(random, part.shape);
            std::size_t triangle = random.below(mesh->getTriangles().size());
            while (mesh->isDegenerate(triangle))
                triangle = (triangle + 1) % mesh->getTriangles().size();
            return part.pose * pointOf(random, *mesh, triangle);
        }

        /** \brief A pose at which the body mostly just touches an obstacle, or nearly */
        inline Pose nearPose(Random &random, const FclObstacles &obstacles, const Body &body, double unit)
        {
            Pose pose = random.pose(body.getDimension(), 4.0 * unit);
            const auto &[obstacle, obstaclePose] = obstacles.getBodies()[random.below(obstacles.getBodies().size())];
            if (random.chance(0.7))
                pose.translation() += obstaclePose * surfacePointOf(random, obstacle) -
                                      pose * surfacePointOf(random, body) +
                                      random.point(3, unit * random.logUniform(1e-7, 1.0));
            if (body.getDimension() == 2)
                pose.translation().z() = 0.0;
            return pose;
        }

        /** \brief Whether all leaves of the body's sphere tree are free */
        inline bool isCertifiedFree(const FclObstacles &obstacles, const Body &body, const Pose &pose)
        {
            const double margin = obstacles.getTolerance() + exactCheckTolerance(body.getBoundingRadius());
            for (const auto &node : body.getSphereTree().getNodes())
                if (node.childCount == 0 && obstacles.clearance(pose * node.ball.center) <= node.ball.radius + margin)
                    return false;
            return true;
        }
    }
}

#endif
