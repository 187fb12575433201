#include "TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::uint32_t LEAF_SIZE = 4;
        constexpr std::size_t BINS = 16;

        /** Below this depth triangles are halved by number, which ends after at most 28 more levels. */
        constexpr unsigned int DEEPEST_BY_COST = 40;

        using Box = Eigen::AlignedBox3f;

        float areaOf(const Box &box)
        {
            const Eigen::Vector3f sizes = box.sizes();
            return sizes.x() * sizes.y() + sizes.y() * sizes.z() + sizes.z() * sizes.x();
        }

        struct Item
        {
            Box box;
            std::uint32_t triangle;

            float middle(Eigen::Index axis) const
            {
                return box.min()[axis] + box.max()[axis];
            }
        };

        struct Range
        {
            std::uint32_t first;
            std::uint32_t count;
            Box box;
            unsigned int depth;
        };
    }

    /** \brief Builds a TriangleTree from the top. Cuts a range of triangles where the areas of the halves' boxes times
        their numbers have the smallest sum. Each node takes the four largest ranges of what it is cut into. */
    class TriangleTreeBuilder
    {
    public:
        explicit TriangleTreeBuilder(TriangleTree &tree) : tree_(tree)
        {
        }

        void build()
        {
            dropTwins();
            Eigen::AlignedBox3d bounds;
            for (const auto &triangle : tree_.triangles_)
                for (const auto &corner : triangle.corners)
                    bounds.extend(corner);
            tree_.origin_ = bounds.center();
            tree_.extent_ = 0.5 * bounds.sizes().maxCoeff();
            // More than the rounding of the boxes and of any point near them
            const float slack = static_cast<float>(tree_.extent_ * 4e-7);
            tree_.half_ = (0.5 * bounds.sizes()).cast<float>().array() + slack;
            items_.reserve(tree_.triangles_.size());
            for (std::uint32_t i = 0; i < tree_.triangles_.size(); ++i)
            {
                Box box;
                for (const auto &corner : tree_.triangles_[i].corners)
                    box.extend((corner - tree_.origin_).cast<float>());
                box.min().array() -= slack;
                box.max().array() += slack;
                items_.push_back({box, i});
            }
            addNode({0, static_cast<std::uint32_t>(items_.size()), boxOf(0, items_.size()), 0});
            std::vector<TriangleTree::Facet> triangles;
            std::vector<std::uint32_t> names;
            triangles.reserve(items_.size());
            names.reserve(items_.size());
            for (const Item &item : items_)
            {
                triangles.push_back(tree_.triangles_[item.triangle]);
                names.push_back(tree_.names_[item.triangle]);
            }
            tree_.triangles_ = std::move(triangles);
            for (const auto &[corners, normal] : tree_.triangles_)
                tree_.rows_.add({corners[0] - tree_.origin_, corners[1] - tree_.origin_, corners[2] - tree_.origin_},
                                normal);
            tree_.rows_.finish();
            tree_.names_ = std::move(names);
        }

    private:
        /** Drop all but the first of triangles with equal corners: some programs write meshes with two-sided faces. */
        void dropTwins()
        {
            struct Key
            {
                std::uint64_t hash;
                std::uint32_t triangle;
            };
            const auto hashOf = [](const Eigen::Vector3d &corner)
            {
                std::uint64_t hash = 0;
                for (const double coordinate : corner)
                    hash = (hash ^ std::hash<double>()(coordinate)) * 0x9E3779B97F4A7C15ULL;
                return hash ^ hash >> 32;
            };
            std::vector<Key> keys;
            keys.reserve(tree_.triangles_.size());
            for (std::uint32_t i = 0; i < tree_.triangles_.size(); ++i)
            {
                const auto &[a, b, c] = tree_.triangles_[i].corners;
                keys.push_back({hashOf(a) + hashOf(b) + hashOf(c), i});
            }
            std::sort(keys.begin(), keys.end(),
                      [](const Key &a, const Key &b)
                      { return a.hash != b.hash ? a.hash < b.hash : a.triangle < b.triangle; });
            const auto sorted = [this](std::uint32_t triangle)
            {
                TriangleTree::Corners corners = tree_.triangles_[triangle].corners;
                std::sort(corners.begin(), corners.end(),
                          [](const Eigen::Vector3d &a, const Eigen::Vector3d &b)
                          { return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3); });
                return corners;
            };
            std::vector<bool> isTwin(tree_.triangles_.size(), false);
            for (std::size_t i = 1; i < keys.size(); ++i)
                isTwin[keys[i].triangle] =
                    keys[i].hash == keys[i - 1].hash && sorted(keys[i].triangle) == sorted(keys[i - 1].triangle);
            std::size_t kept = 0;
            for (std::size_t i = 0; i < isTwin.size(); ++i)
                if (!isTwin[i])
                {
                    tree_.triangles_[kept] = tree_.triangles_[i];
                    tree_.names_[kept++] = tree_.names_[i];
                }
            tree_.triangles_.resize(kept, tree_.triangles_.front());
            tree_.names_.resize(kept);
        }

        Box boxOf(std::size_t first, std::size_t count) const
        {
            Box box;
            for (std::size_t i = first; i < first + count; ++i)
                box.extend(items_[i].box);
            return box;
        }

        /** Order the items of a range so that the first \e return value ones are one half of it. */
        std::uint32_t cut(const Range &range)
        {
            const auto begin = items_.begin() + range.first, end = begin + range.count;
            Box middles;
            for (auto item = begin; item != end; ++item)
                middles.extend(Eigen::Vector3f(item->middle(0), item->middle(1), item->middle(2)));
            Eigen::Index axis;
            const float width = middles.sizes().maxCoeff(&axis), low = middles.min()[axis];
            const float scale = static_cast<float>(BINS) / width;
            if (!(width > 0.0F) || !std::isfinite(scale))
                return range.count / 2;
            if (range.count <= 4 || range.depth > DEEPEST_BY_COST)
            {
                std::nth_element(begin, begin + range.count / 2, end,
                                 [axis](const Item &a, const Item &b) { return a.middle(axis) < b.middle(axis); });
                return range.count / 2;
            }
            const auto binOf = [=](const Item &item)
            { return std::min(BINS - 1, static_cast<std::size_t>((item.middle(axis) - low) * scale)); };
            Box boxes[BINS];
            std::uint32_t counts[BINS] = {};
            for (auto item = begin; item != end; ++item)
            {
                const std::size_t bin = binOf(*item);
                boxes[bin].extend(item->box);
                ++counts[bin];
            }
            float rightCosts[BINS];
            Box right;
            for (std::size_t i = BINS, number = 0; i-- > 1;)
            {
                right.extend(boxes[i]);
                number += counts[i];
                rightCosts[i] = number > 0 ? areaOf(right) * static_cast<float>(number) : 0.0F;
            }
            Box left;
            std::size_t best = 0, number = 0;
            float lowest = std::numeric_limits<float>::infinity();
            for (std::size_t i = 0; i + 1 < BINS; ++i)
            {
                left.extend(boxes[i]);
                number += counts[i];
                if (number == 0 || number == range.count)
                    continue;
                if (const float cost = areaOf(left) * static_cast<float>(number) + rightCosts[i + 1]; cost < lowest)
                {
                    lowest = cost;
                    best = i;
                }
            }
            const auto middle = std::partition(begin, end, [&](const Item &item) { return binOf(item) <= best; });
            const auto count = static_cast<std::uint32_t>(middle - begin);
            return count == 0 || count == range.count ? range.count / 2 : count;
        }

        std::uint32_t addNode(const Range &whole)
        {
            const auto index = static_cast<std::uint32_t>(tree_.nodes_.size());
            tree_.nodes_.emplace_back();
            std::vector<Range> ranges{whole};
            while (ranges.size() < 4)
            {
                const auto area = [](const Range &range)
                { return range.count > LEAF_SIZE ? areaOf(range.box) : -1.0F; };
                const auto largest = std::max_element(
                    ranges.begin(), ranges.end(), [&](const Range &a, const Range &b) { return area(a) < area(b); });
                if (largest->count <= LEAF_SIZE)
                    break;
                const Range range = *largest;
                const std::uint32_t count = cut(range);
                *largest = {range.first, count, boxOf(range.first, count), range.depth + 1};
                ranges.push_back({range.first + count, range.count - count,
                                  boxOf(range.first + count, range.count - count), range.depth + 1});
            }
            for (std::size_t k = 0; k < 4; ++k)
            {
                const bool there = k < ranges.size();
                for (Eigen::Index axis = 0; axis < 3; ++axis)
                {
                    constexpr float far = std::numeric_limits<float>::infinity();
                    tree_.nodes_[index].low[axis][k] = there ? ranges[k].box.min()[axis] : far;
                    tree_.nodes_[index].high[axis][k] = there ? ranges[k].box.max()[axis] : -far;
                }
                std::uint32_t child = TriangleTree::LEAF;
                if (there && ranges[k].count <= LEAF_SIZE)
                    child = TriangleTree::LEAF | ranges[k].first << TriangleTree::COUNT_BITS | (ranges[k].count - 1);
                else if (there)
                    child = addNode(ranges[k]);
                tree_.nodes_[index].child[k] = child;
            }
            return index;
        }

        TriangleTree &tree_;
        std::vector<Item> items_;
    };

    void TriangleTree::build()
    {
        nodes_.clear();
        if (triangles_.size() >= MOST_TRIANGLES)
            throw ompl::Exception("A tree takes fewer than " + std::to_string(MOST_TRIANGLES) + " triangles");
        if (!triangles_.empty())
            TriangleTreeBuilder(*this).build();
    }
}
