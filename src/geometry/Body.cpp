#include "ompl_certificates/geometry/Body.h"

#include "ConvexCover.h"
#include "RigidPose.h"
#include "SphereTreeBuilder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        double boundingRadiusOf(const Body::Part &part)
        {
            if (const ConvexHull *hull = part.shape.getHull())
            {
                double farthest = 0.0;
                for (const auto &vertex : hull->vertices)
                    farthest = std::max(farthest, (part.pose * vertex).norm());
                return farthest;
            }
            if (const TriangleMesh *mesh = part.shape.getMesh())
            {
                double farthest = 0.0;
                const bool planar = part.shape.getDimension() == 2;
                for (const auto &triangle : mesh->getTriangles())
                    for (const std::uint32_t corner : triangle)
                    {
                        const Eigen::Vector3d vertex = part.pose * mesh->getVertices()[corner];
                        farthest = std::max(farthest, planar ? vertex.head<2>().norm() : vertex.norm());
                    }
                return farthest;
            }
            const double halfLength = 0.5 * part.shape.getSize().z(), radius = part.shape.getRadius();
            const bool flat = part.shape.getKind() == Shape::Kind::CYLINDER;
            return part.pose.translation().norm() + (flat ? std::hypot(halfLength, radius) : halfLength + radius);
        }

        /** A ball around a part; not always the smallest */
        Ball ballAround(const Body::Part &part)
        {
            const Eigen::AlignedBox3d bounds = part.shape.getBounds();
            const double radius = part.shape.getMesh() ? 0.5 * bounds.sizes().norm()
                                                       : boundingRadiusOf({part.shape, poseAt(-bounds.center())});
            return {part.pose * bounds.center(), radius};
        }

        ZInterval zIntervalOf(const std::vector<Body::Part> &parts)
        {
            ZInterval zInterval{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
            for (const auto &part : parts)
            {
                const TriangleMesh *mesh = part.shape.getMesh();
                if (!mesh || part.shape.getDimension() == 3)
                    return {};
                const Eigen::AlignedBox3d &box = mesh->getBounds();
                const double lift = part.pose.translation().z();
                zInterval = zInterval.unitedWith({box.min().z() + lift, box.max().z() + lift});
            }
            return zInterval;
        }

        Body single(Shape shape)
        {
            return Body({{std::move(shape), Pose::Identity()}});
        }

        /** Where the origin of a shape that has these bounds is to be: where it is, or in their middle if it is far
            from there. The exact checks' tolerances grow with the distance of vertices from the origin. */
        Eigen::Vector3d originFor(const Eigen::AlignedBox3d &bounds, unsigned int dimension)
        {
            Eigen::Vector3d middle = bounds.center();
            // A planar mesh keeps its z.
            if (dimension == 2)
                middle.z() = 0.0;
            constexpr double far = 5.0;
            return middle.norm() > far * bounds.diagonal().norm() ? middle : Eigen::Vector3d::Zero();
        }

        std::vector<Eigen::Vector3d> moved(std::vector<Eigen::Vector3d> points, const Eigen::Vector3d &by)
        {
            for (Eigen::Vector3d &point : points)
                point += by;
            return points;
        }

        Body hullOf(const std::vector<Eigen::Vector3d> &points, unsigned int dimension)
        {
            Eigen::AlignedBox3d bounds;
            for (const Eigen::Vector3d &point : points)
                bounds.extend(point);
            const Eigen::Vector3d origin = points.empty() ? Eigen::Vector3d::Zero() : originFor(bounds, dimension);
            return Body({{Shape::polytope(dimension, moved(points, -origin)), poseAt(origin)}});
        }

        Body meshOf(TriangleMeshPtr mesh, unsigned int dimension)
        {
            const Shape shape = Shape::mesh(dimension, mesh);
            const Eigen::Vector3d origin = originFor(mesh->getBounds(), dimension);
            if (origin.isZero(0.0))
                return single(shape);
            mesh = std::make_shared<TriangleMesh>(moved(mesh->getVertices(), -origin), mesh->getTriangles());
            return Body({{Shape::mesh(dimension, std::move(mesh)), poseAt(origin)}});
        }

        std::vector<Eigen::Vector3d> spatial(const std::vector<Eigen::Vector2d> &points)
        {
            std::vector<Eigen::Vector3d> flat;
            flat.reserve(points.size());
            for (const auto &point : points)
                flat.emplace_back(point.x(), point.y(), 0.0);
            return flat;
        }

        std::string coordinatesOf(const Eigen::Vector3d &point, unsigned int dimension)
        {
            std::string text = "(" + std::to_string(point.x()) + ", " + std::to_string(point.y());
            return text + (dimension == 3 ? ", " + std::to_string(point.z()) + ")" : ")");
        }

        std::vector<Ball> enlarged(std::vector<Ball> balls, double padding)
        {
            for (Ball &ball : balls)
                ball.radius += padding;
            return balls;
        }

        void requireConvex(const Body &hull, const std::vector<Eigen::Vector3d> &points)
        {
            // So much may be lost of points on an edge or a face where they are written down.
            constexpr double rounding = 1e-6;
            const double deepest = rounding * hull.getBounds().diagonal().norm();
            for (std::size_t i = 0; i < points.size(); ++i)
                if (hull.signedDistance(points[i]) < -deepest)
                    throw ompl::Exception("Point " + std::to_string(i) + " of " + std::to_string(points.size()) +
                                          " (counted from 0), " + coordinatesOf(points[i], hull.getDimension()) +
                                          ", lies inside the convex hull of the others: make a body that is not convex "
                                          "of several shapes, or take their convex hull");
        }
    }

    Body Body::disc(double radius)
    {
        return single(Shape::ball(2, radius));
    }

    Body Body::sphere(double radius)
    {
        return single(Shape::ball(3, radius));
    }

    Body Body::box(double x, double y)
    {
        return single(Shape::box(Eigen::Vector2d(x, y)));
    }

    Body Body::box(double x, double y, double z)
    {
        return single(Shape::box(Eigen::Vector3d(x, y, z)));
    }

    Body Body::planarCapsule(double radius, double length)
    {
        // FCL's capsules lie along z: this one is turned to lie along x.
        Pose alongX = Pose::Identity();
        alongX.linear() << 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0;
        return Body({{Shape::capsule(2, radius, length), alongX}});
    }

    Body Body::capsule(double radius, double length)
    {
        return single(Shape::capsule(3, radius, length));
    }

    Body Body::cylinder(double radius, double length)
    {
        return single(Shape::cylinder(radius, length));
    }

    Body Body::convexPolygon(const std::vector<Eigen::Vector2d> &points)
    {
        Body hull = convexHull(points);
        requireConvex(hull, spatial(points));
        return hull;
    }

    Body Body::convexPolytope(const std::vector<Eigen::Vector3d> &points)
    {
        Body hull = convexHull(points);
        requireConvex(hull, points);
        return hull;
    }

    Body Body::convexHull(const std::vector<Eigen::Vector2d> &points)
    {
        return hullOf(spatial(points), 2);
    }

    Body Body::convexHull(const std::vector<Eigen::Vector3d> &points)
    {
        return hullOf(points, 3);
    }

    Body Body::mesh(TriangleMeshPtr mesh)
    {
        return meshOf(std::move(mesh), 3);
    }

    Body Body::planarMesh(TriangleMeshPtr mesh)
    {
        return meshOf(std::move(mesh), 2);
    }

    Body Body::join(const std::vector<PlacedBody> &bodies)
    {
        std::vector<Part> parts;
        for (const PlacedBody &placed : bodies)
        {
            if (placed.body.getPadding() != bodies.front().body.getPadding())
                throw ompl::Exception("Bodies of different paddings cannot be joined");
            for (const Part &part : placed.body.getParts())
                parts.push_back({part.shape, placed.pose * part.pose});
        }
        const Body shapes(std::move(parts));
        return shapes.padded(bodies.front().body.getPadding());
    }

    Body::Body(std::vector<Part> parts)
    {
        if (parts.empty())
            throw ompl::Exception("A body needs at least one shape");
        for (Part &part : parts)
        {
            if (part.shape.getDimension() != parts.front().shape.getDimension())
                throw ompl::Exception("A body is made of planar shapes or of spatial ones, not of both");
            part.pose = rigidPose(part.pose, "a body's shape");
            if (!part.shape.snapToPlane(part.pose))
                throw ompl::Exception("A planar shape turns about the z axis only, and is at z = 0 if it is no mesh");
        }
        data_ = std::make_shared<Data>();
        data_->isBall = parts.size() == 1 && parts.front().shape.getKind() == Shape::Kind::BALL;
        for (const Part &part : parts)
        {
            data_->boundingRadius = std::max(data_->boundingRadius, boundingRadiusOf(part));
            data_->bounds.extend(part.shape.getBounds().transformed(part.pose));
            data_->partBalls.push_back(ballAround(part));
        }
        data_->zInterval = zIntervalOf(parts);
        data_->parts = std::move(parts);
    }

    Body Body::padded(double padding) const
    {
        if (!(padding >= 0.0) || !std::isfinite(padding))
            throw ompl::Exception("The padding of a body must be finite and not negative, not " +
                                  std::to_string(padding));
        if (padding == 0.0)
            return withoutPadding();
        if (padding == getPadding())
            return *this;
        auto data = std::make_shared<Data>();
        data->base = withoutPadding().data_;
        const Data &base = *data->base;
        data->parts = base.parts;
        data->padding = padding;
        data->isBall = base.isBall;
        data->boundingRadius = base.boundingRadius + padding;
        const Eigen::Vector3d around(padding, padding, padding);
        data->bounds = {base.bounds.min() - around, base.bounds.max() + around};
        data->partBalls = enlarged(base.partBalls, padding);
        data->zInterval = {base.zInterval.low - padding, base.zInterval.high + padding};
        return Body(std::move(data));
    }

    const Body::Balls &Body::Data::makeBalls() const
    {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!balls && base)
        {
            const Balls &bare = base->getBalls();
            std::vector<SphereTree::Node> nodes = bare.sphereTree.getNodes();
            for (SphereTree::Node &node : nodes)
                node.ball.radius += padding;
            balls = std::make_unique<const Balls>(Balls{
                SphereTree(std::move(nodes)), enlarged(bare.innerSpheres, padding), bare.centralRadius + padding});
            made.store(balls.get(), std::memory_order_release);
        }
        if (!balls)
        {
            SphereTree sphereTree = buildSphereTree(parts);
            std::vector<Part> solids;
            for (const Part &part : parts)
                if (!part.shape.getMesh())
                    solids.push_back(part);
            std::vector<Ball> innerSpheres = buildInnerSpheres(solids, sphereTree);
            const double depth = -ompl_certificates::signedDistance(solids, sphereTree.getRoot().center);
            const double centralRadius = depth >= 0.0 ? depth : -std::numeric_limits<double>::infinity();
            balls = std::make_unique<const Balls>(Balls{std::move(sphereTree), std::move(innerSpheres), centralRadius});
            made.store(balls.get(), std::memory_order_release);
        }
        return *balls;
    }

    const std::vector<ConvexCover> &Body::getConvexCovers() const
    {
        if (const auto *known = data_->madeCovers.load(std::memory_order_acquire))
            return *known;
        const std::lock_guard<std::mutex> lock(data_->mutex);
        if (!data_->covers)
        {
            auto covers = std::make_shared<std::vector<ConvexCover>>();
            if (data_->base)
                for (const ConvexCover &cover : withoutPadding().getConvexCovers())
                    covers->push_back(cover.padded(data_->padding));
            else
                for (const Part &part : data_->parts)
                    covers->emplace_back(part.shape, part.pose);
            data_->covers = covers;
            data_->madeCovers.store(covers.get(), std::memory_order_release);
        }
        return *data_->covers;
    }

    unsigned int Body::getDimension() const
    {
        return getParts().front().shape.getDimension();
    }

    double Body::signedDistance(const Eigen::Vector3d &point) const
    {
        return ompl_certificates::signedDistance(getParts(), point) - getPadding();
    }

    bool Body::operator==(const Body &other) const
    {
        const auto same = [](const Part &a, const Part &b)
        { return a.shape == b.shape && a.pose.matrix() == b.pose.matrix(); };
        return data_ == other.data_ || (getPadding() == other.getPadding() &&
                                        std::equal(getParts().begin(), getParts().end(), other.getParts().begin(),
                                                   other.getParts().end(), same));
    }
}
