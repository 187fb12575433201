#include "PointTree.h"

#include "ompl_certificates/geometry/Ball.h"

#include "geometry/FourNumbers.h"
#include "geometry/Infinity.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

namespace ompl_certificates
{
    namespace
    {
        const Eigen::Vector3d &pointOf(const Eigen::Vector3d &point)
        {
            return point;
        }

        const Eigen::Vector3d &pointOf(const Ball &ball)
        {
            return ball.center;
        }

        /** Whether a point comes before another along an axis, where only equal points tie. Slow where many tie. */
        bool isBefore(const Eigen::Vector3d &a, const Eigen::Vector3d &b, Eigen::Index axis)
        {
            if (a[axis] != b[axis])
                return a[axis] < b[axis];
            const Eigen::Index second = (axis + 1) % 3, third = (axis + 2) % 3;
            return a[second] != b[second] ? a[second] < b[second] : a[third] < b[third];
        }

        /** Whether two of a few points are equal, as they mostly are where half of all are */
        template <typename Item>
        bool areSomeEqual(const Item *begin, const Item *end)
        {
            constexpr std::ptrdiff_t FEW = 8;
            const std::ptrdiff_t step = (end - begin) / FEW;
            for (std::ptrdiff_t i = 1; i < FEW; ++i)
                for (std::ptrdiff_t j = 0; j < i; ++j)
                    if (pointOf(begin[i * step]) == pointOf(begin[j * step]))
                        return true;
            return false;
        }

        /** Orders points so that those of a leaf, and those of each half of the leaves, are close together. Many equal
            points share few leaves with others: once they are the first or the last along each axis, one half has none
            of them, or nothing else. */
        template <typename Item>
        void order(Item *begin, Item *end, std::ptrdiff_t leafSize)
        {
            const std::ptrdiff_t leaves = (end - begin + leafSize - 1) / leafSize;
            if (leaves < 2)
                return;
            Eigen::AlignedBox3d box;
            for (const Item *item = begin; item != end; ++item)
                box.extend(pointOf(*item));
            Eigen::Index axis;
            box.sizes().maxCoeff(&axis);
            Item *const middle = begin + leaves / 2 * leafSize;
            if (areSomeEqual(begin, end))
                std::nth_element(begin, middle, end,
                                 [axis](const Item &a, const Item &b)
                                 { return isBefore(pointOf(a), pointOf(b), axis); });
            else
                std::nth_element(begin, middle, end,
                                 [axis](const Item &a, const Item &b) { return pointOf(a)[axis] < pointOf(b)[axis]; });
            order(begin, middle, leafSize);
            order(middle, end, leafSize);
        }

        /** Sorts four numbers without a branch */
        void sort(std::uint64_t (&keys)[4])
        {
            const auto inOrder = [&keys](std::size_t i, std::size_t j)
            {
                const std::uint64_t low = std::min(keys[i], keys[j]), high = std::max(keys[i], keys[j]);
                keys[i] = low;
                keys[j] = high;
            };
            inOrder(0, 1);
            inOrder(2, 3);
            inOrder(0, 2);
            inOrder(1, 3);
            inOrder(1, 2);
        }

        std::uint32_t bitsOf(float number)
        {
            std::uint32_t bits;
            std::memcpy(&bits, &number, sizeof(bits));
            return bits;
        }

        float ofBits(std::uint32_t bits)
        {
            float number;
            std::memcpy(&number, &bits, sizeof(number));
            return number;
        }

        /** The median of a coordinate, of a thousand points at most */
        double medianOf(const std::vector<Eigen::Vector3d> &points, Eigen::Index axis)
        {
            constexpr std::size_t ENOUGH = 1000;
            std::vector<double> coordinates;
            for (std::size_t i = 0; i < points.size(); i += points.size() / ENOUGH + 1)
                coordinates.push_back(points[i][axis]);
            const auto middle = coordinates.begin() + static_cast<std::ptrdiff_t>(coordinates.size() / 2);
            std::nth_element(coordinates.begin(), middle, coordinates.end());
            return *middle;
        }

        float roundedUp(double value)
        {
            return std::nextafter(static_cast<float>(value), FLOAT_INF);
        }
    }

