#include "ompl_certificates/geometry/FclObstacles.h"

#include <algorithm>
#include <cmath>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        template <typename Box>
        TriangleMeshPtr meshOf(const fcl::CollisionGeometryd *geometry)
        {
            const auto &model = *static_cast<const fcl::BVHModel<Box> *>(geometry);
            if (model.getModelType() != fcl::BVH_MODEL_TRIANGLES)
                throw ompl::Exception("FclObstacles takes FCL's BVH models of triangles, not of points");
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
            const Pose pose(object.getTransform());
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
                    return {Body::convexPolytope(static_cast<const fcl::Convexd *>(geometry)->getVertices()), pose};
                case fcl::BV_OBBRSS:
                    return {Body::mesh(meshOf<fcl::OBBRSSd>(geometry)), pose};
                case fcl::BV_OBB:
                    return {Body::mesh(meshOf<fcl::OBBd>(geometry)), pose};
                default:
                    throw ompl::Exception(
                        "FclObstacles takes spheres, boxes, capsules, cylinders, convex polytopes and BVH "
                        "models of OBBRSS or OBB, not FCL's node type " +
                        std::to_string(object.getNodeType()));
            }
        }

        PlacedBody planarBody(const fcl::CollisionObjectd &object)
        {
            const auto *geometry = object.collisionGeometry().get();
            const fcl::Transform3d &transform = object.getTransform();
            const fcl::Matrix3d turn = transform.linear();
            const bool upright = std::abs(turn(2, 2)) > 1.0 - 1e-9;
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
                    return {Body::convexPolygon(outline), Pose::Identity()};
                }
                case fcl::BV_OBBRSS:
                case fcl::BV_OBB:
                {
                    if (!(turn(2, 2) > 1.0 - 1e-9))
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

        fcl::CollisionObjectd makeObject(const Body::Part &part, const Pose &bodyPose)
        {
            Pose pose = bodyPose * part.pose;
            pose.translation() *= Shape::FCL_SCALE;
            return {part.shape.getCollisionGeometry(), pose};
        }

        /** What an outline has at z >= \e low */
        std::vector<Eigen::Vector3d> clippedAbove(const std::vector<Eigen::Vector3d> &outline, double low)
        {
            std::vector<Eigen::Vector3d> kept;
            for (std::size_t i = 0; i < outline.size(); ++i)
            {
                const Eigen::Vector3d &a = outline[i], &b = outline[(i + 1) % outline.size()];
                if (a.z() >= low)
                    kept.push_back(a);
                if ((a.z() < low) != (b.z() < low))
                    kept.push_back(a + (low - a.z()) / (b.z() - a.z()) * (b - a));
            }
            return kept;
        }

        bool stopAtFirstContact(fcl::CollisionObjectd *a, fcl::CollisionObjectd *b, void *data)
        {
            // FCL's default tolerance is a millionth of the length unit; this one is a millionth of the smaller shape.
            fcl::CollisionRequestd request;
            request.gjk_tolerance =
                1e-6 * std::min(a->collisionGeometry()->aabb_radius, b->collisionGeometry()->aabb_radius);
            fcl::CollisionResultd result;
            if (fcl::collide(a, b, request, result) == 0)
                return false;
            *static_cast<bool *>(data) = true;
            return true;
        }
    }

    FclObstacles::FclObstacles(unsigned int dimension, const std::vector<PlacedBody> &obstacles, const Heights &heights)
      : dimension_(dimension), heights_(heights), bodies_(obstacles)
    {
        build();
    }

    FclObstacles::FclObstacles(const std::vector<std::shared_ptr<fcl::CollisionObjectd>> &objects,
                               unsigned int dimension, const Heights &heights)
      : dimension_(dimension), heights_(heights)
    {
        for (const auto &object : objects)
        {
            if (!object)
                throw ompl::Exception("A collision object must not be null");
            bodies_.push_back(dimension == 2 ? planarBody(*object) : spatialBody(*object));
        }
        build();
    }

    void FclObstacles::build()
    {
        if (dimension_ != 2 && dimension_ != 3)
            throw ompl::Exception("A workspace has 2 or 3 dimensions, not " + std::to_string(dimension_));
        manager_ = std::make_unique<fcl::DynamicAABBTreeCollisionManagerd>();
        double largest = 0.0, farthest = 0.0;
        for (const auto &[body, pose] : bodies_)
        {
            if (body.getDimension() != dimension_)
                throw ompl::Exception("An obstacle has " + std::to_string(body.getDimension()) +
                                      " dimensions, its workspace " + std::to_string(dimension_));
            if (!pose.matrix().allFinite())
                throw ompl::Exception("The pose of an obstacle must be finite");
            for (const auto &part : body.getParts())
            {
                const Pose partPose = pose * part.pose;
                objects_.push_back(std::make_unique<fcl::CollisionObjectd>(makeObject(part, pose)));
                manager_->registerObject(objects_.back().get());
                if (const TriangleMesh *mesh = part.shape.getMesh())
                    addTriangles(*mesh, partPose);
                else
                    clearances_.add(part.shape, partPose);
                const auto bounds = part.shape.getBounds();
                largest = std::max(largest, bounds.max().cwiseMax(-bounds.min()).norm());
                farthest = std::max(farthest, partPose.translation().norm());
            }
        }
        manager_->setup();
        clearances_.build();
        triangles_.build();
        // The second term pays for the rounding of coordinates far from the origin.
        tolerance_ = EXACT_CHECK_TOLERANCE * largest + 1e-14 * farthest;
    }

    bool FclObstacles::collides(const Body &body, const Pose &pose) const
    {
        bool hit = false;
        for (const auto &part : body.getParts())
        {
            if (dimension_ == 2 && (part.shape.getMesh() ? clearances_.size() : triangles_.size()) > 0)
                throw ompl::Exception("Planar meshes and planar primitives do not go together yet");
            fcl::CollisionObjectd object = makeObject(part, pose);
            manager_->collide(&object, &hit, stopAtFirstContact);
            if (hit)
                return true;
        }
        return false;
    }

    void FclObstacles::addTriangles(const TriangleMesh &mesh, const Pose &pose)
    {
        if (dimension_ == 2 && (pose.linear().col(2) - Eigen::Vector3d::UnitZ()).norm() > 1e-12)
            throw ompl::Exception("An obstacle of a planar workspace must stand upright");
        // A little more than the robots reach, so that rounding leaves nothing out.
        const double slack = EXACT_CHECK_TOLERANCE * mesh.getBounds().sizes().norm();
        for (std::size_t i = 0; i < mesh.getTriangles().size(); ++i)
        {
            if (mesh.isDegenerate(i))
                continue;
            const auto [a, b, c] = mesh.getCorners(i);
            if (dimension_ == 3)
            {
                triangles_.add(pose * a, pose * b, pose * c);
                continue;
            }
            std::vector<Eigen::Vector3d> outline = {pose * a, pose * b, pose * c};
            outline = clippedAbove(outline, heights_.low - slack);
            for (auto &corner : outline)
                corner.z() = -corner.z();
            outline = clippedAbove(outline, -heights_.high - slack);
            for (auto &corner : outline)
                corner.z() = 0.0;
            for (std::size_t k = 2; k < outline.size(); ++k)
                triangles_.add(outline[0], outline[k - 1], outline[k]);
        }
    }

    double FclObstacles::clearance(const Eigen::Vector3d &point) const
    {
        return triangles_.distance(point, clearances_.signedDistance(point));
    }
}
