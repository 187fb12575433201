#ifndef OMPL_CERTIFICATES_GEOMETRY_TRIANGLE_TREE_
#define OMPL_CERTIFICATES_GEOMETRY_TRIANGLE_TREE_

#include "FacetRows.h"
#include "TriangleDistance.h"

#include "ompl_certificates/geometry/Pose.h"
#include "ompl_certificates/geometry/Touching.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace ompl_certificates
{
    class Shape;

    /** \brief A tree of boxes over triangles. It finds the triangle nearest to a point, and whether triangles cross
        others or touch primitives.

        Each node holds the boxes of four children, in single precision and rounded outwards. Triangles are tested in
        double precision. Uses about 190 bytes per triangle. Only add() and build() change the tree. */
    class TriangleTree
    {
    public:
        /** \brief The corners of a triangle */
        using Corners = std::array<Eigen::Vector3d, 3>;

        /** \brief A triangle and its unit normal, which is zero if it has no area */
        struct Facet
        {
            /** \brief Its corners */
            Corners corners;

            /** \brief Its unit normal; zero if its corners are on one line, but for rounding */
            Eigen::Vector3d normal;

            /** \brief The facet of these corners */
            explicit Facet(const Corners &c) : corners(c), normal((c[1] - c[0]).cross(c[2] - c[0]))
            {
                if (isThin(normal.squaredNorm(), c[1] - c[0], c[2] - c[1], c[0] - c[2]))
                    normal.setZero();
                else
                    normal.stableNormalize();
            }

            /** \brief The facet at another pose */
            Facet(const Facet &other, const Pose &pose)
              : corners{pose * other.corners[0], pose * other.corners[1], pose * other.corners[2]}
              , normal(pose.linear() * other.normal)
            {
            }
        };

        /** \brief Stands for no triangle */
        static constexpr std::uint32_t NONE = std::numeric_limits<std::uint32_t>::max();

        /** \brief Add a triangle; it may have no area. Call build() after the last.
            \param name the caller's number for it, not necessarily unique */
        void add(const Corners &corners, std::uint32_t name);

        /** \brief Build the tree. Reorders the triangles and drops duplicates. Cost: n log n for n triangles, some 0.1
            s for 10^5. */
        void build();

        /** \brief The distance of \e point to the nearest triangle, or \e limit if that is not larger. Cost:
            logarithmic in the number of triangles, unless many are about equally far.
            \param nearest if not null: the position of the nearest triangle, or NONE if \e limit is not larger */
        double distance(const Eigen::Vector3d &point, double limit, std::uint32_t *nearest = nullptr) const;

        /** \brief Whether \e triangle, in the frame of this tree, crosses one of the tree's. All must have an area. */
        Touching touches(const Facet &triangle, double margin) const;

        /** \brief Whether a triangle of \e other crosses one of this tree. All must have an area.
            \param pose from the frame of \e other to the frame of this tree
            \param hit if not null and the answer is YES: the position of the triangle of this tree */
        Touching touches(const TriangleTree &other, const Pose &pose, double margin,
                         std::uint32_t *hit = nullptr) const;

        /** \brief Whether a triangle touches \e primitive, which is solid and of space.
            \param pose from the frame of this tree to the frame of \e primitive
            \param hit if not null and the answer is YES: the position of the triangle */
        Touching touches(const Shape &primitive, const Pose &pose, double margin, std::uint32_t *hit = nullptr) const;

        /** \brief A triangle of this tree that is within a distance of one of \e other; see areWithin()
            \param pose from the frame of \e other to the frame of this tree
            \return its position, or NONE */
        std::uint32_t findWithin(const TriangleTree &other, const Pose &pose, double distance) const;

        /** \brief A triangle that is within a distance of \e primitive; see areWithin()
            \param pose from the frame of this tree to the frame of \e primitive
            \return its position, or NONE */
        std::uint32_t findWithin(const Shape &primitive, const Pose &pose, double distance) const;

        /** \brief Whether a triangle is within a distance of another one in this frame */
        bool isWithin(const Corners &corners, double distance) const;

        /** \brief The triangle at a position, from 0 to size() - 1 */
        const Facet &getTriangle(std::uint32_t position) const
        {
            return triangles_[position];
        }

        /** \brief A box along the axes that contains all triangles, slightly enlarged; empty if there are none */
        Eigen::AlignedBox3d getBounds() const;

        /** \brief The name that the caller gave the triangle at a position */
        std::uint32_t getName(std::uint32_t position) const
        {
            return names_[position];
        }

        /** \brief The number of triangles */
        std::size_t size() const
        {
            return triangles_.size();
        }

    private:
        friend class TriangleTreeBuilder;

        /** \brief Four boxes, relative to origin_. An absent box is inside out and infinite. Its child is a leaf of the
            first triangle: so a walk ends even where numbers that are not finite make all boxes overlap. */
        struct alignas(16) Node
        {
            float low[3][4];
            float high[3][4];
            std::uint32_t child[4];
        };

        /** A child is an inner node or a leaf. A leaf is the flag, the index of its first triangle, and their number
            less one. */
        static constexpr std::uint32_t LEAF = 0x80000000U;
        static constexpr unsigned int COUNT_BITS = 2;
        static constexpr std::uint32_t MOST_TRIANGLES = LEAF >> COUNT_BITS;

        static bool isLeaf(std::uint32_t child)
        {
            return (child & LEAF) != 0;
        }

        static std::uint32_t firstOf(std::uint32_t leaf)
        {
            return (leaf & ~LEAF) >> COUNT_BITS;
        }

        static std::uint32_t countOf(std::uint32_t leaf)
        {
            return (leaf & ((1U << COUNT_BITS) - 1)) + 1;
        }

        /** \brief Calls \e visit with the position of a triangle of this tree and one of \e other in its frame, for
            all that may be within \e margin of each other, until it returns true */
        template <typename Visit>
        void visitNear(const TriangleTree &other, const Pose &pose, double margin, const Visit &visit) const;

        /** \brief The same with the position of a triangle that may be within \e margin of a box
            \param pose from the frame of this tree to the frame of the box */
        template <typename Visit>
        void visitNear(const Eigen::AlignedBox3d &bounds, const Pose &pose, double margin, const Visit &visit) const;

        /** \brief The stack that a depth-first walk needs: three open children per level */
        static constexpr std::size_t STACK_SIZE = 256;

        Eigen::Vector3d origin_{Eigen::Vector3d::Zero()};

        /** \brief The largest coordinate of a corner, relative to origin_ */
        double extent_{0.0};

        /** \brief Half the sizes of the box of all triangles, whose middle is origin_ */
        Eigen::Vector3f half_{Eigen::Vector3f::Zero()};
        std::vector<Node> nodes_;
        std::vector<Facet> triangles_;
        FacetRows rows_;
        std::vector<std::uint32_t> names_;
    };
}

#endif
