// How the tree grows; its searches are in StateKdTreeSearch.cpp.

#include "ompl_certificates/neighbors/StateKdTree.h"

#include "ExactDistance.h"
#include "FlatMetric.h"
#include "StateKdTreeLeaf.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** The number of states at which a leaf is divided */
        constexpr std::uint32_t LEAF_SIZE = 64;

        /** The number in (low, high] that is a multiple of the largest power of two */
        float roundest(float low, float high)
        {
            for (int exponent = std::ilogb(std::max(std::abs(low), std::abs(high))) + 1;; --exponent)
            {
                const float step = std::ldexp(1.0F, exponent), cut = std::floor(high / step) * step;
                // Below the smallest step, every number is a multiple.
                if (step == 0.0F || !std::isfinite(cut))
                    return high;
                if (cut > low)
                    return cut;
            }
        }
    }

    StateKdTree::StateKdTree(const ob::StateSpace &space)
      : metric_(std::make_unique<const FlatMetric>(space))
      , rowSize_(metric_->getRowSize())
      , exactDistance_(std::make_unique<const ExactDistance>(space))
      , exact_(exactDistance_->isKnown())
    {
    }

    StateKdTree::~StateKdTree() = default;

    bool StateKdTree::isUseful() const
    {
        return metric_->getDimension() > 0;
    }

    void StateKdTree::clear()
    {
        nodes_.clear();
        boxes_.clear();
        leaves_.clear();
        slots_.clear();
        blocks_.clear();
        magnitude_ = 0.0;
    }

    double *StateKdTree::exactRow(std::size_t index) const
    {
        return blocks_[index / BLOCK_SIZE].get() + index % BLOCK_SIZE * exactDistance_->getSize();
    }

    double StateKdTree::distance(const ob::State *state, Index index) const
    {
        std::vector<double> exact(exactDistance_->getSize());
        exactDistance_->copy(state, exact.data());
        return (*exactDistance_)(exact.data(), exactRow(index));
    }

    float *StateKdTree::low(std::uint32_t node)
    {
        return boxes_.data() + std::size_t(2) * rowSize_ * node;
    }

    float *StateKdTree::high(std::uint32_t node)
    {
        return low(node) + rowSize_;
    }

    const float *StateKdTree::low(std::uint32_t node) const
    {
        return boxes_.data() + std::size_t(2) * rowSize_ * node;
    }

    const float *StateKdTree::high(std::uint32_t node) const
    {
        return low(node) + rowSize_;
    }

    std::uint32_t StateKdTree::addNode(Leaf *leaf)
    {
        nodes_.emplace_back().leaf = leaf;
        boxes_.resize(boxes_.size() + rowSize_, std::numeric_limits<float>::infinity());
        boxes_.resize(boxes_.size() + rowSize_, -std::numeric_limits<float>::infinity());
        return static_cast<std::uint32_t>(nodes_.size() - 1);
    }

    StateKdTree::Leaf *StateKdTree::addLeaf()
    {
        leaves_.push_back(std::make_unique<Leaf>());
        leaves_.back()->columns.setZero(LEAF_SIZE, metric_->getDimension());
        return leaves_.back().get();
    }

    void StateKdTree::extend(std::uint32_t node, const float *row)
    {
        float *a = low(node), *b = high(node);
        for (unsigned int i = 0; i < rowSize_; ++i)
        {
            a[i] = std::min(a[i], row[i]);
            b[i] = std::max(b[i], row[i]);
        }
    }

    void StateKdTree::put(Leaf &leaf, const float *row, Index index)
    {
        const auto position = static_cast<std::uint32_t>(leaf.indices.size());
        for (unsigned int d = 0; d < metric_->getDimension(); ++d)
            leaf.columns(position, d) = row[d];
        leaf.indices.push_back(index);
        slots_[index] = {&leaf, position};
    }

    float StateKdTree::chooseCut(const Leaf &leaf, std::uint32_t coordinate, float low, float high,
                                 unsigned int depth) const
    {
        // Halves are best, but states that come in order would make a list of them. Beyond the depth that mere
        // imbalance explains, cuts are at round numbers: on any path those get finer, and so are few.
        if (depth > 8 + 3 * std::log2(static_cast<double>(leaves_.size())))
            return roundest(low, high);
        const float *column = leaf.columns.col(coordinate).data();
        std::vector<float> values(column, column + leaf.indices.size());
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        if (*middle > low)
            return *middle;
        // At least half of the states are at the low end: a cut at the next value leaves them there.
        float next = high;
        for (const float value : values)
            if (value > low)
                next = std::min(next, value);
        return next;
    }

    bool StateKdTree::divide(std::uint32_t node, unsigned int depth)
    {
        Leaf *leaf = nodes_[node].leaf;
        const auto size = leaf->indices.size();
        std::uint32_t widest = 0;
        float extent = 0.0F, from = 0.0F, to = 0.0F;
        for (unsigned int d = 0; d < metric_->getDimension(); ++d)
        {
            const auto column = leaf->columns.col(d).head(static_cast<Eigen::Index>(size));
            const float a = column.minCoeff(), b = column.maxCoeff();
            if (metric_->extent(d, a, b) > extent)
            {
                extent = metric_->extent(d, a, b);
                widest = d;
                from = a;
                to = b;
            }
        }
        if (extent == 0.0F)
            return false;
        const float cut = chooseCut(*leaf, widest, from, to, depth);

        const auto old = std::move(*leaf);
        leaf->indices.clear();
        leaf->columns.setZero(LEAF_SIZE, metric_->getDimension());
        const auto left = addNode(leaf), right = addNode(addLeaf());
        nodes_[node] = {nullptr, left, widest, cut};
        std::vector<float> row(rowSize_, 0.0F);
        for (std::size_t i = 0; i < size; ++i)
        {
            for (unsigned int d = 0; d < metric_->getDimension(); ++d)
                row[d] = old.columns(static_cast<Eigen::Index>(i), d);
            const auto side = row[widest] < cut ? left : right;
            Leaf &to_leaf = *nodes_[side].leaf;
            // If a leaf is large for its equal states, all of them may stay on one side.
            if (to_leaf.indices.size() == static_cast<std::size_t>(to_leaf.columns.rows()))
                to_leaf.columns.conservativeResize(2 * to_leaf.columns.rows(), Eigen::NoChange);
            put(to_leaf, row.data(), old.indices[i]);
            extend(side, row.data());
        }
        return true;
    }

    bool StateKdTree::add(const ob::State *state)
    {
        std::vector<float> row(rowSize_);
        double magnitude = magnitude_;
        if (!metric_->flatten(state, row.data(), magnitude))
            return false;
        magnitude_ = magnitude;
        if (nodes_.empty())
            addNode(addLeaf());
        std::uint32_t node = 0;
        for (unsigned int depth = 0;; ++depth)
        {
            extend(node, row.data());
            if (Leaf *leaf = nodes_[node].leaf)
            {
                if (leaf->indices.size() < static_cast<std::size_t>(leaf->columns.rows()))
                    break;
                if (!divide(node, depth))
                {
                    leaf->columns.conservativeResize(2 * leaf->columns.rows(), Eigen::NoChange);
                    break;
                }
            }
            const Node &at = nodes_[node];
            node = at.child + (row[at.coordinate] < at.cut ? 0 : 1);
        }
        const auto index = static_cast<Index>(slots_.size());
        slots_.emplace_back();
        if (blocks_.size() * BLOCK_SIZE == index)
            blocks_.emplace_back(new double[BLOCK_SIZE * exactDistance_->getSize()]);
        exactDistance_->copy(state, exactRow(index));
        put(*nodes_[node].leaf, row.data(), index);
        return true;
    }

    void StateKdTree::remove(Index index)
    {
        const Slot slot = slots_[index];
        Leaf &leaf = *slot.leaf;
        const auto last = static_cast<std::uint32_t>(leaf.indices.size() - 1);
        leaf.columns.row(slot.position) = leaf.columns.row(last).eval();
        leaf.indices[slot.position] = leaf.indices[last];
        slots_[leaf.indices[slot.position]] = slot;
        leaf.indices.pop_back();
        // The last state's index
        const auto end = static_cast<Index>(slots_.size() - 1);
        if (index != end)
        {
            slots_[index] = slots_[end];
            slots_[index].leaf->indices[slots_[index].position] = index;
            std::copy_n(exactRow(end), exactDistance_->getSize(), exactRow(index));
        }
        slots_.pop_back();
    }

    StateKdTree::Index StateKdTree::find(const ob::State *state, const std::function<bool(Index)> &is) const
    {
        std::vector<float> row(rowSize_);
        double magnitude = 0.0;
        if (nodes_.empty() || !metric_->flatten(state, row.data(), magnitude))
            return NONE;
        const Node *node = nodes_.data();
        while (!node->leaf)
            node = nodes_.data() + node->child + (row[node->coordinate] < node->cut ? 0 : 1);
        for (const Index index : node->leaf->indices)
            if (is(index))
                return index;
        return NONE;
    }
}
