#include "CellForest.h"

#include "FclTolerance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ompl/util/Exception.h>
#include <string>
#include <unordered_map>
#include <utility>

namespace ompl_certificates
{
    CellBlock::CellBlock(double cellSize, std::vector<CellBox> boxes, unsigned int dimension, BoxShapes &shapes)
      : tree_(std::move(boxes))
    {
        std::map<std::array<std::int32_t, 3>, std::uint32_t> own;
        shapeOfBox_.reserve(tree_.getBoxes().size());
        Eigen::Vector3d farthest = Eigen::Vector3d::Zero();
        if (!tree_.getBoxes().empty())
            bounds_ = tree_.getBoxes().front();
        for (const auto &[low, high] : tree_.getBoxes())
        {
            const std::array<std::int32_t, 3> cells{high[0] - low[0], high[1] - low[1], high[2] - low[2]};
            const auto [entry, isNew] = own.emplace(cells, static_cast<std::uint32_t>(shapes_.size()));
            if (isNew)
            {
                const Eigen::Vector3d size = cellSize * Eigen::Vector3d(cells[0], cells[1], cells[2]);
                auto known = shapes.bySize.find(cells);
                if (known == shapes.bySize.end())
                    known = shapes.bySize
                                .emplace(cells, dimension == 2 ? Shape::box(Eigen::Vector2d(size.head<2>()))
                                                               : Shape::box(size))
                                .first;
                shapes_.push_back(known->second);
            }
            shapeOfBox_.push_back(entry->second);
            const Eigen::Vector3d center =
                0.5 * cellSize * Eigen::Vector3d(low[0] + high[0], low[1] + high[1], low[2] + high[2]);
            if (center.norm() > farthest.norm())
                farthest = center;
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                bounds_.low[axis] = std::min(bounds_.low[axis], low[axis]);
                bounds_.high[axis] = std::max(bounds_.high[axis], high[axis]);
            }
        }
        PlacedShapes placed;
        for (const Shape &shape : shapes_)
            placed.push_back({shape, poseAt(farthest)});
        tolerance_ = fclTolerance(placed, 0.0);
    }

    CellForest::CellForest(std::vector<std::shared_ptr<const CellBlock>> blocks)
      : blocks_(std::move(blocks))
      , places_(
            [this]
            {
                std::vector<CellBox> bounds;
                for (const auto &block : blocks_)
                    if (!block->getTree().getBoxes().empty())
                        bounds.push_back(block->getBounds());
                return bounds;
            }())
    {
        // std::map would take most of the time of a change where there are many blocks.
        const auto hashOf = [](const std::array<std::int32_t, 3> &cell)
        {
            std::uint64_t hash = 0;
            for (const std::int32_t index : cell)
                hash = (hash ^ static_cast<std::uint32_t>(index)) * 0x9E3779B97F4A7C15ULL;
            return static_cast<std::size_t>(hash ^ (hash >> 32U));
        };
        std::unordered_map<std::array<std::int32_t, 3>, std::uint32_t, decltype(hashOf)> blockAt(2 * blocks_.size(),
                                                                                                 hashOf);
        std::uint32_t first = 0;
        for (std::uint32_t i = 0; i < blocks_.size(); ++i)
        {
            blockAt[blocks_[i]->getBounds().low] = i;
            first_.push_back(first);
            first += static_cast<std::uint32_t>(blocks_[i]->getTree().getBoxes().size());
        }
        first_.push_back(first);
        for (const CellBox &place : places_.getBoxes())
            blockOfPlace_.push_back(blockAt.at(place.low));
    }

    CellForest::Place CellForest::at(std::uint32_t position) const
    {
        if (position >= first_.back())
            throw ompl::Exception("There is no cell " + std::to_string(position) + " of " +
                                  std::to_string(first_.back()));
        const auto next = std::upper_bound(first_.begin(), first_.end(), position);
        const auto block = static_cast<std::size_t>(next - first_.begin()) - 1;
        return {blocks_[block].get(), position - first_[block]};
    }

    double CellForest::getTolerance() const
    {
        double tolerance = fclTolerance({}, 0.0);
        for (const auto &block : blocks_)
            tolerance = std::max(tolerance, block->getTolerance());
        return tolerance;
    }

    double CellForest::signedDistance(const Eigen::Vector3d &point, std::uint32_t &nearest, double most) const
    {
        double lowest = most * most;
        Place found{nullptr, CellTree::NONE};
        nearest = CellTree::NONE;
        const auto visitBlock = [&](std::uint32_t block)
        {
            const std::uint32_t box = blocks_[block]->getTree().findNearest(point, lowest);
            if (box == CellTree::NONE)
                return;
            found = {blocks_[block].get(), box};
            nearest = first_[block] + box;
        };
        if (blocks_.size() == 1)
            visitBlock(0);
        else
            places_.visitByDistance(point, lowest,
                                    [&](std::uint32_t place, double) { visitBlock(blockOfPlace_[place]); });
        if (!found.block)
            return most;
        // The boxes do not overlap: within one, no other is nearer.
        return lowest == 0.0 ? found.block->getTree().depth(found.box, point) : std::sqrt(lowest);
    }

    double CellForest::gap(const Eigen::AlignedBox3d &bounds, const Pose &pose, double needed, double wanted) const
    {
        if (blocks_.size() == 1)
            return blocks_.front()->getTree().gap(bounds, pose, needed, wanted);
        double least = wanted;
        places_.visitNear(bounds, pose, wanted,
                          [&](std::uint32_t place, const CellBox &)
                          {
                              const CellBlock &block = *blocks_[blockOfPlace_[place]];
                              least = block.getTree().gap(bounds, pose, needed, least);
                              return least <= needed;
                          });
        return least;
    }
}
