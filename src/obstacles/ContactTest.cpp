#include "ContactTest.h"

#include "geometry/ConvexCover.h"
#include "geometry/PrimitiveContact.h"
#include "geometry/WithinDistance.h"

#include <algorithm>
#include <array>
#include <limits>

namespace ompl_certificates
{
    namespace
    {
        /** In the plane FCL is quicker among more triangles than this: those of upright walls are tiny, and seen from
            above they lie upon each other. Measured with 30 000 and 300 000. */
        constexpr std::size_t MOST_PLANAR_TRIANGLES = 100000;

        /** Where more primitives are near a body, its gap would cost more than it saves. */
        constexpr std::size_t MOST_NEAR = 32;
    }

    ContactTest::ContactTest(const MeshSurface &surface, const PrimitiveList &primitives, unsigned int dimension,
                             double tolerance)
      : surface_(surface), primitives_(primitives), dimension_(dimension), tolerance_(tolerance)
    {
    }

    Touching ContactTest::test(const Body &body, const Pose &pose, double margin, ObstaclePart *hit) const
    {
        Touching all = Touching::NO;
        // Whether this answer settles the matter
        const auto note = [&all](Touching answer)
        {
            if (answer != Touching::NO)
                all = answer;
            return answer == Touching::YES;
        };
        if (!surface_.isEmpty())
            for (const auto &part : body.getParts())
                if (note(touchesTriangles(part.shape, pose * part.pose, margin, hit)))
                    return all;
        if (primitives_.size() == 0)
            return all;
        const Ball &ball = body.getSphereTree().getRoot();
        primitives_.visitNear({pose * ball.center, ball.radius + margin},
                              [&](std::size_t primitive)
                              {
                                  for (const auto &part : body.getParts())
                                      if (note(touchesPrimitive(part.shape, pose * part.pose, primitive, margin)))
                                      {
                                          if (hit)
                                              *hit =
                                                  static_cast<ObstaclePart>(surface_.getTriangles().size() + primitive);
                                          return true;
                                      }
                                  return false;
                              });
        return all;
    }

    ObstaclePart ContactTest::findTriangleWithin(const Shape &shape, const Pose &pose, double distance) const
    {
        if (shape.getKind() == Shape::Kind::BALL)
        {
            ObstaclePart nearest;
            const double reach = shape.getRadius() + distance;
            // Any limit above the distance will do.
            return surface_.findNearest(pose.translation(), 1.001 * reach, nearest) <= reach ? nearest : NO_PART;
        }
        const TriangleTree &triangles = surface_.getTriangles();
        const TriangleMesh *mesh = shape.getMesh();
        const std::uint32_t found = mesh ? triangles.findWithin(mesh->getTree(), pose, distance)
                                         : triangles.findWithin(shape, pose.inverse(), distance);
        return found == TriangleTree::NONE ? NO_PART : found;
    }

    ObstaclePart ContactTest::findWithin(const Body &body, const Pose &pose, double distance) const
    {
        ObstaclePart found = NO_PART;
        if (!surface_.isEmpty())
            for (const Body::Part &part : body.getParts())
                if (found = findTriangleWithin(part.shape, pose * part.pose, distance); found != NO_PART)
                    return found;
        const Ball &ball = body.getSphereTree().getRoot();
        const double reach = ball.radius - body.getPadding() + distance + marginOf(body);
        primitives_.visitNear(
            {pose * ball.center, reach},
            [&](std::size_t position)
            {
                const PrimitiveList::Primitive &primitive = primitives_[position];
                for (const Body::Part &part : body.getParts())
                    if (areWithin(primitive.shape, part.shape, primitive.toShape * pose * part.pose, distance))
                        found = static_cast<ObstaclePart>(surface_.getTriangles().size() + position);
                return found != NO_PART;
            });
        return found;
    }

    BatchMask ContactTest::mayTouch(const Body &body, const PoseBatch &poses, const PoseError &error) const
    {
        if (dimension_ == 2)
            return WHOLE_BATCH;
        const double margin = marginOf(body);
        const BoxBatch box{body.getBounds(), poses, error};
        BatchMask all = primitives_.mayTouch(body.getSphereTree().getRoot(), box, margin);
        if (all != WHOLE_BATCH && !surface_.isEmpty())
            all = static_cast<BatchMask>(
                all | mayOverlap(surface_.getTriangles().getBounds(), Pose::Identity(), box, margin));
        return all;
    }

    Touching ContactTest::touchesTriangles(const Shape &shape, const Pose &pose, double margin, ObstaclePart *hit) const
    {
        if (dimension_ == 2 && surface_.getTriangles().size() > MOST_PLANAR_TRIANGLES)
            return Touching::UNKNOWN;
        if (const TriangleMesh *mesh = shape.getMesh())
            return surface_.getTriangles().touches(mesh->getTree(), pose, margin, hit);
        // A planar primitive touches meshes at any z.
        return dimension_ == 3 ? surface_.getTriangles().touches(shape, pose.inverse(), margin, hit)
                               : Touching::UNKNOWN;
    }

