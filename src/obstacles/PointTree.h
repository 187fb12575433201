#ifndef OMPL_CERTIFICATES_OBSTACLES_POINT_TREE_
#define OMPL_CERTIFICATES_OBSTACLES_POINT_TREE_

#include "ompl_certificates/geometry/Pose.h"

#include "geometry/BoxOverlap.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    /** \brief A tree of boxes over points with radii. It finds the ball nearest to a point, and the balls near a body.

        Each node holds the boxes of four children, in single precision and rounded outwards. A leaf is up to 16
        points that stand in a row, in double precision. Uses about 30 bytes per point, and 8 more if radii differ.

        Where points that are all equal would fill a node, one leaf of them stands for it. The others are spare: their
        radii are not larger, and no search finds them. */
    class PointTree
    {
    public:
        /** \brief Stands for no point */
        static constexpr std::uint32_t NONE = std::numeric_limits<std::uint32_t>::max();

        /** \brief A tree over \e points, which it reorders. Cost: n log n for n points.
            \param radii one for all points, or one for each */
        PointTree(std::vector<Eigen::Vector3d> points, std::vector<double> radii);

        /** \brief Tells for each leaf which of its points count: the i-th does if the i-th bit is set. Null if all
            count. Spare points may count only while all points of the leaf that stands for them do. */
        using Mask = const std::uint16_t *;

        /** \brief The least distance of \e point to a ball, negative inside; \e most if none is nearer
            \param nearest if not null: set to the position of that ball, or to NONE */
        double signedDistance(const Eigen::Vector3d &point, std::uint32_t *nearest,
                              double most = std::numeric_limits<double>::infinity(), Mask mask = nullptr) const;

        /** \brief A mask by which all points count */
        std::vector<std::uint16_t> makeMask() const
        {
            return std::vector<std::uint16_t>((points_.size() + LEAF_SIZE - 1) / LEAF_SIZE, EVERY_POINT);
        }

        /** \brief The leaf and the bit of a position in a mask */
        static std::uint32_t leafOf(std::uint32_t position)
        {
            return position / LEAF_SIZE;
        }

        static std::uint16_t bitOf(std::uint32_t position)
        {
            return static_cast<std::uint16_t>(1U << position % LEAF_SIZE);
        }

        /** \brief Whether a point counts */
        static bool counts(Mask mask, std::uint32_t position)
        {
            return !mask || (mask[leafOf(position)] & bitOf(position)) != 0;
        }

        /** \brief Call \e visit with the position of each ball that may touch \e box, until it returns true
            \param pose from the frame of \e box to the workspace
            \return the position where it did, or NONE */
        template <typename Visit>
        std::uint32_t findNear(const Eigen::AlignedBox3d &box, const Pose &pose, const Visit &visit) const;

        /** \brief The positions of the spare points for which the leaf of a position stands: the first one, and that
            behind the last. Cost: logarithmic. */
        std::pair<std::uint32_t, std::uint32_t> findSpare(std::uint32_t position) const;

        /** \brief The points, in the order of their positions */
        const std::vector<Eigen::Vector3d> &getPoints() const
        {
            return points_;
        }

        /** \brief The radius of the ball at a position */
        double getRadius(std::uint32_t position) const
        {
            return radii_.size() == 1 ? radii_.front() : radii_[position];
        }

        /** \brief The box of all points; empty if there are none */
        const Eigen::AlignedBox3d &getBox() const
        {
            return box_;
        }

        /** \brief The largest distance of a ball's point from the origin of the workspace, or more */
        double getExtent() const
        {
            return points_.empty() ? 0.0 : box_.min().cwiseAbs().cwiseMax(box_.max().cwiseAbs()).norm();
        }

    private:
        static constexpr std::uint32_t LEAF_SIZE = 16;

        static constexpr std::uint16_t EVERY_POINT = 0xFFFF;

        /** \brief More than the rounding of coordinates in single precision, relative to the largest */
        static constexpr double ROUNDING = 1e-6;

        /** \brief Four boxes around points, relative to origin_, and their largest radii. A box is larger by the rounding
            of its largest coordinate, so that searches need to add only that of their own. An absent box is inside out
            and infinite. */
        struct alignas(64) Node
        {
            Eigen::Array4f low[3];
            Eigen::Array4f high[3];
            Eigen::Array4f radius;
            std::uint32_t child[4];
        };

        /** A child is an inner node, or with this flag a leaf: the position of its first point divided by LEAF_SIZE. */
        static constexpr std::uint32_t LEAF = 0x80000000U;

        /** \brief The stack that a depth-first walk needs: three open children per level */
        static constexpr std::size_t STACK_SIZE = 64;

        struct Bounds
        {
            Eigen::AlignedBox3f box;
            float radius{0.0F};
        };

        /** \brief The leaves from \e first to \e last as a child of a node */
        Bounds addChild(std::uint32_t first, std::uint32_t last, std::uint32_t &child);
        Bounds addNode(std::uint32_t first, std::uint32_t last, std::uint32_t &index);
        Bounds leafBounds(std::uint32_t leaf) const;

        std::uint32_t endOf(std::uint32_t leaf) const
        {
            return std::min(static_cast<std::uint32_t>(points_.size()), (leaf + 1) * LEAF_SIZE);
        }

        void prefetch(std::uint32_t child) const;

        /** \brief The least distance of \e point to a ball of a leaf */
        double leafDistance(std::uint32_t leaf, const Eigen::Vector3d &point, Mask mask) const;

        /** \brief The leaf of the ball nearest to \e point, or NONE if none is nearer than \e least
            \param least set to the distance of that ball */
        std::uint32_t findNearestLeaf(const Eigen::Vector3d &point, double &least, Mask mask) const;

        /** \brief Amid most points: coordinates relative to it are small, and rounded little, even if a few points are
            very far away */
        Eigen::Vector3d origin_{Eigen::Vector3d::Zero()};
        Eigen::AlignedBox3d box_;
        float largestRadius_{0.0F};
        std::vector<Eigen::Vector3d> points_;
        std::vector<double> radii_;
        std::vector<Node> nodes_;

        /** \brief The leaves of spare points: the first ones of a row, and those behind the last. Before each row is the
            leaf that searches find. */
        std::vector<std::pair<std::uint32_t, std::uint32_t>> spare_;
    };

    template <typename Visit>
    std::uint32_t PointTree::findNear(const Eigen::AlignedBox3d &box, const Pose &pose, const Visit &visit) const
    {
        if (nodes_.empty())
            return NONE;
        const FloatBox floatBox(box);
        const Eigen::Vector3d shift = pose.translation() - origin_;
        const BoxTurn turn(pose.linear(), shift);
        const auto rounding =
            static_cast<float>(ROUNDING * (largestRadius_ + shift.norm() + box.center().norm() + box.sizes().norm()));
        std::uint32_t stack[STACK_SIZE];
        std::size_t open = 0;
        stack[open++] = 0;
        while (open > 0)
        {
            const std::uint32_t current = stack[--open];
            if ((current & LEAF) != 0)
            {
                const std::uint32_t leaf = current & ~LEAF;
                for (std::uint32_t i = leaf * LEAF_SIZE; i < endOf(leaf); ++i)
                    if (visit(i))
                        return i;
                continue;
            }
            const Node &node = nodes_[current];
            int numbers[4];
            // The radii of the node alone: elsewhere there may be a much larger ball.
            const int count = overlaps(node, floatBox, turn, fourFloats(node.radius) + rounding, numbers);
            for (int i = 0; i < count; ++i)
                stack[open++] = node.child[numbers[i]];
        }
        return NONE;
    }
}

#endif
