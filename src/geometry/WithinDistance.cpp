#include "WithinDistance.h"

#include "ConvexSearch.h"
#include "TriangleTree.h"

#include <algorithm>

namespace ompl_certificates
{
    namespace
    {
        /** Two solids whose distance is known to this fraction of it are known well enough. */
        constexpr double PRECISION = 1.0 - 1e-12;

        /** Round solids take some ten steps; after so many the rest is rounding. */
        constexpr unsigned int MOST_STEPS = 128;

        using Triangle = std::array<Eigen::Vector3d, 3>;

        /** The farthest point of a primitive in a direction, without what its radius() adds around it */
        class Primitive
        {
        public:
            explicit Primitive(const Shape &shape) : shape_(shape)
            {
            }

            double radius() const
            {
                return shape_.getKind() == Shape::Kind::CYLINDER ? 0.0 : shape_.getRadius();
            }

            Eigen::Vector3d middle() const
            {
                const ConvexHull *hull = shape_.getKind() == Shape::Kind::POLYTOPE ? shape_.getHull() : nullptr;
                return hull ? hull->vertices.front() : Eigen::Vector3d(Eigen::Vector3d::Zero());
            }

            Eigen::Vector3d farthest(const Eigen::Vector3d &direction) const
            {
                const Eigen::Vector3d half = 0.5 * shape_.getSize();
                const auto along = [&](int axis) { return direction[axis] < 0.0 ? -half[axis] : half[axis]; };
                switch (shape_.getKind())
                {
                    case Shape::Kind::BALL:
                        return Eigen::Vector3d::Zero();
                    case Shape::Kind::BOX:
                        return {along(0), along(1), along(2)};
                    case Shape::Kind::CAPSULE:
                        return {0.0, 0.0, along(2)};
                    case Shape::Kind::CYLINDER:
                    {
                        const Eigen::Vector2d across = direction.head<2>().stableNormalized() * shape_.getRadius();
                        return {across.x(), across.y(), along(2)};
                    }
                    default:
                        break;
                }
                const auto &vertices = shape_.getHull()->vertices;
                return *std::max_element(vertices.begin(), vertices.end(),
                                         [&](const Eigen::Vector3d &a, const Eigen::Vector3d &b)
                                         { return direction.dot(a) < direction.dot(b); });
            }

        private:
            const Shape &shape_;
        };

        /** The same of a triangle */
        class Corners
        {
        public:
            explicit Corners(const Triangle &corners) : corners_(corners)
            {
            }

            double radius() const
            {
                return 0.0;
            }

            const Eigen::Vector3d &middle() const
            {
                return corners_[0];
            }

            const Eigen::Vector3d &farthest(const Eigen::Vector3d &direction) const
            {
                const double a = direction.dot(corners_[0]), b = direction.dot(corners_[1]),
                             c = direction.dot(corners_[2]);
                return corners_[a >= b ? (a >= c ? 0 : 2) : (b >= c ? 1 : 2)];
            }

        private:
            const Triangle &corners_;
        };

        /** \e pose is from the frame of \e b to the frame of \e a */
        template <typename A, typename B>
        bool areSolidsWithin(const A &a, const B &b, const Pose &pose, double distance)
        {
            const double reach = distance + a.radius() + b.radius();
            ConvexSearch search;
            // Any point of the difference of both is one to begin with.
            Eigen::Vector3d nearest = pose * b.middle() - a.middle();
            for (unsigned int step = 0; step < MOST_STEPS; ++step)
            {
                // Two points of the solids are as near, or as near as rounding can tell.
                if (nearest.squaredNorm() <= reach * reach)
                    return true;
                const Eigen::Vector3d along = nearest.stableNormalized();
                const Eigen::Vector3d difference =
                    pose * b.farthest(-(pose.linear().transpose() * along)) - a.farthest(along);
                const double bound = along.dot(difference);
                if (bound > reach)
                    return false;
                if (!search.add(difference, bound, PRECISION))
                    break;
                nearest = search.getNearest();
            }
            return search.getNearest().squaredNorm() <= reach * reach;
        }
    }

    bool isWithin(const Shape &primitive, const Triangle &triangle, const Eigen::Vector3d &up, double distance)
    {
        Triangle corners = triangle;
        for (Eigen::Vector3d &corner : corners)
            corner -= up * up.dot(corner);
        return areSolidsWithin(Primitive(primitive), Corners(corners), Pose::Identity(), distance);
    }

    bool isWithin(const Triangle &a, const Triangle &b, double distance)
    {
        return areSolidsWithin(Corners(a), Corners(b), Pose::Identity(), distance);
    }

    bool areWithin(const Shape &a, const Shape &b, const Pose &pose, double distance)
    {
        if (b.getKind() == Shape::Kind::BALL)
            return a.isWithin(pose.translation(), b.getRadius() + distance);
        if (a.getKind() == Shape::Kind::BALL)
            return b.isWithin(pose.inverse().translation(), a.getRadius() + distance);
        const TriangleMesh *meshA = a.getMesh(), *meshB = b.getMesh();
        if (meshA && meshB)
            return meshA->getTree().findWithin(meshB->getTree(), pose, distance) != TriangleTree::NONE;
        if (meshA)
            return meshA->getTree().findWithin(b, pose.inverse(), distance) != TriangleTree::NONE;
        if (meshB)
            return meshB->getTree().findWithin(a, pose, distance) != TriangleTree::NONE;
        return areSolidsWithin(Primitive(a), Primitive(b), pose, distance);
    }

    bool areWithin(const Body &first, const Body &second, const Pose &pose, double distance)
    {
        for (const Body::Part &a : first.getParts())
        {
            const Pose toShape = a.pose.inverse() * pose;
            for (const Body::Part &b : second.getParts())
                if (areWithin(a.shape, b.shape, toShape * b.pose, distance))
                    return true;
        }
        return false;
    }
}