    PointTree::PointTree(std::vector<Eigen::Vector3d> points, std::vector<double> radii)
      : points_(std::move(points)), radii_(std::move(radii))
    {
        if (points_.empty())
            return;
        if (radii_.size() == 1)
            order(points_.data(), points_.data() + points_.size(), LEAF_SIZE);
        else
        {
            std::vector<Ball> balls(points_.size());
            for (std::size_t i = 0; i < balls.size(); ++i)
                balls[i] = {points_[i], radii_[i]};
            order(balls.data(), balls.data() + balls.size(), LEAF_SIZE);
            for (std::size_t i = 0; i < balls.size(); ++i)
            {
                points_[i] = balls[i].center;
                radii_[i] = balls[i].radius;
            }
        }
        for (const Eigen::Vector3d &point : points_)
            box_.extend(point);
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            origin_[axis] = medianOf(points_, axis);
        const auto leaves = static_cast<std::uint32_t>((points_.size() + LEAF_SIZE - 1) / LEAF_SIZE);
        nodes_.reserve(leaves / 3 + 1);
        std::uint32_t root;
        largestRadius_ = addNode(0, leaves, root).radius;
        nodes_.shrink_to_fit();
    }

    std::pair<std::uint32_t, std::uint32_t> PointTree::findSpare(std::uint32_t position) const
    {
        const std::uint32_t leaf = leafOf(position);
        const auto spare = std::lower_bound(spare_.begin(), spare_.end(), std::pair(leaf + 1, 0U));
        if (spare == spare_.end() || spare->first != leaf + 1)
            return {0, 0};
        return {spare->first * LEAF_SIZE, endOf(spare->second - 1)};
    }

    PointTree::Bounds PointTree::leafBounds(std::uint32_t leaf) const
    {
        Bounds bounds;
        for (std::uint32_t i = leaf * LEAF_SIZE; i < endOf(leaf); ++i)
        {
            bounds.box.extend((points_[i] - origin_).cast<float>());
            bounds.radius = std::max(bounds.radius, roundedUp(getRadius(i)));
        }
        for (Eigen::Index axis = 0; axis < 3; ++axis)
        {
            bounds.box.min()[axis] = std::nextafter(bounds.box.min()[axis], -FLOAT_INF);
            bounds.box.max()[axis] = std::nextafter(bounds.box.max()[axis], FLOAT_INF);
        }
        return bounds;
    }

    PointTree::Bounds PointTree::addChild(std::uint32_t first, std::uint32_t last, std::uint32_t &child)
    {
        const auto begin = points_.begin() + first * std::ptrdiff_t(LEAF_SIZE), end = points_.begin() + endOf(last - 1);
        const auto isOther = [&](const Eigen::Vector3d &point) { return point != *begin; };
        if (last - first > 1 && std::any_of(begin, end, isOther))
            return addNode(first, last, child);
        child = LEAF | first;
        if (last - first > 1)
        {
            spare_.emplace_back(first + 1, last);
            if (radii_.size() > 1)
                std::sort(radii_.begin() + (begin - points_.begin()), radii_.begin() + (end - points_.begin()),
                          std::greater<>());
        }
        return leafBounds(first);
    }

