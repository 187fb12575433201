#include "TriangleTree.h"

#include "TriangleContact.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** Pays for the rounding of boxes in single precision, relative to the largest coordinate */
        constexpr double ROUNDING = 1e-6;

        /** After so many triangles that may just touch, the exact check decides. Where meshes lie upon each other,
            nearly all triangles do, and the first one ends the exact check. */
        constexpr unsigned int MOST_UNKNOWN = 32;

        /** After so many triangles that are near each other, it is no longer worth while to prove how far they are. */
        constexpr unsigned int MOST_NEAR = 8;

        struct Box
        {
            Eigen::Vector3f center;
            Eigen::Vector3f half;
        };

        /** The transform of boxes from one frame to another */
        struct Turn
        {
            Eigen::Matrix3f rotation;
            Eigen::Matrix3f absolute;
            Eigen::Vector3f shift;

            Turn(const Eigen::Matrix3d &r, const Eigen::Vector3d &t)
              : rotation(r.cast<float>()), absolute(rotation.cwiseAbs()), shift(t.cast<float>())
            {
            }
        };

        /** Which of the four boxes of \e node touch \e box, to within \e slack: no axis of either separates them. \e
            turn takes \e box to the node's frame. */
        template <typename Node>
        void overlaps(const Node &node, const Box &box, const Turn &turn, float slack, bool *overlap)
        {
            const Eigen::Vector3f center = turn.rotation * box.center + turn.shift;
            const Eigen::Vector3f half = turn.absolute * box.half + Eigen::Vector3f::Constant(slack);
            int outside[4] = {0, 0, 0, 0};
            float middles[3][4], halves[3][4];
            for (int axis = 0; axis < 3; ++axis)
            {
                const float low = center[axis] - half[axis], high = center[axis] + half[axis];
                for (int k = 0; k < 4; ++k)
                {
                    outside[k] |=
                        static_cast<int>(node.low[axis][k] > high) | static_cast<int>(node.high[axis][k] < low);
                    middles[axis][k] = 0.5F * (node.low[axis][k] + node.high[axis][k]) - center[axis];
                    halves[axis][k] = 0.5F * (node.high[axis][k] - node.low[axis][k]);
                }
            }
            for (int axis = 0; axis < 3; ++axis)
            {
                const float x = turn.rotation(0, axis), y = turn.rotation(1, axis), z = turn.rotation(2, axis);
                const float ax = turn.absolute(0, axis), ay = turn.absolute(1, axis), az = turn.absolute(2, axis);
                const float extent = box.half[axis] + slack;
                for (int k = 0; k < 4; ++k)
                {
                    const float gap = std::abs(x * middles[0][k] + y * middles[1][k] + z * middles[2][k]);
                    const float both = extent + ax * halves[0][k] + ay * halves[1][k] + az * halves[2][k];
                    outside[k] |= static_cast<int>(gap > both);
                }
            }
            for (int k = 0; k < 4; ++k)
                overlap[k] = outside[k] == 0;
        }

        template <typename Node>
        Box boxOf(const Node &node, int k)
        {
            const Eigen::Vector3f low(node.low[0][k], node.low[1][k], node.low[2][k]);
            const Eigen::Vector3f high(node.high[0][k], node.high[1][k], node.high[2][k]);
            return {0.5F * (low + high), 0.5F * (high - low)};
        }
    }

    Touching TriangleTree::touches(const Facet &triangle, double margin) const
    {
        if (nodes_.empty())
            return Touching::NO;
        Eigen::AlignedBox3d box;
        for (const auto &corner : triangle.corners)
            box.extend(corner);
        const double slack = margin + ROUNDING * (extent_ + (box.center() - origin_).norm());
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

    template <typename Visit>
    void TriangleTree::visitNear(const TriangleTree &other, const Pose &pose, double distance, const Visit &visit) const
    {
        if (nodes_.empty() || other.nodes_.empty())
            return;
        const Eigen::Vector3d shift = pose * other.origin_ - origin_;
        const Turn toHere(pose.linear(), shift),
            toThere(pose.linear().transpose(), -(pose.linear().transpose() * shift));
        const auto slack = static_cast<float>(distance + ROUNDING * (extent_ + other.extent_ + shift.norm()));
        struct Open
        {
            std::uint32_t here, there;
            Box boxHere, boxThere;
        };
        Open stack[2 * STACK_SIZE];
        std::size_t open = 0;
        stack[open++] = {0, 0, {Eigen::Vector3f::Zero(), half_}, {Eigen::Vector3f::Zero(), other.half_}};
        while (open > 0)
        {
            const Open pair = stack[--open];
            if (isLeaf(pair.here) && isLeaf(pair.there))
            {
                for (std::uint32_t j = firstOf(pair.there), lastJ = j + countOf(pair.there); j < lastJ; ++j)
                {
                    const Facet triangle(other.triangles_[j], pose);
                    for (std::uint32_t i = firstOf(pair.here), lastI = i + countOf(pair.here); i < lastI; ++i)
                        if (!visit(i, triangle))
                            return;
                }
                continue;
            }
            bool overlap[4];
            if (isLeaf(pair.there) || (!isLeaf(pair.here) && pair.boxHere.half.sum() >= pair.boxThere.half.sum()))
            {
                const Node &node = nodes_[pair.here];
                overlaps(node, pair.boxThere, toHere, slack, overlap);
                for (int k = 0; k < 4; ++k)
                    if (overlap[k])
                        stack[open++] = {node.child[k], pair.there, boxOf(node, k), pair.boxThere};
            }
            else
            {
                const Node &node = other.nodes_[pair.there];
                overlaps(node, pair.boxHere, toThere, slack, overlap);
                for (int k = 0; k < 4; ++k)
                    if (overlap[k])
                        stack[open++] = {pair.here, node.child[k], pair.boxHere, boxOf(node, k)};
            }
        }
    }

    Touching TriangleTree::touches(const TriangleTree &other, const Pose &pose, double margin, std::uint32_t *hit) const
    {
        unsigned int unknown = 0;
        bool touch = false;
        visitNear(other, pose, margin,
                  [&](std::uint32_t i, const Facet &triangle)
                  {
                      const Touching answer = crossing(triangles_[i], triangle, margin);
                      touch = answer == Touching::YES;
                      if (touch && hit)
                          *hit = i;
                      unknown += answer == Touching::UNKNOWN ? 1 : 0;
                      return !touch && unknown < MOST_UNKNOWN;
                  });
        return touch ? Touching::YES : unknown > 0 ? Touching::UNKNOWN : Touching::NO;
    }

    bool TriangleTree::isFartherThan(double distance, const TriangleTree &other, const Pose &pose) const
    {
        bool farther = true;
        unsigned int left = MOST_NEAR;
        visitNear(other, pose, distance,
                  [&](std::uint32_t i, const Facet &triangle)
                  {
                      farther = left-- > 0 && areFartherApart(triangles_[i], triangle, distance);
                      return farther;
                  });
        return farther;
    }
}
