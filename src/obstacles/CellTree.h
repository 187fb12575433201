#ifndef OMPL_CERTIFICATES_OBSTACLES_CELL_TREE_
#define OMPL_CERTIFICATES_OBSTACLES_CELL_TREE_

#include "ompl_certificates/geometry/Pose.h"
#include "ompl_certificates/obstacles/CellBox.h"

#include "geometry/BoxOverlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    /** \brief A tree over boxes of cells that do not overlap. All lengths are in cells.

        Each node holds the boxes of four children, which are tested in single precision. Uses about 45 bytes per
        box. */
    class CellTree
    {
    public:
        /** \brief Stands for no box */
        static constexpr std::uint32_t NONE = std::numeric_limits<std::uint32_t>::max();

        /** \brief A tree over \e boxes. Cost: n log n for n of them. */
        explicit CellTree(std::vector<CellBox> boxes);

        /** \brief The boxes, in the order of the tree */
        const std::vector<CellBox> &getBoxes() const
        {
            return boxes_;
        }

        /** \brief The box nearest to \e point if its squared distance is less than \e lowest, which is lowered to that;
            else NONE. Cost: logarithmic in the number of boxes, unless many are about equally far. */
        std::uint32_t findNearest(const Eigen::Vector3d &point, double &lowest) const;

        /** \brief Minus the distance of a point within a box to its surface. A flat box has its surface in its
            plane. */
        double depth(std::uint32_t box, const Eigen::Vector3d &point) const;

        /** \brief Call \e visit with the position of each box whose squared distance from \e point is less than
            \e lowest, and with that distance. The nearer ones mostly come first; \e visit may lower \e lowest. */
        template <typename Visit>
        void visitByDistance(const Eigen::Vector3d &point, const double &lowest, const Visit &visit) const;

        /** \brief Call \e visit with the position of each box that is nearer to a turned box than \e margin, and of
            some others, until it returns true
            \param bounds the turned box, in its own frame
            \param pose from that frame to the tree's */
        template <typename Visit>
        void visitNear(const Eigen::AlignedBox3d &bounds, const Pose &pose, double margin, const Visit &visit) const
        {
            if (nodes_.empty())
                return;
            const FloatBox box(bounds);
            const BoxTurn turn(pose.linear(), pose.translation());
            const auto slack = static_cast<float>(margin + ROUNDING * (extent_ + pose.translation().norm() +
                                                                       bounds.center().norm() + bounds.sizes().norm()));
            std::uint32_t stack[STACK_SIZE];
            std::size_t open = 0;
            stack[open++] = 0;
            while (open > 0)
            {
                const Node &node = nodes_[stack[--open]];
                bool overlap[4];
                overlaps(FloatNode(node), box, turn, slack, overlap);
                for (int k = 0; k < 4; ++k)
                    if (overlap[k] && node.child[k] != NONE)
                    {
                        if (!isLeaf(node.child[k]))
                            stack[open++] = node.child[k];
                        else if (visit(node.child[k] & ~LEAF))
                            return;
                    }
            }
        }

    private:
        /** Pays for the rounding in single precision, relative to the largest coordinate */
        static constexpr double ROUNDING = 1e-6;

        /** Pays for the rounding of squared distances, and of the lowest one, in single precision */
        static constexpr float SHRINK = 1.0F - 2e-6F;

        /** The squares of larger coordinates do not fit into single precision. */
        static constexpr double FARTHEST_POINT = 1e18;

        /** Three open children for each of at most 16 levels, and what is written above them */
        static constexpr std::size_t STACK_SIZE = 64;

        /** A child is a node, or a box with this flag. Boxes and nodes are never children of the same node, and the
            boxes stand in a row. */
        static constexpr std::uint32_t LEAF = 0x80000000U;

        /** \brief Four numbers for one instruction */
        using FourInts = std::int32_t __attribute__((vector_size(16)));
        using FourFloats = float __attribute__((vector_size(16)));

        /** \brief Four boxes, in one line of the cache. An absent one is inside out. */
        struct alignas(64) Node
        {
            /** For each axis and box its low end, in the lower 16 bits, and one less than its high end, in the upper */
            FourInts ends[3];
            std::uint32_t child[4];

            void set(std::size_t axis, int k, std::int32_t low, std::int32_t high)
            {
                ends[axis][k] = static_cast<std::int32_t>(static_cast<std::uint32_t>(high - 1) << 16U |
                                                          (static_cast<std::uint32_t>(low) & 0xFFFFU));
            }

            /** The four low ends along an axis; the shift up drops the upper half, the one down keeps the sign. */
            FourFloats getLow(int axis) const
            {
                return __builtin_convertvector((ends[axis] << 16) >> 16, FourFloats);
            }

            FourFloats getHigh(int axis) const
            {
                return __builtin_convertvector((ends[axis] >> 16) + 1, FourFloats);
            }
        };

        /** \brief The four boxes in single precision, which is exact */
        struct FloatNode
        {
            FourFloats low[3], high[3];

            explicit FloatNode(const Node &node)
              : low{node.getLow(0), node.getLow(1), node.getLow(2)}
              , high{node.getHigh(0), node.getHigh(1), node.getHigh(2)}
            {
            }
        };

        static bool isLeaf(std::uint32_t child)
        {
            return (child & LEAF) != 0;
        }

        /** \brief A child that is still to be visited: how near it may be, in the upper half, and its number. What is
            nearer is less. */
        using Open = std::uint64_t;

        static std::uint32_t boundOf(Open open)
        {
            return static_cast<std::uint32_t>(open >> 32U);
        }

        static std::uint32_t childOf(Open open)
        {
            return static_cast<std::uint32_t>(open);
        }

        /** \brief A squared distance as the bits of a float, which order as the numbers do: none is negative. */
        static std::uint32_t bitsOf(double squared)
        {
            const auto rounded =
                static_cast<float>(std::min(squared, static_cast<double>(std::numeric_limits<float>::max())));
            std::uint32_t bits;
            std::memcpy(&bits, &rounded, sizeof(bits));
            return bits;
        }

        /** \brief The children of a node, the nearest first; an absent one has the largest bound */
        static std::array<Open, 4> sortChildren(const Node &node, const FourFloats &bounds)
        {
            FourInts children, bits;
            std::memcpy(&children, node.child, sizeof(children));
            std::memcpy(&bits, &bounds, sizeof(bits));
            const FourInts absent = children == static_cast<std::int32_t>(NONE);
            bits |= absent;
            children &= ~absent;
            std::array<Open, 4> open;
            for (int k = 0; k < 4; ++k)
                open[static_cast<std::size_t>(k)] = static_cast<Open>(static_cast<std::uint32_t>(bits[k])) << 32U |
                                                    static_cast<std::uint32_t>(children[k]);
            for (const auto &[a, b] : {std::pair(0U, 1U), {2U, 3U}, {0U, 2U}, {1U, 3U}, {1U, 2U}})
            {
                // Exchanges them without a branch, if the second is less.
                const Open exchange = (open[a] ^ open[b]) & -static_cast<Open>(open[b] < open[a]);
                open[a] ^= exchange;
                open[b] ^= exchange;
            }
            return open;
        }

        /** \brief Makes the node of \e count boxes from \e first on, and those below it */
        std::uint32_t build(std::uint32_t first, std::uint32_t count);

        /** \brief The square of how far a coordinate is outside an interval */
        static double squaredOutside(double low, double high, double coordinate)
        {
            const double outside = std::max(std::max(low - coordinate, coordinate - high), 0.0);
            return outside * outside;
        }

        double squaredDistance(std::uint32_t box, const Eigen::Vector3d &point) const
        {
            double squared = 0.0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                squared += squaredOutside(boxes_[box].low[axis], boxes_[box].high[axis], point[Eigen::Index(axis)]);
            return squared;
        }

        std::vector<Node> nodes_;
        std::vector<CellBox> boxes_;

        /** \brief The largest coordinate of a box */
        double extent_{0.0};
    };

    template <typename Visit>
    void CellTree::visitByDistance(const Eigen::Vector3d &point, const double &lowest, const Visit &visit) const
    {
        if (nodes_.empty())
            return;
        if (!(point.cwiseAbs().maxCoeff() < FARTHEST_POINT))
        {
            for (std::uint32_t i = 0; i < boxes_.size(); ++i)
                if (const double squared = squaredDistance(i, point); squared < lowest)
                    visit(i, squared);
            return;
        }
        // In single precision the point is somewhere between these.
        const auto rounding = static_cast<float>(1.5e-7 * point.cwiseAbs().maxCoeff());
        const Eigen::Vector3f least = point.cast<float>().array() - rounding,
                              most = point.cast<float>().array() + rounding;
        // Which child is the nearest cannot be foreseen, and each branch that the processor guesses wrong costs as much
        // as a node. So children are sorted, and put on the stack, without branches.
        Open stack[STACK_SIZE];
        std::size_t open = 0;
        std::uint32_t current = 0, limit = bitsOf(lowest);
        for (;;)
        {
            const Node &node = nodes_[current];
            const FloatNode boxes(node);
            FourFloats bounds = {0.0F, 0.0F, 0.0F, 0.0F};
            for (int axis = 0; axis < 3; ++axis)
            {
                const FourFloats below = boxes.low[axis] - most[axis], above = least[axis] - boxes.high[axis],
                                 farther = below > above ? below : above, none = {0.0F, 0.0F, 0.0F, 0.0F},
                                 outside = farther > none ? farther : none;
                bounds += outside * outside;
            }
            const std::array<Open, 4> children = sortChildren(node, bounds * SHRINK);
            if (isLeaf(node.child[0]))
            {
                for (std::size_t i = 0; i < 4 && boundOf(children[i]) < limit; ++i)
                {
                    const auto k = static_cast<int>(childOf(children[i]) - node.child[0]);
                    double squared = 0.0;
                    for (int axis = 0; axis < 3; ++axis)
                        squared += squaredOutside(boxes.low[axis][k], boxes.high[axis][k], point[axis]);
                    if (squared < lowest)
                        visit(childOf(children[i]) & ~LEAF, squared);
                    limit = bitsOf(lowest);
                }
            }
            else
            {
                for (std::size_t i = 3; i > 0; --i)
                {
                    __builtin_prefetch(&nodes_[childOf(children[i])]);
                    stack[open] = children[i];
                    open += boundOf(children[i]) < limit ? 1 : 0;
                }
                if (boundOf(children[0]) < limit)
                {
                    current = childOf(children[0]);
                    continue;
                }
            }
            do
            {
                if (open == 0)
                    return;
                --open;
            } while (boundOf(stack[open]) >= limit);
            current = childOf(stack[open]);
        }
    }
}

#endif
