#include "ompl_certificates/geometry/Shape.h"

#include "FclConvex.h"
#include "ShortestText.h"
#include "TriangleDistance.h"
#include "TriangleTree.h"

#include "ompl_certificates/geometry/Pose.h"

#include <algorithm>
#include <cmath>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <limits>
#include <mutex>
#include <ompl/util/Exception.h>
#include <sstream>

namespace ompl_certificates
{
    namespace
    {
        double checkedSize(const char *what, double size)
        {
            if (!(size > 0.0) || !std::isfinite(size))
                throw ompl::Exception(std::string("The ") + what + " must be positive and finite, not " +
                                      std::to_string(size));
            return size;
        }

        double signedBoxDistance(const Eigen::Vector3d &halfSize, const Eigen::Vector3d &point, unsigned int dimension)
        {
            const Eigen::Vector3d q = point.cwiseAbs() - halfSize;
            const double inside = dimension == 2 ? std::max(q.x(), q.y()) : q.maxCoeff();
            return inside <= 0.0 ? inside : q.cwiseMax(0.0).norm();
        }

        double signedCylinderDistance(double radius, double halfLength, const Eigen::Vector3d &point)
        {
            const double radial = std::hypot(point.x(), point.y()) - radius;
            const double axial = std::abs(point.z()) - halfLength;
            const double inside = std::max(radial, axial);
            return inside <= 0.0 ? inside : std::hypot(std::max(radial, 0.0), std::max(axial, 0.0));
        }

        std::vector<Eigen::Vector3d> boxCorners(const Eigen::Vector3d &size)
        {
            std::vector<Eigen::Vector3d> corners;
            for (const double x : {-0.5, 0.5})
                for (const double y : {-0.5, 0.5})
                    for (const double z : {-0.5, 0.5})
                        if (size.z() > 0.0 || z > 0.0)
                            corners.emplace_back(x * size.x(), y * size.y(), z * size.z());
            return corners;
        }

        /** The hull of a box of this size. That of a cube is stretched, which costs a hundredth of searching for it. */
        ConvexHull hullOfBox(const Eigen::Vector3d &size)
        {
            static const ConvexHull cube = convexHull(boxCorners(Eigen::Vector3d::Ones()), 3);
            // What is too thin, the search refuses.
            constexpr double thin = 1e-5, tooThin = 3e-7;
            if (size.minCoeff() <= tooThin * size.norm())
            {
                std::ostringstream text;
                text << "A box must be thicker than " << tooThin << " of its diagonal; its sides are " << size.x()
                     << ", " << size.y() << " and " << size.z();
                throw ompl::Exception(text.str());
            }
            if (!(size.minCoeff() > thin * size.maxCoeff()) || !size.allFinite())
                return convexHull(boxCorners(size), 3);
            ConvexHull hull = cube;
            for (Eigen::Vector3d &vertex : hull.vertices)
                vertex = vertex.cwiseProduct(size);
            for (ConvexHull::Face &face : hull.faces)
                face.offset *= face.normal.cwiseAbs().dot(size);
            return hull;
        }

