#ifndef OMPL_CERTIFICATES_OBSTACLES_PRIMITIVE_LIST_
#define OMPL_CERTIFICATES_OBSTACLES_PRIMITIVE_LIST_

#include "PlacedShape.h"

#include "geometry/BatchOverlap.h"
#include "geometry/ConvexCover.h"

#include "ompl_certificates/geometry/Ball.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ompl_certificates
{
    /** \brief The primitives among the obstacles, in blocks of such as are close together, and which of them are near a
        ball */
    class PrimitiveList
    {
    public:
        /** \brief A primitive and where it is */
        struct Primitive
        {
            /** \brief The shape */
            Shape shape;

            /** \brief From the workspace to the shape's frame */
            Pose toShape;

            /** \brief Its bounds and its cover, in that frame */
            Eigen::AlignedBox3d bounds;
            ConvexCover cover;
        };

        /** \brief The primitives among \e obstacles. Cost: n log² n for n of them. */
        explicit PrimitiveList(const PlacedShapes &obstacles);

        /** \brief The number of primitives */
        std::size_t size() const
        {
            return primitives_.size();
        }

        /** \brief The primitive at a position, from 0 to size() - 1 */
        const Primitive &operator[](std::size_t position) const
        {
            return primitives_[position];
        }

        /** \brief Call \e visit with the position of each primitive whose bounds \e ball touches, until it returns
            true. Cost: linear in the number of blocks, some nanoseconds each. */
        template <typename Visit>
        void visitNear(const Ball &ball, const Visit &visit) const
        {
            const double squared = ball.radius * ball.radius;
            for (std::size_t i = 0; i < blocks_.size(); ++i)
            {
                const Block &block = blocks_[i];
                if (block.all.squaredExteriorDistance(ball.center) > squared)
                    continue;
                double distances[BLOCK_SIZE] = {};
                for (std::size_t axis = 0; axis < 3; ++axis)
                {
                    const double center = ball.center[static_cast<Eigen::Index>(axis)];
                    for (std::size_t k = 0; k < BLOCK_SIZE; ++k)
                    {
                        const double outside =
                            std::max(std::max(block.low[axis][k] - center, center - block.high[axis][k]), 0.0);
                        distances[k] += outside * outside;
                    }
                }
                const std::size_t first = i * BLOCK_SIZE, count = std::min(BLOCK_SIZE, primitives_.size() - first);
                for (std::size_t k = 0; k < count; ++k)
                    if (!(distances[k] > squared) && visit(first + k))
                        return;
            }
        }

        /** \brief The states in which a body may be within \e margin of a primitive
            \param ball its bounding sphere
            \param box its box
            Cost: see FclObstacles::mayTouch() */
        BatchMask mayTouch(const Ball &ball, const BoxBatch &box, double margin) const;

    private:
        static constexpr std::size_t BLOCK_SIZE = 8;

        struct Block
        {
            Eigen::AlignedBox3d all;
            std::array<std::array<double, BLOCK_SIZE>, 3> low, high;

            /** \brief The same rounded outwards; absent ones are inside out and infinite. */
            alignas(32) float roundedLow[3][BLOCK_SIZE], roundedHigh[3][BLOCK_SIZE];
        };

        std::vector<Primitive> primitives_;
        std::vector<Block> blocks_;
    };
}

#endif
