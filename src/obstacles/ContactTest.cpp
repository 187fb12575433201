#include "ContactTest.h"

#include "geometry/TriangleDistance.h"

#include <algorithm>
#include <limits>

namespace ompl_certificates
{
    ContactTest::ContactTest(const MeshSurface &surface, const ClearanceTree &primitives, unsigned int dimension,
                             double tolerance)
      : surface_(surface), primitives_(primitives), dimension_(dimension), tolerance_(tolerance)
    {
    }

    Touching ContactTest::touches(const Body &body, const Pose &pose, ObstaclePart *hit) const
    {
        const double margin = marginOf(body);
        bool unknown = false;
        if (primitives_.size() > 0)
        {
            const Ball &ball = body.getSphereTree().getRoot();
            unknown = primitives_.signedDistance(pose * ball.center) <= ball.radius + margin;
        }
        for (const auto &part : body.getParts())
        {
            const TriangleMesh *mesh = part.shape.getMesh();
            const Touching answer =
                mesh ? surface_.getTriangles().touches(mesh->getTree(), pose * part.pose, margin, hit)
                     : Touching::UNKNOWN;
            if (answer == Touching::YES)
                return answer;
            unknown = unknown || answer == Touching::UNKNOWN;
        }
        return unknown ? Touching::UNKNOWN : Touching::NO;
    }

    bool ContactTest::isFartherThan(double distance, const Body &body, const Pose &pose) const
    {
        const double margin = distance + marginOf(body);
        const Ball &ball = body.getSphereTree().getRoot();
        const Eigen::Vector3d center = pose * ball.center;
        if (primitives_.size() > 0 && !(primitives_.signedDistance(center) > ball.radius + margin))
            return false;
        if (surface_.isEmpty())
            return true;
        const auto isFar = [&](const Body::Part &part)
        {
            const TriangleMesh *mesh = part.shape.getMesh();
            return mesh ? surface_.getTriangles().isFartherThan(margin, mesh->getTree(), pose * part.pose)
                        : surface_.distance(center, std::numeric_limits<double>::infinity()) > ball.radius + margin;
        };
        return std::all_of(body.getParts().begin(), body.getParts().end(), isFar);
    }

    bool ContactTest::certainlyHits(const Body &body, const Pose &pose, ObstaclePart obstaclePart) const
    {
        const TriangleTree &triangles = surface_.getTriangles();
        if (obstaclePart >= triangles.size())
            return false;
        const double margin = marginOf(body);
        for (const auto &part : body.getParts())
        {
            const TriangleTree::Facet triangle(triangles.getTriangle(obstaclePart), (pose * part.pose).inverse());
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
