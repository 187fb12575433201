#include "ompl_certificates/obstacles/FclObstacles.h"

#include "FclBodies.h"
#include "Fingerprint.h"
#include "Prisms.h"
#include "geometry/TriangleDistance.h"

#include <algorithm>
#include <cmath>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        /** The tolerance of FCL's checks of meshes, relative to their sizes: its solver for a primitive and a triangle. That
            of two triangles is better; those that are just not degenerate have normals that are known to 2e-7. */
        constexpr double MESH_TOLERANCE = 1e-6;

        /** What FCL may be wrong by whatever the sizes, in the scene's unit. Products of up to four lengths must stay above
            its solver's absolute threshold, the rounding of 1.0: shapes that are smaller than this are judged by their
            boxes at worst. */
        constexpr double ABSOLUTE_TOLERANCE = 5e-4 / Shape::FCL_SCALE;

        /** Where FCL is asked about a part. Its solver is wrong about prisms that are equally high and exactly level, as all
            polygons of a plane are: it finds them touching at up to a hundredth of their size. Hence polytopes are lifted,
            in the plane, where that changes nothing, by a part of their height, in space by less than what decides. */
        Pose poseForFcl(const Shape &shape, unsigned int dimension, const Pose &pose)
        {
            if (shape.getKind() != Shape::Kind::POLYTOPE)
                return pose;
            const double radius = shape.getCollisionGeometry()->aabb_radius / Shape::FCL_SCALE;
            Pose moved = pose;
            moved.translation() += dimension == 2 ? Eigen::Vector3d(0.0, 0.0, 0.1 * radius)
                                                  : 1e-9 * radius * Eigen::Vector3d(0.5, 0.6, 0.7);
            return moved;
        }

        /** What a triangle has between two heights */
        std::vector<Eigen::Vector3d> between(const TriangleTree::Corners &triangle, double low, double high)
        {
            std::vector<Eigen::Vector3d> outline(triangle.begin(), triangle.end());
            for (const double sign : {1.0, -1.0})
            {
                const double bound = sign > 0.0 ? low : -high;
                std::vector<Eigen::Vector3d> kept;
                for (std::size_t i = 0; i < outline.size(); ++i)
                {
                    const Eigen::Vector3d &a = outline[i], &b = outline[(i + 1) % outline.size()];
                    const double za = sign * a.z(), zb = sign * b.z();
                    if (za >= bound)
                        kept.push_back(a);
                    if ((za < bound) != (zb < bound))
                        kept.push_back(a + (bound - za) / (zb - za) * (b - a));
                }
                outline = std::move(kept);
            }
            return outline;
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
            bodies_.push_back(bodyOf(*object, dimension));
        }
        build();
    }

    FclObstacles::~FclObstacles() = default;

    void FclObstacles::build()
    {
        if (dimension_ != 2 && dimension_ != 3)
            throw ompl::Exception("A workspace has 2 or 3 dimensions, not " + std::to_string(dimension_));
        shapes_ = std::make_unique<Broadphase>();
        planarMeshes_ = std::make_unique<Broadphase>();
        robotPrisms_ = std::make_unique<RobotPrisms>();
        obstaclePrisms_ = std::make_unique<ObstaclePrisms>();
        double largest = 0.0, largestMesh = 0.0, farthest = 0.0;
        for (const auto &[body, pose] : bodies_)
        {
            if (body.getDimension() != dimension_)
                throw ompl::Exception("An obstacle has " + std::to_string(body.getDimension()) +
                                      " dimensions, its workspace " + std::to_string(dimension_));
            if (!pose.matrix().allFinite())
                throw ompl::Exception("The pose of an obstacle must be finite");
            for (const auto &part : body.getParts())
            {
                Pose partPose = pose * part.pose;
                if (!part.shape.putInPlace(partPose))
                    throw ompl::Exception(
                        "An obstacle of a planar workspace must stand upright, and at z = 0 if it is no "
                        "mesh");
                Broadphase &broadphase = dimension_ == 2 && part.shape.getMesh() ? *planarMeshes_ : *shapes_;
                broadphase.add(part.shape.getCollisionGeometry(), partPose);
                if (const TriangleMesh *mesh = part.shape.getMesh())
                    addTriangles(*mesh, partPose);
                else
                    clearances_.add(part.shape, partPose);
                const auto bounds = part.shape.getBounds();
                double &size = part.shape.getMesh() ? largestMesh : largest;
                size = std::max(size, bounds.max().cwiseMax(-bounds.min()).norm());
                farthest = std::max(farthest, partPose.translation().norm());
            }
        }
        shapes_->setup();
        planarMeshes_->setup();
        clearances_.build();
        surface_.build();
        if (dimension_ == 2)
            project();
        // A primitive is checked against planar meshes as a prism that is as high as they are.
        if (!planarMeshes_->isEmpty())
            largest = std::max(largest, meshHeights_.high - meshHeights_.low);
        // The last term pays for the rounding of coordinates far from the origin.
        tolerance_ =
            exactCheckTolerance(largest) + MESH_TOLERANCE * largestMesh + 1e-14 * farthest + ABSOLUTE_TOLERANCE;
    }

    bool FclObstacles::collides(const Body &body, const Pose &pose) const
    {
        return std::any_of(body.getParts().begin(), body.getParts().end(),
                           [&](const Body::Part &part)
                           {
                               const Pose partPose = pose * part.pose;
                               return dimension_ == 2 ? collidesInPlane(part, partPose)
                                                      : collidesWithShapes(part.shape, partPose);
                           });
    }

    bool FclObstacles::collidesWithShapes(const Shape &shape, const Pose &partPose) const
    {
        return !shapes_->isEmpty() &&
               shapes_->collides(shape.getCollisionGeometry(), poseForFcl(shape, dimension_, partPose));
    }

    bool FclObstacles::collidesInPlane(const Body::Part &part, const Pose &partPose) const
    {
        if (const TriangleMesh *mesh = part.shape.getMesh())
        {
            if (!planarMeshes_->isEmpty() && planarMeshes_->collides(part.shape.getCollisionGeometry(), partPose))
                return true;
            if (shapes_->isEmpty())
                return false;
            // The prisms are about the plane z = 0.
            const double low = mesh->getBounds().min().z(), high = mesh->getBounds().max().z();
            Pose lowered = partPose;
            lowered.translation().z() = -0.5 * (low + high);
            const double extent = part.shape.getBounds().sizes().maxCoeff();
            return obstaclePrisms_->get(bodies_, 2.0 * extent).collides(part.shape.getCollisionGeometry(), lowered);
        }
        if (collidesWithShapes(part.shape, partPose))
            return true;
        if (planarMeshes_->isEmpty() || meshHeights_.low > meshHeights_.high)
            return false;
        const double height = meshHeights_.high - meshHeights_.low,
                     middle = 0.5 * (meshHeights_.low + meshHeights_.high);
        return robotPrisms_->get(part.shape, height).collides(*planarMeshes_, partPose, middle);
    }

    void FclObstacles::addTriangles(const TriangleMesh &mesh, const Pose &pose)
    {
        for (std::size_t i = 0; i < mesh.getTriangles().size(); ++i)
        {
            if (mesh.isDegenerate(i))
                continue;
            const auto [a, b, c] = mesh.getCorners(i);
            surface_.add({pose * a, pose * b, pose * c}, 0);
        }
    }

    void FclObstacles::project()
    {
        if (surface_.size() == 0)
            return;
        const Eigen::AlignedBox3d bounds = surface_.getBounds();
        const double size = bounds.sizes().maxCoeff();
        // A little more than the robots reach, so that rounding leaves nothing out; prisms reach still a little farther.
        const double slack = EXACT_CHECK_TOLERANCE * size;
        meshHeights_ = Heights{heights_.low - 2.0 * slack, heights_.high + 2.0 * slack}.intersectedWith(
            {bounds.min().z() - 0.05 * size, bounds.max().z() + 0.05 * size});
        for (std::uint32_t i = 0; i < surface_.size(); ++i)
        {
            const auto &corners = surface_.getTriangle(i).corners;
            std::vector<Eigen::Vector3d> outline = between(corners, heights_.low - slack, heights_.high + slack);
            for (auto &corner : outline)
                corner.z() = 0.0;
            if (outline.empty())
                continue;
            // An upright triangle is a segment, seen from above.
            if (surface_.getTriangle(i).normal.z() == 0.0)
            {
                const auto [first, last] =
                    std::minmax_element(outline.begin(), outline.end(),
                                        [](const Eigen::Vector3d &a, const Eigen::Vector3d &b)
                                        { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
                outlines_.add({*first, *last, *last}, i);
            }
            else
                for (std::size_t k = 1; k == 1 || k + 1 < outline.size(); ++k)
                    outlines_.add({outline[0], outline[k % outline.size()], outline[(k + 1) % outline.size()]}, i);
        }
        outlines_.build();
    }

    std::uint64_t FclObstacles::getFingerprint() const
    {
        // Heights matter only where they cut meshes.
        const bool cuts = dimension_ == 2 && surface_.size() > 0;
        std::uint64_t sum = fingerprintOf({double(dimension_), cuts ? heights_.low : 0.0, cuts ? heights_.high : 0.0});
        for (const PlacedBody &body : bodies_)
            sum += fingerprintOf(body);
        return sum == 0 ? 1 : sum;
    }

    double FclObstacles::clearance(const Eigen::Vector3d &point) const
    {
        return clearanceTriangles().distance(point, clearances_.signedDistance(point));
    }

    double FclObstacles::findNearest(const Eigen::Vector3d &point, ObstaclePart &part) const
    {
        std::uint32_t nearest;
        const double distance = clearanceTriangles().distance(point, clearances_.signedDistance(point), &nearest);
        part = nearest == TriangleTree::NONE ? NO_PART : dimension_ == 2 ? outlines_.getName(nearest) : nearest;
        return distance;
    }

    Touching FclObstacles::touches(const Body &body, const Pose &pose, ObstaclePart *hit) const
    {
        const double margin = marginOf(body);
        bool unknown = false;
        if (clearances_.size() > 0)
        {
            const Ball &ball = body.getCover().getRoot();
            unknown = clearances_.signedDistance(pose * ball.center) <= ball.radius + margin;
        }
        for (const auto &part : body.getParts())
        {
            const TriangleMesh *mesh = part.shape.getMesh();
            const Touching answer =
                mesh ? surface_.touches(mesh->getTree(), pose * part.pose, margin, hit) : Touching::UNKNOWN;
            if (answer == Touching::YES)
                return answer;
            unknown = unknown || answer == Touching::UNKNOWN;
        }
        return unknown ? Touching::UNKNOWN : Touching::NO;
    }

    bool FclObstacles::certainlyHits(const Body &body, const Pose &pose, ObstaclePart obstaclePart) const
    {
        if (obstaclePart >= surface_.size())
            return false;
        const double margin = marginOf(body);
        for (const auto &part : body.getParts())
        {
            const TriangleTree::Facet triangle(surface_.getTriangle(obstaclePart), (pose * part.pose).inverse());
            if (const TriangleMesh *mesh = part.shape.getMesh())
            {
                if (mesh->getTree().touches(triangle, margin) == Touching::YES)
                    return true;
            }
            else if (dimension_ == 3)
            {
                const auto &[a, b, c] = triangle.corners;
                const Eigen::Vector3d nearest = nearestOfTriangle(part.shape.getBounds().center(), a, b, c);
                if (part.shape.signedDistance(nearest) < -margin)
                    return true;
            }
        }
        return false;
    }
}