    Touching ContactTest::touchesPrimitive(const Shape &shape, const Pose &pose, std::size_t primitive,
                                           double margin) const
    {
        const Shape &obstacle = primitives_[primitive].shape;
        const Pose &toObstacle = primitives_[primitive].toShape;
        const TriangleMesh *mesh = shape.getMesh();
        if (!mesh)
            return touching(shape, obstacle, toObstacle * pose, margin);
        return dimension_ == 3 ? mesh->getTree().touches(obstacle, toObstacle * pose, margin) : Touching::UNKNOWN;
    }

    double ContactTest::gap(const Body &body, const Pose &pose, double needed, double wanted) const
    {
        if (!surface_.isEmpty())
            return -std::numeric_limits<double>::infinity();
        double least = wanted;
        for (const ConvexCover &cover : body.getConvexCovers())
            if (least > needed)
                least = gapOfCover(cover, pose, needed, least);
        return least;
    }

    double ContactTest::gapOfCover(const ConvexCover &cover, const Pose &pose, double needed, double wanted) const
    {
        struct Near
        {
            double bound;
            const PrimitiveList::Primitive *primitive;
        };
        std::array<Near, MOST_NEAR> near;
        const Eigen::Vector3d center = pose * cover.getCenter();
        const double radius = cover.getExtent() + cover.getRounding();
        std::size_t count = 0;
        primitives_.visitNear({center, radius + wanted},
                              [&](std::size_t position)
                              {
                                  const PrimitiveList::Primitive &primitive = primitives_[position];
                                  const double bound =
                                      primitive.shape.signedDistance(primitive.toShape * center) - radius;
                                  if (bound < wanted)
                                      near[count++] = {bound, &primitive};
                                  return count == near.size();
                              });
        if (count == near.size())
            return -std::numeric_limits<double>::infinity();
        // The nearest first: it mostly makes the others too far to matter.
        std::sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count),
                  [](const Near &x, const Near &y) { return x.bound < y.bound; });
        double least = wanted;
        for (std::size_t i = 0; i < count && near[i].bound < least && least > needed; ++i)
        {
            const PrimitiveList::Primitive &primitive = *near[i].primitive;
            const Eigen::Vector3d local = primitive.toShape * center;
            Eigen::Vector3d direction = local - local.cwiseMax(primitive.bounds.min()).cwiseMin(primitive.bounds.max());
            least =
                std::min(least, convexGap(primitive.cover, cover, primitive.toShape * pose, needed, least, direction));
        }
        return least;
    }

    bool ContactTest::certainlyHits(const Body &body, const Pose &pose, ObstaclePart obstaclePart) const
    {
        const std::size_t triangles = surface_.getTriangles().size();
        if (obstaclePart >= triangles + primitives_.size())
            return false;
        if (body.getPadding() > 0.0)
            return certainlyReaches(body, pose, obstaclePart);
        const double margin = marginOf(body);
        for (const auto &part : body.getParts())
        {
            const Pose partPose = pose * part.pose;
            if (obstaclePart < triangles
                    ? hitsTriangle(part.shape, partPose, obstaclePart, margin)
                    : touchesPrimitive(part.shape, partPose, obstaclePart - triangles, margin) == Touching::YES)
                return true;
        }
        return false;
    }

    bool ContactTest::certainlyReaches(const Body &body, const Pose &pose, ObstaclePart obstaclePart) const
    {
        const double distance = body.getPadding() - marginOf(body);
        const std::size_t triangles = surface_.getTriangles().size();
        // In the plane, a triangle may reach out of the z-interval in which it counts.
        if (!(distance > 0.0) || (obstaclePart < triangles && dimension_ == 2))
            return false;
        return std::any_of(
            body.getParts().begin(), body.getParts().end(),
            [&](const Body::Part &part)
            {
                const Pose partPose = pose * part.pose;
                if (obstaclePart >= triangles)
                {
                    const PrimitiveList::Primitive &primitive = primitives_[obstaclePart - triangles];
                    return areWithin(primitive.shape, part.shape, primitive.toShape * partPose, distance);
                }
                const TriangleTree::Facet facet(surface_.getTriangles().getTriangle(obstaclePart), partPose.inverse());
                const TriangleMesh *mesh = part.shape.getMesh();
                return mesh ? mesh->getTree().isWithin(facet.corners, distance)
                            : isWithin(part.shape, facet.corners, Eigen::Vector3d::Zero(), distance);
            });
    }

    bool ContactTest::hitsTriangle(const Shape &shape, const Pose &pose, std::uint32_t triangle, double margin) const
    {
        const TriangleTree::Facet facet(surface_.getTriangles().getTriangle(triangle), pose.inverse());
        if (const TriangleMesh *mesh = shape.getMesh())
            return mesh->getTree().touches(facet, margin) == Touching::YES;
        return dimension_ == 3 && touching(shape, facet.corners, margin) == Touching::YES;
    }
}
