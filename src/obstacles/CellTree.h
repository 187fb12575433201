#ifndef OMPL_CERTIFICATES_OBSTACLES_CELL_TREE_
#define OMPL_CERTIFICATES_OBSTACLES_CELL_TREE_

#include "ompl_certificates/geometry/Pose.h"
#include "ompl_certificates/obstacles/CellBox.h"

#include "geometry/BoxOverlap.h"

#include <limits>
#include <vector>

namespace ompl_certificates
{
    /** \brief A tree over boxes of cells that do not overlap. All lengths are in cells.

        Each node holds the boxes of four children, which are tested in single precision. Uses about 45 bytes per box. */
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

        /** \brief The distance of \e point to the nearest box; infinite if there is none. Within a box, minus the
            distance to its surface. A flat box has its surface in its plane. Cost: logarithmic in the number of boxes,
            unless many are about equally far.
            \param nearest set to the position of the nearest box, or to NONE */
        double signedDistance(const Eigen::Vector3d &point, std::uint32_t &nearest) const;

        /** \brief Call \e visit with the position of each box that is nearer to a turned box than \e margin, and of
            some others, until it returns true
            \param bounds the turned box, in its own frame
            \param pose from that frame to the tree's */
        template <typename Visit>
        void visitNear(const Eigen::AlignedBox3d &bounds, const Pose &pose, double margin, const Visit &visit) const
        {
            if (nodes_.empty())
                return;
            const FloatBox box{bounds.center().cast<float>(), (0.5 * bounds.sizes()).cast<float>()};
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

        /** Three open children for each of at most 16 levels */
        static constexpr std::size_t STACK_SIZE = 64;

        /** A child is a node, or a box with this flag. */
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

        /** \brief Makes the node of \e count boxes from \e first on, and those below it */
        std::uint32_t build(std::uint32_t first, std::uint32_t count);

        /** \brief Minus the distance of a point within a box to its surface */
        double depth(std::uint32_t box, const Eigen::Vector3d &point) const;

        /** \brief The nearest box, and its squared distance; looks at all of them */
        std::uint32_t searchAll(const Eigen::Vector3d &point, double &lowest) const;

        std::uint32_t search(const Eigen::Vector3d &point, double &lowest) const;

        std::vector<Node> nodes_;
        std::vector<CellBox> boxes_;

        /** \brief The largest coordinate of a box */
        double extent_{0.0};
    };
}

#endif
