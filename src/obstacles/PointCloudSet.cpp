#include "ompl_certificates/obstacles/PointCloudSet.h"

#include "PointForest.h"

#include "ompl_certificates/obstacles/PointCloudObstacles.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <ompl/util/Exception.h>
#include <sstream>
#include <utility>

namespace ompl_certificates
{
    namespace
    {
        /** How often each point is in a list, which must stay as it is: a hash table. To sort the points of a frame
            takes several times longer. */
        class PointCounts
        {
        public:
            explicit PointCounts(const std::vector<Eigen::Vector3d> &points) : points_(points), counts_(points.size())
            {
                std::size_t size = 2;
                while (size < 2 * points.size())
                    size *= 2;
                slots_.resize(size);
                for (std::size_t i = 0; i < points.size(); ++i)
                {
                    const std::uint64_t hash = hashOf(points[i]);
                    Slot &slot = find(points[i], hash);
                    if (slot.point == NONE)
                        slot = {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(hash)};
                    ++counts_[slot.point];
                }
            }

            /** Counts a point once less, if it is still counted
                \return whether it was */
            bool take(const Eigen::Vector3d &point)
            {
                const Slot &slot = find(point, hashOf(point));
                if (slot.point == NONE || counts_[slot.point] == 0)
                    return false;
                --counts_[slot.point];
                return true;
            }

        private:
            static constexpr std::uint32_t NONE = std::numeric_limits<std::uint32_t>::max();

            /** The first of equal points. Half of the hash spares most looks at other points. */
            struct Slot
            {
                std::uint32_t point{NONE}, hash{0};
            };

            static std::uint64_t hashOf(const Eigen::Vector3d &point)
            {
                std::uint64_t hash = 0;
                for (const double coordinate : point)
                {
                    hash = (hash ^ std::hash<double>()(coordinate)) * 0x9E3779B97F4A7C15ULL;
                    hash ^= hash >> 32;
                }
                return hash;
            }

            /** The slot of a point, or the empty one that it would get */
            Slot &find(const Eigen::Vector3d &point, std::uint64_t hash)
            {
                const std::size_t last = slots_.size() - 1;
                std::size_t i = (hash >> 20) & last;
                while (slots_[i].point != NONE &&
                       (slots_[i].hash != static_cast<std::uint32_t>(hash) || points_[slots_[i].point] != point))
                    i = (i + 1) & last;
                return slots_[i];
            }

            const std::vector<Eigen::Vector3d> &points_;
            std::vector<std::uint32_t> counts_;
            std::vector<Slot> slots_;
        };

        /** Whether two lists have points in common, as far as some points of the second tell. Of a frame with noise
            none is in the one before, and a table of them all takes a large part of the change. */
        bool mayShare(const std::vector<Eigen::Vector3d> &first, const std::vector<Eigen::Vector3d> &second)
        {
            constexpr std::size_t some = 256;
            if (second.size() < 8 * some)
                return true;
            std::vector<Eigen::Vector3d> sample;
            for (std::size_t i = 0; i < some; ++i)
                sample.push_back(second[i * second.size() / some]);
            PointCounts counts(sample);
            return std::any_of(first.begin(), first.end(),
                               [&counts](const Eigen::Vector3d &point) { return counts.take(point); });
        }

        /** Takes out what is in both, each point as often as it is. Where few of many points are in both, they may stay
            there: what comes and goes at once is asked about anew, which costs time alone. */
        void dropEqual(std::vector<Eigen::Vector3d> &first, std::vector<Eigen::Vector3d> &second)
        {
            if (first.empty() || second.empty() || !mayShare(first, second))
                return;
            PointCounts counts(first);
            std::vector<Eigen::Vector3d> ofFirst, ofSecond;
            ofSecond.reserve(second.size());
            for (const Eigen::Vector3d &point : second)
                if (!counts.take(point))
                    ofSecond.push_back(point);
            // What is still counted is in the first alone.
            if (ofSecond.size() == second.size())
                return;
            for (const Eigen::Vector3d &point : first)
                if (counts.take(point))
                    ofFirst.push_back(point);
            first = std::move(ofFirst);
            second = std::move(ofSecond);
        }
    }

    /** Points in a tree that obstacles may share. The mask is copied before it changes if obstacles share it. */
    struct PointCloudSet::Layer
    {
        explicit Layer(std::shared_ptr<const PointTree> points)
          : tree(std::move(points))
          , mask(std::make_shared<std::vector<std::uint16_t>>(tree->makeMask()))
          , count(tree->getPoints().size())
        {
        }

        bool has(std::uint32_t position) const
        {
            return PointTree::counts(mask->data(), position);
        }

        void setPresent(std::uint32_t position, bool present)
        {
            if (isShared)
                mask = std::make_shared<std::vector<std::uint16_t>>(*mask);
            isShared = false;
            std::uint16_t &leaf = (*mask)[PointTree::leafOf(position)];
            leaf = static_cast<std::uint16_t>(leaf ^ PointTree::bitOf(position));
            count += present ? 1 : std::size_t(-1);
        }

        /** Of the points equal to one that searches find and that is there, the one to go first: the last spare one
            that is there, for searches do not find it without the others */
        std::uint32_t lastEqualTo(std::uint32_t position) const
        {
            auto [low, high] = tree->findSpare(position);
            const std::uint32_t first = low;
            while (low < high)
            {
                const std::uint32_t middle = low + (high - low) / 2;
                if (has(middle))
                    low = middle + 1;
                else
                    high = middle;
            }
            return low > first ? low - 1 : position;
        }

        void appendTo(std::vector<Eigen::Vector3d> &points) const
        {
            for (std::uint32_t i = 0; i < tree->getPoints().size(); ++i)
                if (has(i))
                    points.push_back(tree->getPoints()[i]);
        }

