#include "PrimitiveContact.h"

#include "CutPolygon.h"
#include "Infinity.h"
#include "TriangleDistance.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** Polytopes with more pairs of faces take longer than FCL. */
        constexpr std::size_t MOST_FACE_PAIRS = 1000;

        using Triangle = std::array<Eigen::Vector3d, 3>;

        /** What it means that two shapes are so far apart, or, if it is negative, so deep in each other */
        Touching fromGap(double gap, double margin)
        {
            return gap > margin ? Touching::NO : gap < -margin ? Touching::YES : Touching::UNKNOWN;
        }

        /** A point of a triangle and one of the z axis */
        struct Pair
        {
            Eigen::Vector3d onTriangle;
            double z;

            double squaredDistance() const
            {
                return (onTriangle - Eigen::Vector3d(0.0, 0.0, z)).squaredNorm();
            }
        };

        /** The points of the edge from \e a to \e b and of the z axis within \e half of the origin that are nearest to
            each other. If the nearest points are ends of the latter, there may be nearer ones. */
        Pair nearestOfEdge(const Eigen::Vector3d &a, const Eigen::Vector3d &b, double half)
        {
            const Eigen::Vector2d from = a.head<2>(), edge = b.head<2>() - from;
            const double squared = edge.squaredNorm();
            const double along = squared > 0.0 ? std::clamp(-from.dot(edge) / squared, 0.0, 1.0) : 0.0;
            const Eigen::Vector3d point = a + along * (b - a);
            return {point, std::clamp(point.z(), -half, half)};
        }

        /** Whether the z axis within \e half of the origin passes through a triangle. One whose plane nearly contains
            the axis does not count: there the numbers below are rounding. If the axis passes through it, an edge is
            about as near to the axis, which the distance shows. */
        bool pierces(const Triangle &triangle, double half)
        {
            const auto &[a, b, c] = triangle;
            const Eigen::Vector3d normal = (b - a).cross(c - a);
            const auto side = [](const Eigen::Vector3d &p, const Eigen::Vector3d &q)
            { return p.x() * q.y() - p.y() * q.x(); };
            const double sides[3] = {side(a, b), side(b, c), side(c, a)};
            const bool inside = (sides[0] > 0.0 && sides[1] > 0.0 && sides[2] > 0.0) ||
                                (sides[0] < 0.0 && sides[1] < 0.0 && sides[2] < 0.0);
            constexpr double steepest = 1e-6;
            return inside && std::abs(normal.z()) > steepest * normal.norm() &&
                   std::abs(normal.dot(a)) <= std::abs(normal.z()) * half;
        }

        /** All points within \e radius of the z axis within \e half of the origin, against a triangle. With \e half ==
            0 a ball. Whichever points were found to be nearest to each other, NO is certain, as a plane between them
            proves it, and so is YES, as they are points of both. */
        Touching touchingCapsule(double radius, double half, const Triangle &triangle, double margin)
        {
            const auto &[a, b, c] = triangle;
            Pair nearest{nearestOfTriangle({0.0, 0.0, half}, a, b, c), half};
            if (half > 0.0)
            {
                const auto lower = [&nearest](const Pair &pair)
                {
                    if (pair.squaredDistance() < nearest.squaredDistance())
                        nearest = pair;
                };
                lower({nearestOfTriangle({0.0, 0.0, -half}, a, b, c), -half});
                for (std::size_t i = 0; i < 3; ++i)
                    lower(nearestOfEdge(triangle[i], triangle[(i + 1) % 3], half));
            }
            const double distance = std::sqrt(nearest.squaredDistance());
            if (distance < radius - margin || (radius > margin && half > 0.0 && pierces(triangle, half)))
                return Touching::YES;
            const Eigen::Vector3d axis = nearest.onTriangle - Eigen::Vector3d(0.0, 0.0, nearest.z);
            const double low = std::min({axis.dot(a), axis.dot(b), axis.dot(c)});
            return low - std::abs(axis.z()) * half > (radius + margin) * distance ? Touching::NO : Touching::UNKNOWN;
        }

        /** Cut away what is farther than \e half from the origin along an axis
            \return whether anything is left */
        bool cutAlong(CutPolygon &polygon, Eigen::Index axis, double half)
        {
            return half >= 0.0 && polygon.cut([&](const Eigen::Vector3d &p) { return p[axis] - half; }) &&
                   polygon.cut([&](const Eigen::Vector3d &p) { return -p[axis] - half; });
        }

        /** The distance of a polygon from the z axis is at least \e low, and at most \e high. */
        struct Distance
        {
            double low, high;
        };

        Distance distanceFromAxis(const CutPolygon &polygon)
        {
            Eigen::Vector2d nearest = polygon[0].head<2>();
            double squared = nearest.squaredNorm(), farthest = squared;
            for (std::size_t i = 0; i < polygon.size(); ++i)
            {
                const Eigen::Vector2d from = polygon[i].head<2>(),
                                      edge = polygon[i + 1 < polygon.size() ? i + 1 : 0].head<2>() - from;
                const double length = edge.squaredNorm(), along = -from.dot(edge);
                const Eigen::Vector2d point = along <= 0.0 || length == 0.0 ? from
                                              : along >= length             ? Eigen::Vector2d(from + edge)
                                                                : Eigen::Vector2d(from + along / length * edge);
                farthest = std::max(farthest, from.squaredNorm());
                if (point.squaredNorm() < squared)
                {
                    nearest = point;
                    squared = point.squaredNorm();
                }
            }
            // If the axis is outside, no corner comes nearer in the direction of the nearest point.
            double low = INF;
            for (std::size_t i = 0; i < polygon.size(); ++i)
                low = std::min(low, nearest.dot(polygon[i].head<2>()));
            const double distance = std::sqrt(squared);
            // Below that, the direction is all rounding.
            const bool around = low < 0.0 && squared > 1e-12 * farthest;
            return {low > 0.0 ? low / distance : 0.0, around ? 0.0 : distance};
        }

        Touching touchingCylinder(double radius, double half, CutPolygon &polygon, double margin)
        {
            if (!cutAlong(polygon, 2, half + margin) || distanceFromAxis(polygon).low > radius + margin)
                return Touching::NO;
            return cutAlong(polygon, 2, half - margin) && distanceFromAxis(polygon).high < radius - margin
                       ? Touching::YES
                       : Touching::UNKNOWN;
        }

        Touching touchingBox(const Eigen::Vector3d &half, CutPolygon &polygon, double margin)
        {
            for (Eigen::Index axis = 0; axis < 3; ++axis)
                if (!cutAlong(polygon, axis, half[axis] + margin))
                    return Touching::NO;
            for (Eigen::Index axis = 0; axis < 3; ++axis)
                if (!cutAlong(polygon, axis, half[axis] - margin))
                    return Touching::UNKNOWN;
            return Touching::YES;
        }

        Touching touchingHull(const ConvexHull &hull, CutPolygon &polygon, double margin)
        {
            for (const double shift : {margin, -margin})
                for (const auto &face : hull.faces)
                    if (!polygon.cut([&](const Eigen::Vector3d &p)
                                     { return face.normal.dot(p) - face.offset - shift; }))
                        return shift > 0.0 ? Touching::NO : Touching::UNKNOWN;
            return Touching::YES;
        }

        /** A polygon against a cylinder, a box or a polytope */
        Touching touchingPolygon(const Shape &primitive, CutPolygon &polygon, double margin)
        {
            const Eigen::Vector3d half = 0.5 * primitive.getSize();
            const Touching answer = primitive.getKind() == Shape::Kind::CYLINDER
                                        ? touchingCylinder(primitive.getRadius(), half.z(), polygon, margin)
                                    : primitive.getKind() == Shape::Kind::BOX && primitive.getDimension() == 3
                                        ? touchingBox(half, polygon, margin)
                                        : touchingHull(*primitive.getHull(), polygon, margin);
            return polygon.isComplete() ? answer : Touching::UNKNOWN;
        }

        /** How far apart two boxes are along the axis that separates them best: an edge of either, or across an edge of
            both. That is a lower bound of their distance. If it is negative, one of them must move so far until they
            only touch.
            \param enough larger gaps may be returned as any number above it */
        double gapOfBoxes(const Eigen::AlignedBox3d &boxA, const Eigen::AlignedBox3d &boxB, const Pose &pose,
                          double enough)
        {
            const Eigen::Matrix3d &turn = pose.linear(), absolute = turn.cwiseAbs();
            const Eigen::Vector3d halfA = 0.5 * boxA.sizes(), halfB = 0.5 * boxB.sizes(),
                                  shift = pose * boxA.center() - boxB.center();
            double gap =
                std::max((shift.cwiseAbs() - halfB - absolute * halfA).maxCoeff(),
                         ((turn.transpose() * shift).cwiseAbs() - halfA - absolute.transpose() * halfB).maxCoeff());
            for (Eigen::Index i = 0; i < 3 && gap <= enough; ++i)
                for (Eigen::Index j = 0; j < 3; ++j)
                {
                    const Eigen::Index i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
                    const double x = turn(i1, j), y = turn(i2, j), squared = x * x + y * y;
                    // Edges that are parallel to a ten-millionth need no axis across them: it differs too little from
                    // that of a face.
                    if (squared < 1e-14)
                        continue;
                    const double both = halfB[i1] * std::abs(y) + halfB[i2] * std::abs(x) +
                                        halfA[j1] * absolute(i, j2) + halfA[j2] * absolute(i, j1);
                    gap = std::max(gap, (std::abs(shift[i2] * x - shift[i1] * y) - both) / std::sqrt(squared));
                }
            return gap;
        }

        /** The faces of a box or a polytope against another one or a cylinder */
        Touching touchingFaces(const Shape &shape, const Shape &other, const Pose &pose, double margin)
        {
            const ConvexHull &hull = *shape.getHull();
            if (other.getHull() && hull.faces.size() * other.getHull()->faces.size() > MOST_FACE_PAIRS)
                return Touching::UNKNOWN;
            bool unknown = false;
            for (const auto &face : hull.faces)
            {
                CutPolygon polygon;
                for (const std::size_t vertex : face.vertices)
                    polygon.add(pose * hull.vertices[vertex]);
                const Touching answer = touchingPolygon(other, polygon, margin);
                if (answer == Touching::YES)
                    return answer;
                unknown = unknown || answer == Touching::UNKNOWN;
            }
            if (unknown)
                return Touching::UNKNOWN;
            // The other one is farther from the surface than the margin: it is outside, or all inside.
            const Eigen::Vector3d point = other.getHull() ? other.getHull()->vertices[0] : Eigen::Vector3d::Zero();
            return hull.signedDistance(pose.inverse() * point) < 0.0 ? Touching::YES : Touching::NO;
        }

        /** All points within \e radius of the z axis within \e half of the origin, against a convex shape. Along a line
            the signed distance to that is a convex function, which changes no faster than the point moves. */
        Touching touchingSegment(double radius, double half, const Shape &other, const Pose &pose, double margin)
        {
            const Eigen::Vector3d along = pose.linear().col(2);
            Eigen::Vector3d center = pose.translation();
            double lowest = other.signedDistance(center);
            for (;;)
            {
                // The lowest value is found within half of the center.
                if (lowest < radius - margin)
                    return Touching::YES;
                if (lowest - half > radius + margin)
                    return Touching::NO;
                // So written that it also ends where numbers are not numbers
                if (!(half > 0.25 * margin))
                    return Touching::UNKNOWN;
                half *= 0.5;
                for (const double side : {-half, half})
                {
                    const Eigen::Vector3d point = center + side * along;
                    if (const double value = other.signedDistance(point); value < lowest)
                    {
                        lowest = value;
                        center = point;
                        break;
                    }
                }
            }
        }

        Touching touchingCapsule(const Shape &capsule, const Shape &other, const Pose &pose, double margin)
        {
            return touchingSegment(capsule.getRadius(), 0.5 * capsule.getSize().z(), other, pose, margin);
        }

        /** One cylinder against another: a capsule around it that does not touch, or one inside it that does */
        Touching touchingCylinders(const Shape &cylinder, const Shape &other, const Pose &pose, double margin)
        {
            const double radius = cylinder.getRadius(), half = 0.5 * cylinder.getSize().z();
            if (touchingSegment(radius, half, other, pose, margin) == Touching::NO)
                return Touching::NO;
            const double inner = std::min(radius, half);
            return touchingSegment(inner, half - inner, other, pose, margin) == Touching::YES ? Touching::YES
                                                                                              : Touching::UNKNOWN;
        }
    }

    Touching touching(const Shape &primitive, const Triangle &triangle, double margin)
    {
        const Eigen::Vector3d half = 0.5 * primitive.getSize();
        if (primitive.getKind() == Shape::Kind::BALL || primitive.getKind() == Shape::Kind::CAPSULE)
            return touchingCapsule(primitive.getRadius(), half.z(), triangle, margin);
        const auto &[a, b, c] = triangle;
        if (primitive.getKind() == Shape::Kind::BOX)
        {
            // Most triangles are beyond a face.
            const Eigen::Array3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
            if ((low > half.array() + margin || high < -half.array() - margin).any())
                return Touching::NO;
        }
        CutPolygon polygon;
        for (const auto &corner : triangle)
            polygon.add(corner);
        return touchingPolygon(primitive, polygon, margin);
    }

    Touching touching(const Shape &a, const Shape &b, const Pose &pose, double margin)
    {
        using Kind = Shape::Kind;
        const Kind kindA = a.getKind(), kindB = b.getKind();
        if (kindA == Kind::BALL)
            return fromGap(b.signedDistance(pose.translation()) - a.getRadius(), margin);
        if (kindB == Kind::BALL)
            return fromGap(a.signedDistance(pose.inverse().translation()) - b.getRadius(), margin);
        const double gap = gapOfBoxes(a.getBounds(), b.getBounds(), pose, margin);
        if (gap > margin || (kindA == Kind::BOX && kindB == Kind::BOX && a.getDimension() == 3))
            return fromGap(gap, margin);
        // Most shapes that touch a box contain its point that is nearest to their origin.
        if (kindB == Kind::BOX && b.getDimension() == 3)
        {
            const Eigen::Vector3d half = 0.5 * b.getSize(), point = pose.translation().cwiseMin(half).cwiseMax(-half);
            if (a.signedDistance(pose.inverse() * point) < -margin)
                return Touching::YES;
        }
        if (kindA == Kind::CAPSULE)
            return touchingCapsule(a, b, pose, margin);
        if (kindB == Kind::CAPSULE)
            return touchingCapsule(b, a, pose.inverse(), margin);
        if (a.getHull())
            return touchingFaces(a, b, pose, margin);
        if (b.getHull())
            return touchingFaces(b, a, pose.inverse(), margin);
        const Touching answer = touchingCylinders(a, b, pose, margin);
        return answer == Touching::UNKNOWN ? touchingCylinders(b, a, pose.inverse(), margin) : answer;
    }
}