        /** FCL's hierarchy of boxes over the triangles that are not degenerate */
        std::shared_ptr<fcl::CollisionGeometryd> makeHierarchy(const TriangleMesh &mesh)
        {
            constexpr auto unused = std::numeric_limits<std::size_t>::max();
            std::vector<std::size_t> newIndex(mesh.getVertices().size(), unused);
            std::vector<fcl::Vector3d> vertices;
            std::vector<fcl::Triangle> triangles;
            for (std::size_t i = 0; i < mesh.getTriangles().size(); ++i)
            {
                if (mesh.isDegenerate(i))
                    continue;
                std::size_t corners[3];
                for (std::size_t k = 0; k < 3; ++k)
                {
                    const std::uint32_t vertex = mesh.getTriangles()[i][k];
                    if (newIndex[vertex] == unused)
                    {
                        newIndex[vertex] = vertices.size();
                        vertices.emplace_back(Shape::FCL_SCALE * mesh.getVertices()[vertex]);
                    }
                    corners[k] = newIndex[vertex];
                }
                triangles.emplace_back(corners[0], corners[1], corners[2]);
            }
            auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
            model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.size()));
            model->addSubModel(vertices, triangles);
            if (model->endModel() != fcl::BVH_OK)
                throw ompl::Exception("FCL cannot build the hierarchy of a mesh of " +
                                      std::to_string(triangles.size()) + " triangles");
            return model;
        }

        double distanceToMesh(const TriangleMesh &mesh, unsigned int dimension, const Eigen::Vector3d &point)
        {
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < mesh.getTriangles().size(); ++i)
            {
                if (mesh.isDegenerate(i))
                    continue;
                auto [a, b, c] = mesh.getCorners(i);
                if (dimension == 2)
                    a.z() = b.z() = c.z() = point.z();
                nearest = std::min(nearest, squaredDistanceToTriangle(point, a, b, c));
            }
            return std::sqrt(nearest);
        }
    }

    struct Shape::ForFcl
    {
        std::once_flag once;
        std::shared_ptr<fcl::CollisionGeometryd> geometry;
    };

    Shape::Shape(Kind kind, unsigned int dimension, double radius, const Eigen::Vector3d &size)
      : kind_(kind), dimension_(dimension), radius_(radius), size_(size), forFcl_(std::make_shared<ForFcl>())
    {
        if (dimension != 2 && dimension != 3)
            throw ompl::Exception("A shape is for a workspace of 2 or 3 dimensions, not " + std::to_string(dimension));
    }

    Shape Shape::ball(unsigned int dimension, double radius)
    {
        if (!(radius >= 0.0) || !std::isfinite(radius))
            throw ompl::Exception("The radius must be finite and not negative, not " + std::to_string(radius));
        return {Kind::BALL, dimension, radius, Eigen::Vector3d::Zero()};
    }

    Shape Shape::box(const Eigen::Vector2d &size)
    {
        Shape shape(Kind::BOX, 2, 0.0, {checkedSize("size", size.x()), checkedSize("size", size.y()), 0.0});
        try
        {
            shape.hull_ = std::make_shared<ConvexHull>(convexHull(boxCorners(shape.size_), 2));
        }
        catch (const ompl::Exception &)
        {
            throw ompl::Exception("A box of " + shortestText(size.x()) + " by " + shortestText(size.y()) +
                                  " is too thin, or too large or small, to compute with");
        }
        return shape;
    }

    Shape Shape::box(const Eigen::Vector3d &size)
    {
        for (const double extent : size)
            checkedSize("size", extent);
        Shape shape(Kind::BOX, 3, 0.0, size);
        shape.hull_ = std::make_shared<ConvexHull>(hullOfBox(size));
        return shape;
    }

    Shape Shape::capsule(unsigned int dimension, double radius, double length)
    {
        checkedSize("length", length);
        return {Kind::CAPSULE, dimension, checkedSize("radius", radius), {0.0, 0.0, length}};
    }

    Shape Shape::cylinder(double radius, double length)
    {
        return {Kind::CYLINDER, 3, checkedSize("radius", radius), {0.0, 0.0, checkedSize("length", length)}};
    }

    Shape Shape::polytope(unsigned int dimension, const std::vector<Eigen::Vector3d> &points)
    {
        Shape shape(Kind::POLYTOPE, dimension, 0.0, Eigen::Vector3d::Zero());
        shape.hull_ = std::make_shared<ConvexHull>(convexHull(points, dimension));
        return shape;
    }

    Shape Shape::mesh(unsigned int dimension, TriangleMeshPtr mesh)
    {
        if (!mesh)
            throw ompl::Exception("A mesh must not be null");
        Shape shape(Kind::MESH, dimension, 0.0, Eigen::Vector3d::Zero());
        shape.mesh_ = std::move(mesh);
        return shape;
    }

    const std::shared_ptr<fcl::CollisionGeometryd> &Shape::getCollisionGeometry() const
    {
        std::call_once(forFcl_->once,
                       [this]
                       {
                           auto geometry = makeCollisionGeometry();
                           geometry->computeLocalAABB();
                           forFcl_->geometry = std::move(geometry);
                       });
        return forFcl_->geometry;
    }

    std::shared_ptr<fcl::CollisionGeometryd> Shape::makeCollisionGeometry() const
    {
        // Any height will do for a prism; one like its other extents keeps FCL's solver well conditioned.
        const double prismHeight = dimension_ == 2 ? getBounds().sizes().maxCoeff() : 0.0;
        // FCL's solver may never end for shapes without width. So little more is less than its tolerance.
        const double least = 1e-9 * std::max(2.0 * radius_, size_.maxCoeff());
        const auto widened = [least](double length) { return FCL_SCALE * std::max(length, least); };
        const double radius = FCL_SCALE * radius_;
        const Eigen::Vector3d size = FCL_SCALE * size_;
        switch (kind_)
        {
            case Kind::BALL:
                return std::make_shared<fcl::Sphered>(radius);
            case Kind::BOX:
                return std::make_shared<fcl::Boxd>(size.x(), size.y(),
                                                   dimension_ == 2 ? FCL_SCALE * prismHeight : size.z());
            case Kind::CAPSULE:
                return std::make_shared<fcl::Capsuled>(widened(radius_), widened(size_.z()));
            case Kind::CYLINDER:
                return std::make_shared<fcl::Cylinderd>(widened(radius_), widened(size_.z()));
            case Kind::POLYTOPE:
                return makeConvex(*hull_, prismHeight);
            case Kind::MESH:
                return makeHierarchy(*mesh_);
        }
        throw ompl::Exception("Unknown kind of shape");
    }

    double Shape::signedDistance(const Eigen::Vector3d &point) const
    {
        switch (kind_)
        {
            case Kind::BALL:
                return point.norm() - radius_;
            case Kind::BOX:
                return signedBoxDistance(0.5 * size_, point, dimension_);
            case Kind::CAPSULE:
            {
                const Eigen::Vector3d nearest = point.cwiseMax(-0.5 * size_).cwiseMin(0.5 * size_);
                return (point - nearest).norm() - radius_;
            }
            case Kind::CYLINDER:
                return signedCylinderDistance(radius_, 0.5 * size_.z(), point);
            case Kind::POLYTOPE:
                return hull_->signedDistance(point);
            case Kind::MESH:
                return distanceToMesh(*mesh_, dimension_, point);
        }
        throw ompl::Exception("Unknown kind of shape");
    }

    bool Shape::isWithin(const Eigen::Vector3d &point, double distance) const
    {
        if (kind_ != Kind::MESH)
            return signedDistance(point) <= distance;
        // Any limit above the distance will do.
        const double limit = 1.001 * distance + 1e-12;
        return (dimension_ == 2 ? mesh_->getOutline().distance({point.x(), point.y(), 0.0}, limit)
                                : mesh_->getTree().distance(point, limit)) <= distance;
    }

    bool Shape::snapToPlane(Pose &pose) const
    {
        constexpr double rounding = 1e-12;
        if (dimension_ != 2)
            return true;
        const Eigen::Vector3d axis = pose.linear().col(2);
        const bool upright = (axis - Eigen::Vector3d::UnitZ()).norm() <= rounding;
        const bool lying = std::abs(axis.z()) <= rounding;
        const bool level = kind_ == Kind::MESH || std::abs(pose.translation().z()) <= rounding;
        if (!level || !(kind_ == Kind::BALL || (kind_ == Kind::CAPSULE ? lying : upright)))
            return false;
        if (kind_ != Kind::MESH)
            pose.translation().z() = 0.0;
        if (upright)
            makeUpright(pose);
        else if (kind_ == Kind::BALL)
            pose.linear().setIdentity();
        else if (kind_ == Kind::CAPSULE && axis.z() != 0.0)
        {
            // A capsule is round: any turn about its axis will do, and this one is exact.
            const Eigen::Vector2d along = axis.head<2>().normalized();
            pose.linear() << 0.0, -along.y(), along.x(), 0.0, along.x(), along.y(), -1.0, 0.0, 0.0;
        }
        return true;
    }

    Eigen::AlignedBox3d Shape::getBounds() const
    {
        if (kind_ == Kind::POLYTOPE)
        {
            Eigen::AlignedBox3d box;
            for (const auto &vertex : hull_->vertices)
                box.extend(vertex);
            return box;
        }
        if (kind_ == Kind::MESH)
            return mesh_->getBounds();
        Eigen::Vector3d extent = 0.5 * size_;
        if (kind_ == Kind::CAPSULE)
            extent.array() += radius_;
        else if (kind_ == Kind::BALL)
            extent += Eigen::Vector3d(radius_, radius_, dimension_ == 2 ? 0.0 : radius_);
        else if (kind_ == Kind::CYLINDER)
            extent += Eigen::Vector3d(radius_, radius_, 0.0);
        return {-extent, extent};
    }

    bool Shape::operator==(const Shape &other) const
    {
        if (kind_ != other.kind_ || dimension_ != other.dimension_ || radius_ != other.radius_ || size_ != other.size_)
            return false;
        if (kind_ == Kind::MESH)
            return mesh_ == other.mesh_ || (mesh_->getVertices() == other.mesh_->getVertices() &&
                                            mesh_->getTriangles() == other.mesh_->getTriangles());
        return kind_ != Kind::POLYTOPE || hull_->vertices == other.hull_->vertices;
    }
}
