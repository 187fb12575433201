// The searches of StateKdTree.

#include "ExactDistance.h"
#include "FlatMetric.h"
#include "StateKdTreeLeaf.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        constexpr double INFINITE = std::numeric_limits<double>::infinity();

        /** Up to this number of neighbors, a heap of the best is kept. */
        constexpr std::size_t MOST_IN_HEAP = 32;

        /** The number of states whose bounds are computed at a time; see FlatMetric::bounds() */
        constexpr std::size_t BATCH = 64;

        /** A node still to be searched, and the squared bound of its distance */
        struct Pending
        {
            std::uint32_t node;
            float square;
        };

        /** A state that was not ruled out: its squared bound, and its key. The key is its true distance if known, or
            else the squared bound again. */
        struct Candidate
        {
            float square;
            StateKdTree::Index index;
            double key;
        };

        /** Sort by distance, then by index. RRT* asks for hundreds or thousands of neighbors, whose distances are
            spread enough to go straight to about their positions. */
        void sortNeighbors(StateKdTree::Neighbors &neighbors)
        {
            constexpr std::size_t FEW = 64;
            const auto [first, last] = std::minmax_element(neighbors.begin(), neighbors.end());
            const std::size_t size = neighbors.size(), buckets = 2 * size;
            const double low = size > 0 ? first->first : 0.0, range = size > 0 ? last->first - low : 0.0;
            const double scale = static_cast<double>(buckets - 1) / range;
            if (size < FEW || !std::isfinite(scale) || !std::isfinite(range))
                return std::sort(neighbors.begin(), neighbors.end());
            thread_local StateKdTree::Neighbors other;
            thread_local std::vector<std::uint32_t> starts, bucketOf;
            starts.assign(buckets, 0);
            bucketOf.resize(size);
            other.resize(size);
            for (std::size_t i = 0; i < size; ++i)
            {
                bucketOf[i] = static_cast<std::uint32_t>((neighbors[i].first - low) * scale);
                ++starts[bucketOf[i]];
            }
            std::uint32_t sum = 0;
            for (auto &start : starts)
                sum += std::exchange(start, sum);
            for (std::size_t i = 0; i < size; ++i)
                other[starts[bucketOf[i]]++] = neighbors[i];
            neighbors.swap(other);
            // Each start has become its bucket's end.
            std::size_t begin = 0;
            for (const auto end : starts)
            {
                if (end - begin > 1)
                    std::sort(neighbors.begin() + static_cast<std::ptrdiff_t>(begin), neighbors.begin() + end);
                begin = end;
            }
        }

        /** A key that at least \e count of the candidates, and mostly few more, do not exceed. Their exact number does
            not matter yet. Unlike std::nth_element(), counting has no branches to predict. */
        double enoughFor(const std::vector<Candidate> &candidates, std::size_t count)
        {
            constexpr unsigned int ROUNDS = 6;
            double low = INFINITE, high = -INFINITE;
            for (const Candidate &candidate : candidates)
            {
                low = std::min(low, candidate.key);
                high = std::max(high, candidate.key);
            }
            std::size_t atLow = 0, atHigh = candidates.size();
            for (unsigned int round = 0; round < ROUNDS && atHigh > count + count / 8; ++round)
            {
                const std::size_t wanted = count + count / 16 - std::min(atLow, count);
                const double part = static_cast<double>(wanted) / static_cast<double>(atHigh - atLow);
                // Alternate between interpolation, as if keys were spread evenly, and bisection, since they are not.
                const double middle = low + (high - low) * (round % 2 == 0 ? std::min(part, 1.0) : 0.5);
                std::size_t below = 0;
                for (const Candidate &candidate : candidates)
                    below += candidate.key <= middle ? 1U : 0U;
                (below >= count ? high : low) = middle;
                (below >= count ? atHigh : atLow) = below;
            }
            return high;
        }

        /** The scratch memory of a query; kept for the thread's next one */
        struct Scratch
        {
            std::vector<float> row;
            std::vector<double> exact;
            std::vector<Pending> pending;
            std::vector<Candidate> candidates;
            std::vector<double> best;
        };
    }

    struct StateKdTree::Search
    {
        const Distance &distance;
        std::size_t count;
        double magnitude;
        float most;
        Scratch &scratch;
        /** At so many candidates, drop those that are ruled out by now. */
        std::size_t limit;
    };

    double StateKdTree::distanceOf(const Search &search, Index index) const
    {
        return exact_ ? (*exactDistance_)(search.scratch.exact.data(), exactRow(index)) : search.distance(index);
    }

    void StateKdTree::ruleOutBeyond(Search &search, double key) const
    {
        const double distance = metric_->isTight() ? metric_->largest(static_cast<float>(key), search.magnitude) : key;
        search.most = std::min(search.most, metric_->threshold(distance, search.magnitude));
    }

    void StateKdTree::compact(Search &search) const
    {
        auto &candidates = search.scratch.candidates;
        ruleOutBeyond(search, enoughFor(candidates, search.count));
        candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                        [&](const Candidate &candidate) { return !(candidate.square <= search.most); }),
                         candidates.end());
        search.limit = candidates.size() + search.count;
    }

    void StateKdTree::searchLeaf(Search &search, const Leaf &leaf) const
    {
        auto &candidates = search.scratch.candidates;
        auto &best = search.scratch.best;
        float squares[BATCH];
        const std::size_t size = leaf.indices.size();
        const auto stride = static_cast<std::size_t>(leaf.columns.rows());
        for (std::size_t first = 0; first < size; first += BATCH)
        {
            const std::size_t count = std::min(size - first, BATCH);
            const std::size_t rounded = (count + FlatMetric::BLOCK - 1) / FlatMetric::BLOCK * FlatMetric::BLOCK;
            if (!metric_->bounds(search.scratch.row.data(), leaf.columns.data() + first, stride, rounded, search.most,
                                 squares))
                continue;
            for (std::size_t i = 0; i < count; ++i)
            {
                if (!(squares[i] <= search.most))
                    continue;
                const Index index = leaf.indices[first + i];
                // Where bounds are nearly the distance, they select the neighbors without it.
                const double key = metric_->isTight() ? squares[i] : distanceOf(search, index);
                candidates.push_back({squares[i], index, key});
                // A heap of the best few is kept; a large one would cost more than it rules out.
                if (search.count > MOST_IN_HEAP)
                    continue;
                if (best.size() == search.count)
                {
                    if (!(key < best.front()))
                        continue;
                    std::pop_heap(best.begin(), best.end());
                    best.back() = key;
                }
                else
                    best.push_back(key);
                std::push_heap(best.begin(), best.end());
                if (best.size() == search.count)
                    ruleOutBeyond(search, best.front());
            }
        }
        if (search.count > MOST_IN_HEAP && candidates.size() >= search.limit)
            compact(search);
    }

    void StateKdTree::searchTree(Search &search) const
    {
        auto &pending = search.scratch.pending;
        const float *row = search.scratch.row.data();
        pending.assign(1, {0, 0.0F});
        while (!pending.empty())
        {
            Pending next = pending.back();
            pending.pop_back();
            while (next.square <= search.most)
            {
                const Node &node = nodes_[next.node];
                if (node.leaf)
                {
                    searchLeaf(search, *node.leaf);
                    break;
                }
                Pending far{node.child + 1, 0.0F};
                next.node = node.child;
                next.square = metric_->boxBound(row, low(next.node), high(next.node));
                far.square = metric_->boxBound(row, low(far.node), high(far.node));
                if (far.square < next.square)
                    std::swap(next, far);
                if (far.square <= search.most)
                    pending.push_back(far);
            }
        }
    }

    void StateKdTree::nearest(const ob::State *state, std::size_t count, double radius, const Distance &distance,
                              Neighbors &neighbors) const
    {
        neighbors.clear();
        count = std::min(count, size());
        if (count == 0 || std::isnan(radius))
            return;
        thread_local Scratch scratch;
        scratch.row.resize(rowSize_);
        scratch.candidates.clear();
        scratch.best.clear();
        double magnitude = magnitude_;
        if (!metric_->flatten(state, scratch.row.data(), magnitude))
        {
            // The metric knows nothing of distances from such a state.
            for (Index i = 0; i < size(); ++i)
                neighbors.emplace_back(distance(i), i);
        }
        else
        {
            scratch.exact.resize(exactDistance_->getSize());
            exactDistance_->copy(state, scratch.exact.data());
            // If all states may be neighbors, the radius alone decides: a limit above the size says so.
            Search search{distance,  count,
                          magnitude, metric_->threshold(radius, magnitude),
                          scratch,   count == size() ? size() + 1 : 2 * count};
            // A tree that can rule out few states is not worth its walk.
            if (exact_ && radius == INFINITE && 2 * count > size())
                for (Index i = 0; i < size(); ++i)
                    neighbors.emplace_back(distanceOf(search, i), i);
            else
                searchTree(search);
            for (const auto &candidate : scratch.candidates)
                if (candidate.square <= search.most)
                    neighbors.emplace_back(metric_->isTight() ? distanceOf(search, candidate.index) : candidate.key,
                                           candidate.index);
        }
        if (radius < INFINITE)
            neighbors.erase(std::remove_if(neighbors.begin(), neighbors.end(),
                                           [&](const auto &neighbor) { return !(neighbor.first <= radius); }),
                            neighbors.end());
        // A few too many are sorted faster than separated.
        if (2 * count < neighbors.size())
        {
            std::nth_element(neighbors.begin(), neighbors.begin() + static_cast<std::ptrdiff_t>(count),
                             neighbors.end());
            neighbors.resize(count);
        }
        sortNeighbors(neighbors);
        neighbors.resize(std::min(count, neighbors.size()));
    }
}
