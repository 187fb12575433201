#include "PrimitiveList.h"

#include "geometry/EightNumbers.h"
#include "geometry/Infinity.h"
#include "geometry/WideRegisters.h"

#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        struct Bounded
        {
            const PlacedShape *placed;
            Eigen::AlignedBox3d box;
        };

        /** Orders the primitives from \e begin to \e end so that those of a block are close together */
        void order(std::vector<Bounded>::iterator begin, std::vector<Bounded>::iterator end, std::ptrdiff_t blockSize)
        {
            const std::ptrdiff_t blocks = (end - begin + blockSize - 1) / blockSize;
            if (blocks < 2)
                return;
            Eigen::AlignedBox3d centers;
            for (auto i = begin; i != end; ++i)
                centers.extend(i->box.center());
            Eigen::Index axis;
            centers.sizes().maxCoeff(&axis);
            const auto middle = begin + blocks / 2 * blockSize;
            std::nth_element(begin, middle, end,
                             [axis](const Bounded &a, const Bounded &b)
                             { return a.box.center()[axis] < b.box.center()[axis]; });
            order(begin, middle, blockSize);
            order(middle, end, blockSize);
        }

        float roundedDown(double number)
        {
            return std::nextafter(static_cast<float>(number), -FLOAT_INF);
        }

        /** The primitives of a block, a bit for each, whose bounds touch the box from \e low to \e high */
        template <typename Block>
        inline unsigned int findTouching(const Block &block, const float *low, const float *high)
        {
            EightFlags apart{};
            for (int axis = 0; axis < 3; ++axis)
                apart |= (eight(block.roundedLow[axis]) > high[axis]) | (eight(block.roundedHigh[axis]) < low[axis]);
            return maskOf(~apart);
        }
    }

    PrimitiveList::PrimitiveList(const PlacedShapes &obstacles)
    {
        std::vector<Bounded> bounded;
        for (const PlacedShape &placed : obstacles)
            if (!placed.shape.getMesh())
                bounded.push_back({&placed, placed.shape.getBounds().transformed(placed.pose)});
        order(bounded.begin(), bounded.end(), BLOCK_SIZE);
        for (std::size_t i = 0; i < bounded.size(); ++i)
        {
            const auto &[placed, box] = bounded[i];
            primitives_.push_back({placed->shape, placed->pose.inverse(), placed->shape.getBounds(),
                                   ConvexCover(placed->shape, Pose::Identity())});
            const std::size_t k = i % BLOCK_SIZE;
            if (k == 0)
            {
                blocks_.emplace_back();
                for (std::size_t axis = 0; axis < 3; ++axis)
                {
                    std::fill_n(blocks_.back().roundedLow[axis], BLOCK_SIZE, FLOAT_INF);
                    std::fill_n(blocks_.back().roundedHigh[axis], BLOCK_SIZE, -FLOAT_INF);
                }
            }
            Block &block = blocks_.back();
            block.all.extend(box);
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                block.low[axis][k] = box.min()[static_cast<Eigen::Index>(axis)];
                block.high[axis][k] = box.max()[static_cast<Eigen::Index>(axis)];
                block.roundedLow[axis][k] = roundedDown(block.low[axis][k]);
                block.roundedHigh[axis][k] = -roundedDown(-block.high[axis][k]);
            }
        }
    }

    OMPL_CERTIFICATES_WIDE_WHOLE
    BatchMask PrimitiveList::mayTouch(const Ball &ball, const BoxBatch &box, double margin) const
    {
        PointBatch centers;
        const double rounding = placePoint(box.poses, ball.center, centers);
        const float radius = -roundedDown(-(ball.radius + margin + box.error.at(ball.center.norm()) + rounding));
        // What no primitive touches around the balls of all states needs no look at each of them.
        float low[3], high[3];
        for (int axis = 0; axis < 3; ++axis)
        {
            const auto &all = centers.at[axis];
            low[axis] = *std::min_element(all, all + PoseBatch::SIZE) - radius;
            high[axis] = *std::max_element(all, all + PoseBatch::SIZE) + radius;
        }
        unsigned int found = notFinite(centers);
        for (std::size_t i = 0; i < blocks_.size(); ++i)
        {
            const Block &block = blocks_[i];
            for (unsigned int near = findTouching(block, low, high), k = 0; near != 0; near >>= 1U, ++k)
            {
                if ((near & 1U) == 0)
                    continue;
                EightFloats squared{};
                for (int axis = 0; axis < 3; ++axis)
                {
                    const EightFloats below = block.roundedLow[axis][k] - eight(centers.at[axis]),
                                      above = eight(centers.at[axis]) - block.roundedHigh[axis][k];
                    EightFloats outside = below > above ? below : above;
                    outside = outside < 0.0F ? EightFloats{} : outside;
                    squared += outside * outside;
                }
                constexpr float cushion = 1.0F + 1e-6F;
                const unsigned int touching = maskOf(~(squared > radius * radius * cushion));
                if ((touching & ~found) == 0)
                    continue;
                const Primitive &primitive = primitives_[i * BLOCK_SIZE + k];
                found |= touching & mayOverlap(primitive.bounds, primitive.toShape, box, margin);
            }
        }
        return static_cast<BatchMask>(found);
    }
}
