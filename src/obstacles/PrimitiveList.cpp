#include "PrimitiveList.h"

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
                blocks_.emplace_back();
            Block &block = blocks_.back();
            block.all.extend(box);
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                block.low[axis][k] = box.min()[static_cast<Eigen::Index>(axis)];
                block.high[axis][k] = box.max()[static_cast<Eigen::Index>(axis)];
            }
        }
    }
}
