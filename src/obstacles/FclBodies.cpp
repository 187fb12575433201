#include "FclBodies.h"

#include <cmath>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <ompl/util/Exception.h>
#include <string>

namespace ompl_certificates
{
    namespace
    {
        /** FCL's class of that name, for messages about those that are refused */
        std::string nameOf(fcl::NODE_TYPE type)
        {
            switch (type)
            {
                case fcl::BV_AABB:
                    return "fcl::BVHModel<fcl::AABB>";
                case fcl::BV_RSS:
                    return "fcl::BVHModel<fcl::RSS>";
                case fcl::BV_kIOS:
                    return "fcl::BVHModel<fcl::kIOS>";
                case fcl::BV_KDOP16:
                    return "fcl::BVHModel<fcl::KDOP<16>>";
                case fcl::BV_KDOP18:
                    return "fcl::BVHModel<fcl::KDOP<18>>";
                case fcl::BV_KDOP24:
                    return "fcl::BVHModel<fcl::KDOP<24>>";
                case fcl::GEOM_ELLIPSOID:
                    return "fcl::Ellipsoid";
                case fcl::GEOM_CONE:
                    return "fcl::Cone";
                case fcl::GEOM_PLANE:
                    return "fcl::Plane";
                case fcl::GEOM_HALFSPACE:
                    return "fcl::Halfspace";
                case fcl::GEOM_TRIANGLE:
                    return "fcl::TriangleP";
                case fcl::GEOM_OCTREE:
                    return "fcl::OcTree";
                default:
                    return "a fcl::CollisionGeometry of node type " + std::to_string(type);
            }
        }

        template <typename Box>
        TriangleMeshPtr meshOf(const fcl::CollisionGeometryd *geometry)
        {
            const auto &model = *static_cast<const fcl::BVHModel<Box> *>(geometry);
            if (model.getModelType() != fcl::BVH_MODEL_TRIANGLES)
                throw ompl::Exception("FclObstacles takes FCL's BVH models of triangles, not of points");
            if (model.build_state != fcl::BVH_BUILD_STATE_PROCESSED &&
                model.build_state != fcl::BVH_BUILD_STATE_UPDATED)
                throw ompl::Exception("FclObstacles takes FCL's BVH models once endModel() was called");
            std::vector<TriangleMesh::Triangle> triangles;
            for (int i = 0; i < model.num_tris; ++i)
            {
                const fcl::Triangle &corners = model.tri_indices[i];
                triangles.push_back({static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]),
                                     static_cast<std::uint32_t>(corners[2])});
            }
            return std::make_shared<TriangleMesh>(
                std::vector<Eigen::Vector3d>(model.vertices, model.vertices + model.num_vertices),
                std::move(triangles));
        }

        PlacedBody spatialBody(const fcl::CollisionObjectd &object)
        {
            const auto *geometry = object.collisionGeometry().get();
            const Pose &pose = object.getTransform();
            switch (object.getNodeType())
            {
                case fcl::GEOM_SPHERE:
                    return {Body::sphere(static_cast<const fcl::Sphered *>(geometry)->radius), pose};
                case fcl::GEOM_BOX:
                {
                    const auto &side = static_cast<const fcl::Boxd *>(geometry)->side;
                    return {Body::box(side.x(), side.y(), side.z()), pose};
                }
                case fcl::GEOM_CAPSULE:
                {
                    const auto *capsule = static_cast<const fcl::Capsuled *>(geometry);
                    return {Body::capsule(capsule->radius, capsule->lz), pose};
                }
                case fcl::GEOM_CYLINDER:
                {
                    const auto *cylinder = static_cast<const fcl::Cylinderd *>(geometry);
                    return {Body::cylinder(cylinder->radius, cylinder->lz), pose};
                }
                case fcl::GEOM_CONVEX:
                    return {Body::convexHull(static_cast<const fcl::Convexd *>(geometry)->getVertices()), pose};
                case fcl::BV_OBBRSS:
                    return {Body::mesh(meshOf<fcl::OBBRSSd>(geometry)), pose};
                case fcl::BV_OBB:
                    return {Body::mesh(meshOf<fcl::OBBd>(geometry)), pose};
                default:
                    throw ompl::Exception(
                        "FclObstacles takes spheres, boxes, capsules, cylinders, convex polytopes and BVH "
                        "models of OBBRSS or OBB, not " +
                        nameOf(object.getNodeType()));
            }
        }

        PlacedBody planarBody(const fcl::CollisionObjectd &object)
        {
            const auto *geometry = object.collisionGeometry().get();
            const fcl::Transform3d &transform = object.getTransform();
            const fcl::Matrix3d turn = transform.linear();
            // The sine of the tilt, of which cosines hide the small ones; rotations may be rounded to six decimals.
            const bool upright = std::hypot(turn(0, 2), turn(1, 2)) <= 2e-6;
            const Pose pose = planarPose(transform.translation().x(), transform.translation().y(),
                                         std::atan2(turn(1, 0), turn(0, 0)));
            const auto requireUpright = [&]
            {
                if (!upright)
                    throw ompl::Exception("An obstacle of a planar workspace must stand upright");
            };
            switch (object.getNodeType())
            {
                case fcl::GEOM_SPHERE:
                    return {Body::disc(static_cast<const fcl::Sphered *>(geometry)->radius), pose};
                case fcl::GEOM_BOX:
                {
                    requireUpright();
                    const auto &side = static_cast<const fcl::Boxd *>(geometry)->side;
                    return {Body::box(side.x(), side.y()), pose};
                }
                case fcl::GEOM_CAPSULE:
                    requireUpright();
                    return {Body::disc(static_cast<const fcl::Capsuled *>(geometry)->radius), pose};
                case fcl::GEOM_CYLINDER:
                    requireUpright();
                    return {Body::disc(static_cast<const fcl::Cylinderd *>(geometry)->radius), pose};
                case fcl::GEOM_CONVEX:
                {
                    std::vector<Eigen::Vector2d> outline;
                    for (const auto &vertex : static_cast<const fcl::Convexd *>(geometry)->getVertices())
                        outline.push_back((transform * vertex).head<2>());
                    return {Body::convexHull(outline), Pose::Identity()};
                }
                case fcl::BV_OBBRSS:
                case fcl::BV_OBB:
                {
                    if (!upright || turn(2, 2) < 0.0)
                        throw ompl::Exception("A mesh of a planar workspace must stand upright");
                    Pose lifted = pose;
                    lifted.translation().z() = transform.translation().z();
                    return {Body::planarMesh(object.getNodeType() == fcl::BV_OBB ? meshOf<fcl::OBBd>(geometry)
                                                                                 : meshOf<fcl::OBBRSSd>(geometry)),
                            lifted};
                }
                default:
                    return spatialBody(object);  // reports the kind
            }
        }
    }

    PlacedBody bodyOf(const fcl::CollisionObjectd &object, unsigned int dimension)
    {
        return dimension == 2 ? planarBody(object) : spatialBody(object);
    }
}
