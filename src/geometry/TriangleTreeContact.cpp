#include "TriangleTree.h"

#include "BoxOverlap.h"
#include "PrimitiveContact.h"
#include "TriangleContact.h"
#include "WithinDistance.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** Pays for the rounding of boxes in single precision, relative to the largest coordinate */
        constexpr double BOX_ROUNDING = 1e-6;

        /** The same for FacetRows: triangles in single precision, turned there */
        constexpr double ROW_ROUNDING = 8e-6;

        /** Farther away, or not a number, single precision says nothing. */
        constexpr double FARTHEST_BOX = 1e30;

        /** After so many triangles that may just touch, the exact check decides. Where meshes lie upon each other,
            nearly all triangles do, and the first one ends the exact check. */
        constexpr unsigned int MOST_UNKNOWN = 32;

        /** The lowest \e count bits */
        constexpr unsigned int firstBits(std::uint32_t count)
        {
            return (1U << count) - 1;
        }

        /** The answers about one pair of triangles after the other, until they settle the matter */
        class Answers
        {
        public:
            /** Notes an answer about the triangle of the tree at \e position
                \return whether no more are needed */
            bool note(Touching answer, std::uint32_t position, std::uint32_t *hit)
            {
                if (answer == Touching::NO)
                    return false;
                all_ = answer;
                if (answer == Touching::YES && hit)
                    *hit = position;
                return answer == Touching::YES || ++unknown_ == MOST_UNKNOWN;
            }

            /** What they say together */
            Touching get() const
            {
                return all_;
            }

        private:
            Touching all_{Touching::NO};
            unsigned int unknown_{0};
        };

        Eigen::AlignedBox3d boxOf(const TriangleTree::Facet &triangle)
        {
            const auto &[a, b, c] = triangle.corners;
            return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
        }
    }

    Touching TriangleTree::touches(const Facet &triangle, double margin) const
    {
        if (nodes_.empty())
            return Touching::NO;
        const Eigen::AlignedBox3d box = boxOf(triangle);
        const double distance = (box.center() - origin_).norm();
        if (!(distance < FARTHEST_BOX))
            return Touching::UNKNOWN;
        const double slack = margin + BOX_ROUNDING * (extent_ + distance);
        const Eigen::Vector3f low = (box.min() - origin_).cast<float>().array() - static_cast<float>(slack);
        const Eigen::Vector3f high = (box.max() - origin_).cast<float>().array() + static_cast<float>(slack);
        bool unknown = false;
        std::uint32_t stack[STACK_SIZE];
        std::size_t open = 0;
        stack[open++] = 0;
        while (open > 0)
        {
            const std::uint32_t current = stack[--open];
            if (isLeaf(current))
            {
                const std::uint32_t first = firstOf(current), end = first + countOf(current);
                for (std::uint32_t i = first; i < end; ++i)
                {
                    const Touching answer = crossing(triangles_[i], triangle, margin);
                    if (answer == Touching::YES)
                        return answer;
                    unknown = unknown || answer == Touching::UNKNOWN;
                }
                continue;
            }
            const Node &node = nodes_[current];
            int outside[4] = {0, 0, 0, 0};
            for (int axis = 0; axis < 3; ++axis)
                for (int k = 0; k < 4; ++k)
                    outside[k] |= static_cast<int>(node.low[axis][k] > high[axis]) |
                                  static_cast<int>(node.high[axis][k] < low[axis]);
            for (int k = 0; k < 4; ++k)
                if (outside[k] == 0)
                    stack[open++] = node.child[k];
        }
        return unknown ? Touching::UNKNOWN : Touching::NO;
    }

    Touching TriangleTree::touches(const TriangleTree &other, const Pose &pose, double margin, std::uint32_t *hit) const
    {
        if (nodes_.empty() || other.nodes_.empty())
            return Touching::NO;
        if (!((pose * other.origin_ - origin_).norm() < FARTHEST_BOX))
            return Touching::UNKNOWN;
        Answers answers;
        visitNear(other, pose, margin,
                  [&](std::uint32_t position, const Facet &triangle)
                  { return answers.note(crossing(triangles_[position], triangle, margin), position, hit); });
        return answers.get();
    }

    std::uint32_t TriangleTree::findWithin(const TriangleTree &other, const Pose &pose, double distance) const
    {
        std::uint32_t found = NONE;
        if (nodes_.empty() || other.nodes_.empty() || !((pose * other.origin_ - origin_).norm() < FARTHEST_BOX))
            return found;
        visitNear(other, pose, distance,
                  [&](std::uint32_t position, const Facet &triangle)
                  {
                      if (ompl_certificates::isWithin(triangles_[position].corners, triangle.corners, distance))
                          found = position;
                      return found != NONE;
                  });
        return found;
    }

    template <typename Visit>
    void TriangleTree::visitNear(const TriangleTree &other, const Pose &pose, double margin, const Visit &visit) const
    {
        const Eigen::Vector3d shift = pose * other.origin_ - origin_;
        const BoxTurn toHere(pose.linear(), shift),
            toThere(pose.linear().transpose(), -(pose.linear().transpose() * shift));
        const auto slack = static_cast<float>(margin + BOX_ROUNDING * (extent_ + other.extent_ + shift.norm()));
        const float rowSlack = slack + static_cast<float>(ROW_ROUNDING * (extent_ + other.extent_ + shift.norm()));
        struct Open
        {
            std::uint32_t here, there;
            FloatBox boxHere, boxThere;
        };
        Open stack[2 * STACK_SIZE];
        std::size_t open = 0;
        const auto whole = [](const Eigen::Vector3f &half) {
            return FloatBox(FourFloats{}, FourFloats{half.x(), half.y(), half.z()});
        };
        stack[open++] = {0, 0, whole(half_), whole(other.half_)};
        while (open > 0)
        {
            const Open pair = stack[--open];
            if (isLeaf(pair.here) && isLeaf(pair.there))
            {
                const FourFacets four = rows_.at(firstOf(pair.here));
                const FourFacets others = turned(other.rows_.at(firstOf(pair.there)), toHere);
                // Half of the other leaf's triangles, or more, lie beside this leaf's box.
                const unsigned int near = nearBox(others, pair.boxHere, rowSlack) & firstBits(countOf(pair.there));
                for (std::uint32_t j = 0; near >> j != 0; ++j)
                {
                    if ((near >> j & 1U) == 0)
                        continue;
                    const unsigned int left =
                        mayCross(four, others, static_cast<int>(j), rowSlack) & firstBits(countOf(pair.here));
                    if (left == 0)
                        continue;
                    const Facet triangle(other.triangles_[firstOf(pair.there) + j], pose);
                    for (std::uint32_t i = 0; left >> i != 0; ++i)
                        if ((left >> i & 1U) != 0 && visit(firstOf(pair.here) + i, triangle))
                            return;
                }
                continue;
            }
            // Long triangles have large boxes, which meet nearly all of the other tree's.
            if (isLeaf(pair.there) && pair.boxThere.size() > pair.boxHere.size() &&
                (nearBoxClosely(turned(other.rows_.at(firstOf(pair.there)), toHere), pair.boxHere, rowSlack) &
                 firstBits(countOf(pair.there))) == 0)
                continue;
            if (isLeaf(pair.here) && pair.boxHere.size() > pair.boxThere.size() &&
                (nearBoxClosely(turned(rows_.at(firstOf(pair.here)), toThere), pair.boxThere, rowSlack) &
                 firstBits(countOf(pair.here))) == 0)
                continue;
            int numbers[4];
            if (isLeaf(pair.there) || (!isLeaf(pair.here) && pair.boxHere.size() >= pair.boxThere.size()))
            {
                const Node &node = nodes_[pair.here];
                const int count = overlaps(node, pair.boxThere, toHere, slack, numbers);
                for (int i = 0; i < count; ++i)
                    stack[open++] = {node.child[numbers[i]], pair.there, boxOf(node, numbers[i]), pair.boxThere};
            }
            else
            {
                const Node &node = other.nodes_[pair.there];
                const int count = overlaps(node, pair.boxHere, toThere, slack, numbers);
                for (int i = 0; i < count; ++i)
                    stack[open++] = {pair.here, node.child[numbers[i]], pair.boxHere, boxOf(node, numbers[i])};
            }
        }
    }

    Touching TriangleTree::touches(const Shape &primitive, const Pose &pose, double margin, std::uint32_t *hit) const
    {
        if (nodes_.empty())
            return Touching::NO;
        if (!((pose * origin_).norm() < FARTHEST_BOX))
            return Touching::UNKNOWN;
        Answers answers;
        visitNear(primitive.getBounds(), pose, margin,
                  [&](std::uint32_t position)
                  {
                      const auto &[a, b, c] = triangles_[position].corners;
                      return answers.note(touching(primitive, {pose * a, pose * b, pose * c}, margin), position, hit);
                  });
        return answers.get();
    }

    std::uint32_t TriangleTree::findWithin(const Shape &primitive, const Pose &pose, double distance) const
    {
        std::uint32_t found = NONE;
        const Eigen::Vector3d center = pose * origin_;
        if (nodes_.empty() || !(center.norm() < FARTHEST_BOX))
            return found;
        Eigen::AlignedBox3d bounds = primitive.getBounds();
        Eigen::Vector3d up = Eigen::Vector3d::Zero();
        if (primitive.getDimension() == 2)
        {
            // An upright prism, so high that it passes all triangles
            up = pose.linear().col(2);
            const Eigen::Vector3d height = (center.norm() + 2.0 * extent_) * up.cwiseAbs();
            bounds = {bounds.min() - height, bounds.max() + height};
        }
        visitNear(bounds, pose, distance,
                  [&](std::uint32_t position)
                  {
                      const auto &[a, b, c] = triangles_[position].corners;
                      if (ompl_certificates::isWithin(primitive, {pose * a, pose * b, pose * c}, up, distance))
                          found = position;
                      return found != NONE;
                  });
        return found;
    }

    bool TriangleTree::isWithin(const Corners &corners, double distance) const
    {
        Eigen::AlignedBox3d bounds;
        for (const Eigen::Vector3d &corner : corners)
            bounds.extend(corner);
        bool found = false;
        if (!nodes_.empty() && (bounds.center() - origin_).norm() < FARTHEST_BOX)
            visitNear(bounds, Pose::Identity(), distance,
                      [&](std::uint32_t position)
                      { return found = ompl_certificates::isWithin(triangles_[position].corners, corners, distance); });
        return found;
    }

    template <typename Visit>
    void TriangleTree::visitNear(const Eigen::AlignedBox3d &bounds, const Pose &pose, double margin,
                                 const Visit &visit) const
    {
        const FloatBox box(bounds);
        const Eigen::Matrix3d toHere = pose.linear().transpose();
        const Eigen::Vector3d shift = -(toHere * (pose * origin_));
        const BoxTurn turn(toHere, shift);
        const auto slack = static_cast<float>(
            margin + BOX_ROUNDING * (extent_ + bounds.center().norm() + bounds.sizes().norm() + shift.norm()));
        std::uint32_t stack[STACK_SIZE];
        std::size_t open = 0;
        stack[open++] = 0;
        while (open > 0)
        {
            const std::uint32_t current = stack[--open];
            if (isLeaf(current))
            {
                for (std::uint32_t i = firstOf(current), last = i + countOf(current); i < last; ++i)
                    if (visit(i))
                        return;
                continue;
            }
            const Node &node = nodes_[current];
            int numbers[4];
            const int count = overlaps(node, box, turn, slack, numbers);
            for (int i = 0; i < count; ++i)
                stack[open++] = node.child[numbers[i]];
        }
    }
}
