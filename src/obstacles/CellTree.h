#ifndef OMPL_CERTIFICATES_OBSTACLES_CELL_TREE_
#define OMPL_CERTIFICATES_OBSTACLES_CELL_TREE_

#include "ompl_certificates/geometry/Pose.h"
#include "ompl_certificates/obstacles/CellBox.h"

#include "geometry/BoxOverlap.h"
#include "geometry/FourNumbers.h"

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

        /** \brief Call \e visit with each box that is nearer to a turned box than \e margin, and with some others,
            until it returns true: with its position and the box
            \param bounds the turned box, in its own frame
            \param pose from that frame to the tree's */
        template <typename Visit>
        void visitNear(const Eigen::AlignedBox3d &bounds, const Pose &pose, double margin, const Visit &visit) const;

        /** \brief A lower bound of the distance between a turned box and the boxes; \e wanted if it is not less. The
            search ends as soon as the bound is not larger than \e needed. */
        double gap(const Eigen::AlignedBox3d &bounds, const Pose &pose, double needed, double wanted) const;

    private:
        /** Pays for the rounding in single precision, relative to the largest coordinate */
        static constexpr double ROUNDING = 1e-6;

        /** Three open children for each of at most 16 levels, and what is written above them */
        static constexpr std::size_t STACK_SIZE = 64;

        /** A child is a node, or a box with this flag. Boxes and nodes are never children of the same node, and the
            boxes stand in a row. */
        static constexpr std::uint32_t LEAF = 0x80000000U;

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

            CellBox getBox(std::uint32_t k) const
            {
                CellBox box;
                for (std::size_t axis = 0; axis < 3; ++axis)
                {
                    const std::int32_t both = ends[axis][k];
                    box.low[axis] = static_cast<std::int16_t>(both & 0xFFFF);
                    box.high[axis] = (both >> 16) + 1;
                }
                return box;
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

        /** \brief A turned box in single precision, and what pays for that */
        struct TurnedBox
        {
            FloatBox box;
            BoxTurn turn;
            float rounding;

            TurnedBox(const Eigen::AlignedBox3d &bounds, const Pose &pose, double extent)
              : box(bounds)
              , turn(pose.linear(), pose.translation())
              , rounding(static_cast<float>(
                    ROUNDING * (extent + pose.translation().norm() + bounds.center().norm() + bounds.sizes().norm())))
            {
            }
        };

        static bool isLeaf(std::uint32_t child)
        {
            return (child & LEAF) != 0;
        }

        /** \brief A child that is still to be visited: a bound, which says how soon, in the upper half; and its
            number */
        using Open = std::uint64_t;

        static std::uint32_t boundOf(Open open)
        {
            return static_cast<std::uint32_t>(open >> 32U);
        }

        static std::uint32_t childOf(Open open)
        {
            return static_cast<std::uint32_t>(open);
        }

        /** \brief A number as a bound: numbers that are not negative have the order of their bits */
        static std::uint32_t toBound(double number)
        {
            const auto rounded =
                static_cast<float>(std::min(number, static_cast<double>(std::numeric_limits<float>::max())));
            std::uint32_t bits;
            std::memcpy(&bits, &rounded, sizeof(bits));
            return bits;
        }

        /** \brief Four numbers as bounds; 0 in place of negative ones */
        static FourInts toBounds(const FourFloats &numbers)
        {
            const FourFloats none{}, positive = numbers > none ? numbers : none;
            FourInts bits;
            std::memcpy(&bits, &positive, sizeof(bits));
            return bits;
        }

        /** \brief The bound of a child that is not to be visited */
        static constexpr std::uint32_t NEVER = std::numeric_limits<std::uint32_t>::max();

        /** \brief The children of a node, the one with the least bound first */
        static std::array<Open, 4> sortChildren(const Node &node, const FourInts &bounds);

        /** \brief Call \e visit with nodes of boxes and the number of a box in them, until it returns true. The least
            bounds mostly come first.
            \param bounds a function from a node to the bounds of its children
            \param limit only what has a lower bound is visited; \e visit may lower it */
        template <typename Bounds, typename Visit>
        void walk(const Bounds &bounds, const std::uint32_t &limit, const Visit &visit) const;

        /** \brief Makes the node of \e count boxes from \e first on, and those below it */
        std::uint32_t build(std::uint32_t first, std::uint32_t count);

        /** \brief The square of how far a coordinate is outside an interval */
        static double squaredOutside(double low, double high, double coordinate)
        {
            const double outside = std::max(std::max(low - coordinate, coordinate - high), 0.0);
            return outside * outside;
        }

        static double squaredDistance(const CellBox &box, const Eigen::Vector3d &point)
        {
            double squared = 0.0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                squared += squaredOutside(box.low[axis], box.high[axis], point[static_cast<Eigen::Index>(axis)]);
            return squared;
        }

        std::vector<Node> nodes_;
        std::vector<CellBox> boxes_;

        /** \brief The largest coordinate of a box */
        double extent_{0.0};
    };

    inline std::array<CellTree::Open, 4> CellTree::sortChildren(const Node &node, const FourInts &bounds)
    {
        FourInts children;
        std::memcpy(&children, node.child, sizeof(children));
        const FourInts absent = children == static_cast<std::int32_t>(NONE), first = bounds | absent,
                       second = children & ~absent;
        std::array<Open, 4> open;
        for (int k = 0; k < 4; ++k)
            open[static_cast<std::size_t>(k)] =
                static_cast<Open>(static_cast<std::uint32_t>(first[k])) << 32U | static_cast<std::uint32_t>(second[k]);
        for (const auto &[a, b] : {std::pair(0U, 1U), {2U, 3U}, {0U, 2U}, {1U, 3U}, {1U, 2U}})
        {
            // Exchanges them without a branch, if the second is less.
            const Open exchange = (open[a] ^ open[b]) & -static_cast<Open>(open[b] < open[a]);
            open[a] ^= exchange;
            open[b] ^= exchange;
        }
        return open;
    }

    template <typename Bounds, typename Visit>
    void CellTree::walk(const Bounds &bounds, const std::uint32_t &limit, const Visit &visit) const
    {
        if (nodes_.empty())
            return;
        // Which child comes first cannot be foreseen, and each branch that the processor guesses wrong costs as much as
        // a node. So children are sorted, and put on the stack, without branches.
        Open stack[STACK_SIZE];
        std::size_t open = 0;
        std::uint32_t current = 0;
        for (;;)
        {
            const Node &node = nodes_[current];
            const std::array<Open, 4> children = sortChildren(node, bounds(node));
            if (isLeaf(node.child[0]))
            {
                for (std::size_t i = 0; i < 4 && boundOf(children[i]) < limit; ++i)
                    if (visit(node, childOf(children[i]) - node.child[0], boundOf(children[i])))
                        return;
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

    template <typename Visit>
    void CellTree::visitByDistance(const Eigen::Vector3d &point, const double &lowest, const Visit &visit) const
    {
        if (!(point.cwiseAbs().array() < FARTHEST).all())
        {
            for (std::uint32_t i = 0; i < boxes_.size(); ++i)
                if (const double squared = squaredDistance(boxes_[i], point); squared < lowest)
                    visit(i, squared);
            return;
        }
        // In single precision the point is somewhere between these.
        const auto rounding = static_cast<float>(1.5e-7 * point.cwiseAbs().maxCoeff());
        const Eigen::Vector3f least = point.cast<float>().array() - rounding,
                              most = point.cast<float>().array() + rounding;
        const auto bounds = [&](const Node &node)
        {
            const FloatNode boxes(node);
            const FourFloats none{};
            FourFloats squared{};
            for (int axis = 0; axis < 3; ++axis)
            {
                const FourFloats below = boxes.low[axis] - most[axis], above = least[axis] - boxes.high[axis],
                                 farther = below > above ? below : above, outside = farther > none ? farther : none;
                squared += outside * outside;
            }
            return toBounds(squared * SHRINK);
        };
        std::uint32_t limit = toBound(lowest);
        walk(bounds, limit,
             [&](const Node &node, std::uint32_t k, std::uint32_t /*bound*/)
             {
                 if (const double squared = squaredDistance(node.getBox(k), point); squared < lowest)
                     visit(node.child[k] & ~LEAF, squared);
                 limit = toBound(lowest);
                 return false;
             });
    }

    template <typename Visit>
    void CellTree::visitNear(const Eigen::AlignedBox3d &bounds, const Pose &pose, double margin,
                             const Visit &visit) const
    {
        if (nodes_.empty())
            return;
        const TurnedBox turned(bounds, pose, extent_);
        const auto slack = static_cast<float>(margin) + turned.rounding;
        std::uint32_t stack[STACK_SIZE];
        std::size_t open = 0;
        stack[open++] = 0;
        while (open > 0)
        {
            const Node &node = nodes_[stack[--open]];
            int numbers[4];
            const int count = overlaps(FloatNode(node), turned.box, turned.turn, slack, numbers);
            for (int i = 0; i < count; ++i)
            {
                const auto k = static_cast<std::uint32_t>(numbers[i]);
                if (node.child[k] == NONE)
                    continue;
                if (!isLeaf(node.child[k]))
                    stack[open++] = node.child[k];
                else if (visit(node.child[k] & ~LEAF, node.getBox(k)))
                    return;
            }
        }
    }
}

#endif