    PointTree::Bounds PointTree::addNode(std::uint32_t first, std::uint32_t last, std::uint32_t &index)
    {
        index = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        // The same halves, twice, as in order()
        const std::uint32_t middle = first + (last - first) / 2;
        const std::uint32_t ends[5] = {first, first + (middle - first) / 2, middle, middle + (last - middle) / 2, last};
        Bounds all;
        for (std::size_t k = 0; k < 4; ++k)
        {
            Bounds bounds;
            // An absent child is the first leaf: a walk ends even where a huge distance makes all boxes overlap.
            std::uint32_t child = LEAF;
            bounds.box.min().setConstant(FLOAT_INF);
            bounds.box.max().setConstant(-FLOAT_INF);
            if (ends[k] < ends[k + 1])
            {
                bounds = addChild(ends[k], ends[k + 1], child);
                all.box.extend(bounds.box);
                all.radius = std::max(all.radius, bounds.radius);
            }
            Node &node = nodes_[index];
            const auto lane = static_cast<Eigen::Index>(k);
            const float largest = bounds.box.min().cwiseAbs().cwiseMax(bounds.box.max().cwiseAbs()).maxCoeff();
            const float margin = largest < FLOAT_INF ? static_cast<float>(ROUNDING) * largest : 0.0F;
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                node.low[axis][lane] = bounds.box.min()[static_cast<Eigen::Index>(axis)] - margin;
                node.high[axis][lane] = bounds.box.max()[static_cast<Eigen::Index>(axis)] + margin;
            }
            node.radius[lane] = bounds.radius;
            node.child[k] = child;
        }
        return all;
    }

    double PointTree::leafDistance(std::uint32_t leaf, const Eigen::Vector3d &point, Mask mask) const
    {
        const std::uint32_t first = leaf * LEAF_SIZE, count = endOf(leaf) - first;
        double least = std::numeric_limits<double>::infinity();
        if (radii_.size() != 1 || (mask && mask[leaf] != EVERY_POINT))
        {
            for (std::uint32_t i = first; i < first + count; ++i)
                if (counts(mask, i))
                    least = std::min(least, (points_[i] - point).norm() - getRadius(i));
            return least;
        }
        const Eigen::Vector3d *const points = &points_[first];
        if (count == LEAF_SIZE)
            for (std::uint32_t i = 0; i < LEAF_SIZE; ++i)
                least = std::min(least, (points[i] - point).squaredNorm());
        else
            for (std::uint32_t i = 0; i < count; ++i)
                least = std::min(least, (points[i] - point).squaredNorm());
        return std::sqrt(least) - radii_.front();
    }

    double PointTree::signedDistance(const Eigen::Vector3d &point, std::uint32_t *nearest, double most, Mask mask) const
    {
        double least = most;
        const std::uint32_t leaf = findNearestLeaf(point, least, mask);
        if (nearest)
        {
            *nearest = NONE;
            if (leaf != NONE)
                for (std::uint32_t i = leaf * LEAF_SIZE; i < endOf(leaf) && *nearest == NONE; ++i)
                    if (counts(mask, i) && (points_[i] - point).norm() - getRadius(i) <= least)
                        *nearest = i;
        }
        return least;
    }

    void PointTree::prefetch(std::uint32_t child) const
    {
        if ((child & LEAF) != 0)
            __builtin_prefetch(&points_[std::size_t(child & ~LEAF) * LEAF_SIZE]);
        else
            __builtin_prefetch(&nodes_[child]);
    }

    std::uint32_t PointTree::findNearestLeaf(const Eigen::Vector3d &point, double &least, Mask mask) const
    {
        std::uint32_t found = NONE;
        const auto tryLeaf = [&](std::uint32_t leaf)
        {
            const double distance = leafDistance(leaf, point, mask);
            if (distance < least)
            {
                least = distance;
                found = leaf;
            }
        };
        const Eigen::Vector3d shifted = point - origin_;
        const double largest = shifted.cwiseAbs().maxCoeff();
        if (nodes_.empty() || !(largest < FARTHEST))
        {
            for (std::size_t first = 0; first < points_.size(); first += LEAF_SIZE)
                tryLeaf(static_cast<std::uint32_t>(first / LEAF_SIZE));
            return found;
        }
        const auto slack = static_cast<float>(ROUNDING * largest);
        const Eigen::Vector3f p = shifted.cast<float>();
        const float low[3] = {p.x() + slack, p.y() + slack, p.z() + slack};
        const float high[3] = {p.x() - slack, p.y() - slack, p.z() - slack};
        // What is open: the squared distance of a box, whose bits are ordered as it is, and the child
        std::uint64_t stack[STACK_SIZE];
        std::size_t open = 0;
        std::uint32_t current = 0;
        float most = roundedUp(least);
        for (;;)
        {
            if ((current & LEAF) != 0)
            {
                tryLeaf(current & ~LEAF);
                most = roundedUp(least);
            }
            else
            {
                const Node &node = nodes_[current];
                Eigen::Array4f bounds = Eigen::Array4f::Zero();
                for (std::size_t axis = 0; axis < 3; ++axis)
                    bounds += (node.low[axis] - low[axis]).max(high[axis] - node.high[axis]).max(0.0F).square();
                bounds *= SHRINK;
                // Above zero if a child may be nearer; of an absent one it never is
                const Eigen::Array4f nearer = (node.radius + most).max(0.0F).square() - bounds;
                std::uint64_t keys[4];
                std::size_t count = 0;
                for (std::size_t k = 0; k < 4; ++k)
                {
                    const auto lane = static_cast<Eigen::Index>(k);
                    const bool isOpen = nearer[lane] > 0.0F;
                    keys[k] = isOpen ? std::uint64_t(bitsOf(bounds[lane])) << 32 | node.child[k] : ~std::uint64_t(0);
                    count += isOpen ? 1 : 0;
                }
                sort(keys);
                // The nearest child goes on top of the stack.
                for (std::size_t k = count; k > 0; --k)
                {
                    stack[open++] = keys[k - 1];
                    prefetch(static_cast<std::uint32_t>(keys[k - 1]));
                }
            }
            const float reach = std::max(most + largestRadius_, 0.0F);
            float bound;
            do
            {
                if (open == 0)
                    return found;
                const std::uint64_t key = stack[--open];
                bound = ofBits(static_cast<std::uint32_t>(key >> 32));
                current = static_cast<std::uint32_t>(key);
            } while (!(bound < reach * reach));
        }
    }
}