        std::shared_ptr<const PointTree> tree;
        std::shared_ptr<std::vector<std::uint16_t>> mask;
        /** How many points are there */
        std::size_t count;
        bool isShared{false};
    };

    PointCloudSet::PointCloudSet(double radius, unsigned int dimension) : radius_(radius), dimension_(dimension)
    {
        requirePoints({}, {radius}, dimension);
    }

    PointCloudSet::~PointCloudSet() = default;
    PointCloudSet::PointCloudSet(PointCloudSet &&) noexcept = default;
    PointCloudSet &PointCloudSet::operator=(PointCloudSet &&) noexcept = default;

    std::size_t PointCloudSet::size() const
    {
        std::size_t count = 0;
        for (const Layer &layer : layers_)
            count += layer.count;
        return count;
    }

    void PointCloudSet::insert(std::vector<Eigen::Vector3d> points)
    {
        requirePoints(points, {radius_}, dimension_);
        inserted_.insert(inserted_.end(), points.begin(), points.end());
        add(std::move(points));
    }

    void PointCloudSet::add(std::vector<Eigen::Vector3d> points)
    {
        while (!layers_.empty() && layers_.back().count < 2 * points.size())
        {
            layers_.back().appendTo(points);
            layers_.pop_back();
        }
        if (!points.empty())
            layers_.emplace_back(std::make_shared<const PointTree>(std::move(points), std::vector<double>{radius_}));
    }

    void PointCloudSet::tidy()
    {
        std::vector<Eigen::Vector3d> moved;
        std::vector<Layer> kept;
        for (Layer &layer : layers_)
            if (2 * layer.count < layer.tree->getPoints().size())
                layer.appendTo(moved);
            else
                kept.push_back(std::move(layer));
        std::stable_sort(kept.begin(), kept.end(), [](const Layer &a, const Layer &b) { return a.count > b.count; });
        layers_ = std::move(kept);
        add(std::move(moved));
    }

    void PointCloudSet::remove(const std::vector<Eigen::Vector3d> &points)
    {
        std::vector<std::pair<Layer *, std::uint32_t>> found;
        const auto take = [&](const Eigen::Vector3d &point)
        {
            for (Layer &layer : layers_)
            {
                const auto isIt = [&](std::uint32_t i) { return layer.has(i) && layer.tree->getPoints()[i] == point; };
                const std::uint32_t i = layer.tree->findNear({point, point}, Pose::Identity(), isIt);
                if (i == PointTree::NONE)
                    continue;
                found.emplace_back(&layer, layer.lastEqualTo(i));
                layer.setPresent(found.back().second, false);
                return true;
            }
            return false;
        };
        for (const Eigen::Vector3d &point : points)
            if (!point.allFinite() || !take(point))
            {
                for (const auto &[layer, position] : found)
                    layer->setPresent(position, true);
                std::ostringstream message;
                message << "There is no point at " << point.head(dimension_).transpose() << " to be removed";
                throw ompl::Exception(message.str());
            }
        removed_.insert(removed_.end(), points.begin(), points.end());
        tidy();
    }

    std::size_t PointCloudSet::removeWithin(const Eigen::AlignedBox3d &wanted)
    {
        if (wanted.min().hasNaN() || wanted.max().hasNaN())
            throw ompl::Exception("The box whose points are to be removed has corners that are no numbers");
        Eigen::AlignedBox3d box;
        for (const Layer &layer : layers_)
            box.extend(layer.tree->getBox());
        box.clamp(wanted);
        if (box.isEmpty())
            return 0;
        const std::size_t before = removed_.size();
        for (Layer &layer : layers_)
        {
            const auto take = [&](std::uint32_t i)
            {
                layer.setPresent(i, false);
                removed_.push_back(layer.tree->getPoints()[i]);
            };
            const auto visit = [&](std::uint32_t i)
            {
                if (!layer.has(i) || !box.contains(layer.tree->getPoints()[i]))
                    return false;
                const auto [first, last] = layer.tree->findSpare(i);
                for (std::uint32_t spare = first; spare < last && layer.has(spare); ++spare)
                    take(spare);
                take(i);
                return false;
            };
            layer.tree->findNear(box, Pose::Identity(), visit);
        }
        tidy();
        return removed_.size() - before;
    }

    ObstacleChange PointCloudSet::takeChange()
    {
        if (after_ && inserted_.empty() && removed_.empty())
            return {after_, nullptr, nullptr, {}, after_};
        std::vector<PointForest::Layer> layers;
        for (Layer &layer : layers_)
        {
            const bool isWhole = layer.count == layer.tree->getPoints().size();
            layer.isShared = layer.isShared || !isWhole;
            layers.push_back({layer.tree, isWhole ? nullptr : layer.mask, layer.count});
        }
        dropEqual(inserted_, removed_);
        const auto obstaclesOf = [this](std::vector<Eigen::Vector3d> points) -> ObstaclesPtr {
            return std::make_shared<PointCloudObstacles>(PointCloud{std::move(points), radius_}, dimension_);
        };
        ObstacleChange change;
        change.after.reset(
            new PointCloudObstacles(std::make_unique<const PointForest>(std::move(layers)), radius_, dimension_));
        change.before = after_ ? after_ : obstaclesOf({});
        // Of a frame that replaces all of the one before, both are there already.
        const std::size_t before = size() - inserted_.size() + removed_.size();
        if (!inserted_.empty())
            change.added = inserted_.size() == size() ? change.after : obstaclesOf(std::move(inserted_));
        if (!removed_.empty())
            change.removed = removed_.size() == before ? change.before : obstaclesOf(std::move(removed_));
        inserted_.clear();
        removed_.clear();
        after_ = change.after;
        return change;
    }
}
