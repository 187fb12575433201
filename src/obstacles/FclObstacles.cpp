#include "ompl_certificates/obstacles/FclObstacles.h"

#include "ClearanceTree.h"
#include "ContactTest.h"
#include "FclBodies.h"
#include "FclTolerance.h"
#include "Fingerprint.h"
#include "PlanarCheck.h"
#include "SpatialCheck.h"
#include "geometry/RigidPose.h"

#include <algorithm>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        /** Among no more primitives than this a clearance costs less than the search for a certificate. */
        constexpr std::size_t FEW_PRIMITIVES = 16;

        /** Among no more than this the gap of a mesh costs less than the clearances of its balls. */
        constexpr std::size_t MANY_PRIMITIVES = 256;

        /** Calls \e work, whose complaints are about one of \e count obstacles, and says which */
        template <typename Work>
        void naming(std::size_t index, std::size_t count, const Work &work)
        {
            try
            {
                work();
            }
            catch (const ompl::Exception &exception)
            {
                if (count == 1)
                    throw;
                throw ompl::Exception("obstacle " + std::to_string(index), exception.what());
            }
        }

        std::vector<PlacedBody> bodiesOf(const std::vector<std::shared_ptr<fcl::CollisionObjectd>> &objects,
                                         unsigned int dimension)
        {
            std::vector<PlacedBody> bodies;
            bodies.reserve(objects.size());
            for (const auto &object : objects)
                naming(bodies.size(), objects.size(),
                       [&]
                       {
                           if (!object)
                               throw ompl::Exception("A collision object must not be null");
                           bodies.push_back(bodyOf(*object, dimension));
                       });
            return bodies;
        }

        /** Appends the shapes of an obstacle, which must have the dimension and pose that its workspace needs */
        void append(const PlacedBody &obstacle, unsigned int dimension, PlacedShapes &shapes)
        {
            const auto &[body, pose] = obstacle;
            if (body.getPadding() > 0.0)
                throw ompl::Exception("Obstacles have no padding; give it to the robots' bodies");
            if (body.getDimension() != dimension)
                throw ompl::Exception("An obstacle has " + std::to_string(body.getDimension()) +
                                      " dimensions, its workspace " + std::to_string(dimension));
            const Pose rigid = rigidPose(pose, "an obstacle");
            for (const auto &part : body.getParts())
            {
                Pose partPose = rigid * part.pose;
                if (!part.shape.snapToPlane(partPose))
                    throw ompl::Exception(
                        "An obstacle of a planar workspace must stand upright, and at z = 0 if it is no mesh");
                shapes.push_back({part.shape, partPose});
            }
        }

        /** The shapes of \e obstacles, each checked for the dimension and pose that its workspace needs */
        PlacedShapes placed(const std::vector<PlacedBody> &obstacles, unsigned int dimension)
        {
            if (dimension != 2 && dimension != 3)
                throw ompl::Exception("A workspace has 2 or 3 dimensions, not " + std::to_string(dimension));
            PlacedShapes shapes;
            for (std::size_t i = 0; i < obstacles.size(); ++i)
                naming(i, obstacles.size(), [&] { append(obstacles[i], dimension, shapes); });
            return shapes;
        }

        /** The meshes of some shapes, and where they are */
        std::vector<std::pair<const TriangleMesh *, Eigen::Matrix4d>> meshesOf(const PlacedShapes &shapes)
        {
            std::vector<std::pair<const TriangleMesh *, Eigen::Matrix4d>> meshes;
            for (const auto &[shape, pose] : shapes)
                if (const TriangleMesh *mesh = shape.getMesh())
                    meshes.emplace_back(mesh, pose.matrix());
            return meshes;
        }
    }

    FclObstacles::FclObstacles(const std::vector<PlacedBody> &obstacles, unsigned int dimension,
                               const ZInterval &zInterval)
      : FclObstacles(obstacles, dimension, zInterval, nullptr)
    {
    }

    FclObstacles::FclObstacles(const std::vector<PlacedBody> &obstacles, const FclObstacles &known)
      : FclObstacles(obstacles, known.dimension_, known.zInterval_, &known)
    {
    }

    FclObstacles::FclObstacles(const std::vector<PlacedBody> &obstacles, unsigned int dimension,
                               const ZInterval &zInterval, const FclObstacles *known)
      : dimension_(dimension), zInterval_(zInterval), bodies_(obstacles), clearances_(std::make_unique<ClearanceTree>())
    {
        const PlacedShapes shapes = placed(obstacles, dimension);
        for (const PlacedShape &shape : shapes)
            if (!isMesh(shape))
                clearances_->add(shape.shape, shape.pose);
        clearances_->build();
        // The bodies of both keep their meshes, so equal addresses are those of one mesh.
        if (known && meshesOf(shapes) == meshesOf(placed(known->bodies_, dimension)))
            surface_ = known->surface_;
        else
            surface_ = std::make_shared<MeshSurface>(shapes, dimension, zInterval);

        // In the plane, primitives are checked against meshes as prisms of the meshes' height.
        double prismHeight = 0.0;
        if (dimension == 2)
        {
            const ZInterval &meshes = surface_->getZInterval();
            if (std::any_of(shapes.begin(), shapes.end(), isMesh))
                prismHeight = std::max(0.0, meshes.high - meshes.low);
        }
        tolerance_ = fclTolerance(shapes, prismHeight);
        primitives_ = std::make_unique<PrimitiveList>(shapes);
        contactTest_ = std::make_unique<ContactTest>(*surface_, *primitives_, dimension, tolerance_);
    }

    FclObstacles::FclObstacles(const std::vector<std::shared_ptr<fcl::CollisionObjectd>> &objects,
                               unsigned int dimension, const ZInterval &zInterval)
      : FclObstacles(bodiesOf(objects, dimension), dimension, zInterval)
    {
    }

    FclObstacles::~FclObstacles() = default;

    void FclObstacles::requireObstacle(const PlacedBody &obstacle, unsigned int dimension)
    {
        placed({obstacle}, dimension);
    }

    bool FclObstacles::collides(const Body &body, const Pose &pose) const
    {
        if (body.getPadding() > 0.0)
            return contactTest_->findWithin(body, pose, body.getPadding()) != NO_PART;
        return fclCheck().collides(body, pose);
    }

    const FclCheck &FclObstacles::fclCheck() const
    {
        std::call_once(fclCheckMade_,
                       [this]
                       {
                           const PlacedShapes shapes = placed(bodies_, dimension_);
                           if (dimension_ == 2)
                               fclCheck_ = std::make_unique<PlanarCheck>(shapes, surface_->getZInterval());
                           else
                               fclCheck_ = std::make_unique<SpatialCheck>(shapes);
                       });
        return *fclCheck_;
    }

    double FclObstacles::clearance(const Eigen::Vector3d &point) const
    {
        return surface_->distance(point, clearances_->signedDistance(point));
    }

    double FclObstacles::clearanceUpTo(const Eigen::Vector3d &point, double most) const
    {
        return surface_->distance(point, clearances_->signedDistance(point, most));
    }

    double FclObstacles::findNearest(const Eigen::Vector3d &point, ObstaclePart &part) const
    {
        return surface_->findNearest(point, clearances_->signedDistance(point), part);
    }

    Touching FclObstacles::touches(const Body &body, const Pose &pose, ObstaclePart *hit) const
    {
        return contactTest_->touches(body, pose, hit);
    }

    BatchMask FclObstacles::mayTouch(const Body &body, const PoseBatch &poses, const PoseError &error) const
    {
        return contactTest_->mayTouch(body, poses, error);
    }

    double FclObstacles::gap(const Body &body, const Pose &pose, double needed, double wanted) const
    {
        return contactTest_->gap(body, pose, needed, wanted);
    }

    bool FclObstacles::hasGap() const
    {
        return surface_->isEmpty() && primitives_->size() <= MANY_PRIMITIVES;
    }

    bool FclObstacles::staysFree(const Body &body, const Pose &pose, double distance) const
    {
        return contactTest_->staysFree(body, pose, distance);
    }

    bool FclObstacles::certainlyHits(const Body &body, const Pose &pose, ObstaclePart part) const
    {
        return contactTest_->certainlyHits(body, pose, part);
    }

    bool FclObstacles::isClearanceCheap() const
    {
        return surface_->isEmpty() && primitives_->size() <= FEW_PRIMITIVES;
    }

    std::uint64_t FclObstacles::getFingerprint() const
    {
        // The z-interval matters only where it cuts meshes.
        const bool cuts = dimension_ == 2 && !surface_->isEmpty();
        std::uint64_t sum =
            fingerprintOf({double(dimension_), cuts ? zInterval_.low : 0.0, cuts ? zInterval_.high : 0.0});
        for (const PlacedBody &body : bodies_)
            sum += fingerprintOf(body);
        return sum == 0 ? 1 : sum;
    }
}
