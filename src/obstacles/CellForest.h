#ifndef OMPL_CERTIFICATES_OBSTACLES_CELL_FOREST_
#define OMPL_CERTIFICATES_OBSTACLES_CELL_FOREST_

#include "CellTree.h"

#include "ompl_certificates/geometry/Shape.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace ompl_certificates
{
    /** \brief The shapes of boxes, which blocks share: each takes a kilobyte */
    struct BoxShapes
    {
        /** \brief The shapes by their sizes in cells */
        std::map<std::array<std::int32_t, 3>, Shape> bySize;
    };

    /** \brief Some boxes of cells, with their shapes. Never changes, so that forests may share it. */
    class CellBlock
    {
    public:
        /** \brief A block of \e boxes, which must not overlap; flat ones in the plane. Cost: n log n for n of them.
            \param shapes those that were made before; those of new sizes are added */
        CellBlock(double cellSize, std::vector<CellBox> boxes, unsigned int dimension, BoxShapes &shapes);

        /** \brief The boxes in a tree, in cells */
        const CellTree &getTree() const
        {
            return tree_;
        }

        /** \brief The shape of a box, about its center */
        const Shape &getShape(std::uint32_t box) const
        {
            return shapes_[shapeOfBox_[box]];
        }

        /** \brief The smallest box that contains all boxes; only if there are some */
        const CellBox &getBounds() const
        {
            return bounds_;
        }

        /** \brief The tolerance of FCL's checks of these boxes */
        double getTolerance() const
        {
            return tolerance_;
        }

    private:
        CellTree tree_;
        CellBox bounds_{};

        /** \brief The shapes, one for each size, and which of them each box has */
        std::vector<Shape> shapes_;
        std::vector<std::uint32_t> shapeOfBox_;
        double tolerance_;
    };

    /** \brief Blocks of cells, whose bounds do not overlap. Never changes. All lengths are in cells. */
    class CellForest
    {
    public:
        /** \brief A box of the forest */
        struct Place
        {
            const CellBlock *block;
            std::uint32_t box;

            const CellBox &getCells() const
            {
                return block->getTree().getBoxes()[box];
            }
        };

        /** \brief A forest of \e blocks, none of them empty unless it is the only one */
        explicit CellForest(std::vector<std::shared_ptr<const CellBlock>> blocks);

        /** \brief The number of boxes */
        std::uint32_t size() const
        {
            return first_.back();
        }

        /** \brief The box at a position less than size(). Cost: logarithmic in the number of blocks. */
        Place at(std::uint32_t position) const;

        /** \brief The largest tolerance of a block */
        double getTolerance() const;

        /** \brief The distance of \e point to the nearest box; \e most, which is positive, if none is nearer. Within a
            box, minus the distance to its surface.
            \param nearest set to the position of the nearest box, or to CellTree::NONE */
        double signedDistance(const Eigen::Vector3d &point, std::uint32_t &nearest,
                              double most = std::numeric_limits<double>::infinity()) const;

        /** \brief See CellTree::gap() */
        double gap(const Eigen::AlignedBox3d &bounds, const Pose &pose, double needed, double wanted) const;

        /** \brief Call \e visit with each box that is near a turned box, and with some others, until it returns
            true: with its place, its position and the box; see CellTree::visitNear() */
        template <typename Visit>
        void visitNear(const Eigen::AlignedBox3d &bounds, const Pose &pose, double margin, const Visit &visit) const
        {
            const auto visitBlock = [&](std::uint32_t block)
            {
                bool isDone = false;
                blocks_[block]->getTree().visitNear(
                    bounds, pose, margin,
                    [&](std::uint32_t box, const CellBox &cells) {
                        return isDone = visit(Place{blocks_[block].get(), box}, first_[block] + box, cells);
                    });
                return isDone;
            };
            if (blocks_.size() == 1)
                visitBlock(0);
            else
                places_.visitNear(bounds, pose, margin,
                                  [&](std::uint32_t place, const CellBox &)
                                  { return visitBlock(blockOfPlace_[place]); });
        }

    private:
        std::vector<std::shared_ptr<const CellBlock>> blocks_;
        /** \brief The position of each block's first box, and the number of boxes */
        std::vector<std::uint32_t> first_;
        /** \brief The bounds of the blocks, and which block has each of them */
        CellTree places_;
        std::vector<std::uint32_t> blockOfPlace_;
    };
}

#endif
